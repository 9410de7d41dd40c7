#include "io/file_guard.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "io/placement_graph.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr int kDeepest = 256;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Takes the text up to the next line's beginning.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Takes the next word of a line, empty at its end.
std::string_view take_word(std::string_view& line) {
  while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
  std::size_t end = 0;
  while (end < line.size() && !is_space(line[end])) ++end;
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

std::optional<std::uint64_t> whole_number(std::string_view word) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Every thing that a file counts takes at least a byte of it.
void check_count(std::uint64_t count, std::string_view content, const char* what) {
  if (count <= content.size()) return;
  throw InputError(fmt::format("it announces {} {} but has only {} bytes; mend or export it again", count,
                               what, content.size()));
}

void check_text(const std::string& ending, std::string_view content) {
  if (content.starts_with("\xfe\xff") || content.starts_with("\xff\xfe")) {
    throw InputError("it is UTF-16 text; save it as UTF-8");
  }
  if (content.substr(0, 256).find('\0') != std::string_view::npos) {
    throw InputError(fmt::format("it is not text, as {} files are; export it again", ending));
  }
}

void guard_ply(std::string_view content) {
  for (std::string_view rest = content; !rest.empty();) {
    std::string_view line = take_line(rest);
    if (line == "end_header") return;
    if (take_word(line) != "element") continue;
    take_word(line);
    check_count(whole_number(take_word(line)).value_or(0), content, "elements");
  }
  throw InputError("its header has no end; mend or export it again");
}

/// The next line that is neither empty nor a comment.
std::string_view take_off_line(std::string_view& rest) {
  while (!rest.empty()) {
    std::string_view line = take_line(rest), copy = line;
    const std::string_view word = take_word(copy);
    if (!word.empty() && word.front() != '#') return line;
  }
  return {};
}

/// Also checks the faces' indices: the library puts its last vertex in the place of one that is not there.
void guard_off(std::string_view content) {
  std::string_view rest = content, counts = take_off_line(rest), behind = counts;
  if (take_word(behind).ends_with("OFF")) counts = behind;  // the keyword stands alone or before the counts
  if (take_word(behind).empty()) counts = take_off_line(rest);
  const auto vertices = whole_number(take_word(counts)), faces = whole_number(take_word(counts));
  if (!vertices || !faces)
    throw InputError("its header does not count vertices and faces; mend or export it again");
  check_count(*vertices, content, "vertices");
  check_count(*faces, content, "faces");
  for (std::uint64_t v = 0; v < *vertices; ++v) take_off_line(rest);
  for (std::uint64_t f = 0; f < *faces; ++f) {
    std::string_view line = take_off_line(rest);
    const auto corners = whole_number(take_word(line));
    for (std::uint64_t k = 0; corners && k < *corners; ++k) {
      const auto index = whole_number(take_word(line));
      if (index && *index < *vertices) continue;
      throw InputError(fmt::format("its face {} does not name {} of the {} vertices; mend or export it again",
                                   f + 1, *corners, *vertices));
    }
    if (!corners) throw InputError(fmt::format("its face {} is missing; mend or export it again", f + 1));
  }
}

/// How deep brackets are nested, outside of quotes.
void check_nesting(std::string_view text, std::string_view open, std::string_view close) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      for (++i; i < text.size() && text[i] != '"'; ++i) i += text[i] == '\\';
      continue;
    }
    if (open.find(text[i]) != std::string_view::npos) ++depth;
    if (close.find(text[i]) != std::string_view::npos) --depth;
    if (depth > kDeepest)
      throw InputError(fmt::format("it is nested more than {} deep; flatten the scene", kDeepest));
  }
}

using Json = nlohmann::json;

/// Nodes by index (glTF 2) or by name (glTF 1).
PlacementGraph gltf_graph(const Json& nodes) {
  std::map<std::string, std::size_t> number;
  for (const auto& [key, node] : nodes.items()) number.emplace(key, number.size());
  PlacementGraph graph;
  graph.placed_by.resize(number.size());
  for (const auto& [key, node] : nodes.items()) {
    if (!node.is_object() || !node.contains("children") || !node["children"].is_array()) continue;
    for (const Json& child : node["children"]) {
      const auto found = number.find(child.is_string() ? child.get<std::string>() : child.dump());
      if (found != number.end()) graph.placed_by[number[key]].push_back(found->second);
    }
  }
  return graph;
}

void guard_gltf(std::string_view text) {
  check_nesting(text, "[{", "]}");
  const Json document = Json::parse(text, nullptr, false);
  if (!document.is_object()) throw InputError("its JSON is damaged; mend or export it again");
  if (document.contains("nodes")) gltf_graph(document["nodes"]).check();
}

void guard_glb(std::string_view content) {
  // Header of 12 bytes, then the JSON chunk: its length, its type, itself. glTF 1 has the length at the same
  // place.
  if (content.size() < 20 || !content.starts_with("glTF"))
    throw InputError("it is no binary glTF; export it again");
  std::uint32_t length = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    length |= static_cast<std::uint32_t>(static_cast<unsigned char>(content[12 + k])) << (8 * k);
  }
  if (length > content.size() - 20) throw InputError("it is cut off; export it again");
  guard_gltf(content.substr(20, length));
}

std::string attribute(std::string_view tag, std::string_view name) {
  for (const char quote : {'"', '\''}) {
    const std::string opening = fmt::format(" {}={}", name, quote);
    const std::size_t at = tag.find(opening);
    if (at == std::string_view::npos) continue;
    const std::string_view rest = tag.substr(at + opening.size());
    return std::string(rest.substr(0, rest.find(quote)));
  }
  return "";
}

/// Walks a COLLADA file's tags.
class ColladaGuard {
 public:
  void walk(std::string_view text) {
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
      const std::size_t end = text.find('>', at);
      if (end == std::string_view::npos) break;
      const std::string_view tag = text.substr(at + 1, end - at - 1);
      if (tag.empty() || tag.front() == '?' || tag.front() == '!') continue;
      if (tag.front() == '/')
        close();
      else
        open(tag, text.substr(end + 1));
    }
    graph_.check();
  }

 private:
  void open(std::string_view tag, std::string_view behind) {
    std::string_view rest = tag;
    const std::string_view name = take_word(rest);
    if (name == "p" || name == "v" || name == "vcount" || name == "h") check_whole_numbers(behind);
    const bool single = tag.ends_with('/');
    std::size_t part = open_.empty() ? kNoPart : open_.back();
    if (name == "node" || name == "visual_scene") {
      const std::size_t parent = part;
      part = part_named(attribute(tag, "id"));
      if (parent != kNoPart) graph_.placed_by[parent].push_back(part);
    }
    const std::string url = attribute(tag, "url");
    if (name == "instance_node" && part != kNoPart && url.starts_with('#')) {
      const std::size_t placed = part_named(url.substr(1));
      graph_.placed_by[part].push_back(placed);
    }
    if (!single) open_.push_back(part);
    if (open_.size() > kDeepest) {
      throw InputError(fmt::format("it is nested more than {} deep; flatten the scene", kDeepest));
    }
  }

  void close() {
    if (!open_.empty()) open_.pop_back();
  }

  static void check_whole_numbers(std::string_view behind) {
    for (const char c : behind.substr(0, behind.find('<'))) {
      if (is_digit(c) || is_space(c) || c == '-' || c == '+') continue;
      throw InputError(
          "its lists of indices hold something else than whole numbers; mend or export it again");
    }
  }

  std::size_t part_named(const std::string& id) {
    if (!id.empty()) {
      const auto [known, is_new] = parts_.try_emplace(id, graph_.placed_by.size());
      if (!is_new) return known->second;
    }
    graph_.placed_by.emplace_back();
    return graph_.placed_by.size() - 1;
  }

  static constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);
  std::vector<std::size_t> open_;  ///< for every open tag the part that it is in
  std::map<std::string, std::size_t> parts_;
  PlacementGraph graph_;
};

/// Whole numbers that end a statement are counts or indices.
void guard_x(std::string_view content) {
  if (content.substr(8, 4) != "txt ") throw InputError("it is a binary or packed x file; export it as text");
  check_nesting(content, "{", "}");
  for (std::size_t at = content.find(';'); at != std::string_view::npos; at = content.find(';', at + 1)) {
    std::size_t begin = at;
    while (begin > 0 && is_digit(content[begin - 1])) --begin;
    if (begin < at && (begin == 0 || content[begin - 1] != '.')) {
      check_count(whole_number(content.substr(begin, at - begin)).value_or(UINT64_MAX), content, "entries");
    }
  }
}

}  // namespace

void guard_file(const std::string& ending, std::string_view content) {
  if (ending == "obj" || ending == "off" || ending == "dae" || ending == "gltf" || ending == "x") {
    check_text(ending, content);
  }
  if (ending == "ply") guard_ply(content);
  if (ending == "off") guard_off(content);
  if (ending == "gltf") guard_gltf(content);
  if (ending == "glb") guard_glb(content);
  if (ending == "dae") ColladaGuard().walk(content);
  if (ending == "x") guard_x(content);
}

}  // namespace preshape
