#include "preshape/io/page.h"

#include <array>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/io/grasp_scene.h"
#include "preshape/io/membership_svg.h"
#include "preshape/io/report_json.h"

namespace preshape {

namespace {

/// What stands in the template where a run's own text goes, in this order.
constexpr std::array<std::string_view, 5> kPlaces = {"<!--preshape:title-->", "<!--preshape:sets-->",
                                                     "<!--preshape:report-->", "<!--preshape:set-names-->",
                                                     "<!--preshape:scene-->"};

/// No text in a page may end the element that it stands in.
std::string without_tags(std::string text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "\\u003c" : std::string(1, c);
  return safe;
}

std::string html_text(std::string_view words) {
  std::string text;
  for (const char c : words) text += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return text;
}

/// RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      three = three << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kLetters[three >> (18 - 6 * k) & 63];
  }
  return text;
}

/// The family of the run, over its own universe; none where that is no interval of a finite width.
std::string sets_drawing(const FuzzyPartition& partition) {
  const Interval universe = span_of(partition);
  if (!(universe.width() > 0)) return "";
  return membership_svg(partition, findings_of(partition, universe), "Fuzzy sets of tasks and wrenches");
}

}  // namespace

std::string read_page_template(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  const std::string page = text.str();
  if (!stream) throw InputError(fmt::format("the page template '{}' cannot be read", file.string()));
  std::size_t at = 0;
  for (const auto place : kPlaces) {
    at = page.find(place, at);
    if (at == std::string::npos)
      throw InputError(
          fmt::format("the page template '{}' lacks '{}'; build it again", file.string(), place));
  }
  return page;
}

std::string page_html(std::string_view page, const RunRecord& record, std::string_view glb) {
  Value::List names;
  for (const Membership& set : record.partition.sets()) names.emplace_back(set.name);
  const std::array<std::string, 5> contents = {
      html_text(grasp_scene(record).title), sets_drawing(record.partition), without_tags(report_json(record)),
      without_tags(value_json(Value::list(std::move(names)))), base64(glb)};
  std::string html;
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const auto at = page.find(kPlaces[i]);
    html += page.substr(0, at);
    html += contents[i];
    page.remove_prefix(at + kPlaces[i].size());
  }
  return html += page;
}

}  // namespace preshape
