// What `preshape plugins` says of components to machines (JSON) and on pages (Markdown).
#include "component_pages.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "preshape/base/error.h"
#include "preshape/io/report_json.h"
#include "preshape/plugin/capabilities.h"

namespace preshape::app {

namespace {

using Json = nlohmann::ordered_json;

struct KindText {
  std::string_view kind, question, key, header;
};
/// In the order of kKinds.
constexpr KindText kKindTexts[] = {
    {"contact", "what a contact transmits: unit wrenches, pattern wrench, limits", "contact", "contact/contact_model.h"},
    {"similarity", "how near a wrench is to a task", "similarity, tie_break", "fuzzy/similarity.h"},
    {"classifier", "which preshape code belongs to given features", "classifier", "grasp/classifier.h"},
    {"collision", "where rays meet a mesh, and how far solids are from it and each other", "collision", "geometry/collision.h"},
    {"hand", "fingers, joints, limits, solids; forward kinematics and Jacobian", "hand", "hand/hand_model.h"},
    {"quality", "numbers for a virtual grasp", "quality", "grasp/quality.h"},
    {"explorer", "which station serves a task best", "explorer, proof", "grasp/explorer.h"},
    {"simulator", "how a hand carries a virtual grasp out", "", "grasp/simulator.h"},
};
static_assert(std::size(kKindTexts) == kKinds.size());

/// A number as JSON; null when there is none.
Json bound(double value) { return std::isfinite(value) ? Json::parse(value_json(Value(value))) : Json(); }

Json parameter_json(const ParameterDeclaration& d) {
  return {{"name", d.name},
          {"type", parameter_type_name(d.type)},
          {"default", Json::parse(value_json(d.default_value))},
          {"minimum", bound(d.minimum)},
          {"maximum", bound(d.maximum)},
          {"choices", d.choices},
          {"bounds", d.bounds_text()},
          {"unit", d.unit},
          {"text", d.text}};
}

Json library_json(const LibraryRecord& library) {
  static constexpr const char* kStatus[] = {"usable", "refused", "shadowed"};
  const Manifest& m = library.manifest;
  Json components = Json::array();
  for (const auto& key : library.components()) components.push_back(key.kind + "/" + key.name);
  return {{"file", library.file.string()},
          {"found_in", library.origin},
          {"status", kStatus[static_cast<int>(library.status)]},
          {"reasons", library.reasons},
          {"language", library.language},
          {"name", std::string(m.name)},
          {"version", std::string(m.version)},
          {"components", components}};
}

/// Text as it stands in a cell of a Markdown table.
std::string cell(std::string text) {
  for (auto at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, 1, '\\');
  return text;
}

std::string default_text(const Value& value) {
  if (value.is_nil()) return "must be given";
  if (value.is_number()) return number_text(value.number());
  return value.is_string() ? value.string() : value.text();
}

std::string_view promise_of(std::string_view kind, std::string_view name) {
  for (const Capability& c : capabilities()) {
    if (c.name == name && (c.kind.empty() || c.kind == kind)) return c.promise;
  }
  return "not known to this preshape";
}

}  // namespace

nlohmann::ordered_json component_json(const ComponentRecord& record) {
  Json parameters = Json::array();
  for (const auto& d : record.schema.declarations()) parameters.push_back(parameter_json(d));
  return {{"kind", record.kind},       {"name", record.name},     {"summary", record.summary}, {"capabilities", record.capabilities},
          {"parameters", parameters},  {"file", record.file.string()}, {"plugin", record.plugin}, {"version", record.version},
          {"language", record.language}, {"licence", record.licence}, {"author", record.author}};
}

nlohmann::ordered_json listing_json(const Registry& registry) {
  Json components = Json::array(), unusable = Json::array(), libraries = Json::array();
  for (const auto& key : registry.components()) {
    try {
      components.push_back(component_json(registry.describe(key.kind, key.name)));
    } catch (const PluginError& problem) {
      unusable.push_back({{"kind", key.kind}, {"name", key.name}, {"reason", problem.what()}});
    }
  }
  for (const auto& library : registry.libraries()) libraries.push_back(library_json(library));
  return {{"schema", "preshape-plugins/1"}, {"components", components}, {"unusable", unusable}, {"libraries", libraries}};
}

std::string component_markdown(const ComponentRecord& record) {
  std::string page = fmt::format("### {} `{}`\n\n{}. Version {}, {}, by {}.\n\n", record.kind, record.name, record.summary,
                                 record.version, record.licence, record.author);
  if (!record.capabilities.empty()) {
    page += "It promises:\n\n";
    for (const auto& name : record.capabilities) page += fmt::format("- `{}`: {}\n", name, promise_of(record.kind, name));
    page += "\n";
  }
  if (record.schema.declarations().empty()) return page + "It has no parameters.\n\n";
  page += "| name | unit | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const auto& d : record.schema.declarations()) {
    page += fmt::format("| {} | {} | {} | {} | {} |\n", d.name, d.unit, cell(d.bounds_text()), cell(default_text(d.default_value)), cell(d.text));
  }
  return page + "\n";
}

std::string reference_markdown(const Registry& registry) {
  std::string page =
      "# Reference of the components\n\n"
      "Written by `preshape plugins --markdown` from what the components declare. A person's own are added to such a page with\n"
      "`preshape --plugin-path FOLDER plugins --markdown`. How to write one: [plugin-authors.md](plugin-authors.md).\n\n"
      "## Kinds\n\n| kind | what it answers | key of a scenario | interface |\n|---|---|---|---|\n";
  for (const auto& k : kKindTexts) page += fmt::format("| {} | {} | {} | `preshape/{}` |\n", k.kind, k.question, k.key.empty() ? "-" : k.key, k.header);
  std::string kind;
  for (const auto& key : registry.components()) {
    try {
      const std::string section = component_markdown(registry.describe(key.kind, key.name));
      if (key.kind != kind) page += fmt::format("\n## {}{}\n\n", static_cast<char>(key.kind[0] - 'a' + 'A'), key.kind.substr(1));
      else page += "\n";
      kind = key.kind;
      page += section.substr(0, section.size() - 1);
    } catch (const PluginError&) {
      // Refused when it was loaded; `preshape plugins` says why.
    }
  }
  return page;
}

}  // namespace preshape::app
