#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/io/report_json.h"
#include "preshape/io/table.h"

namespace preshape::app {

namespace {

struct PluginOptions {
  std::string name;
  bool json = false, why = false;
};

nlohmann::ordered_json component_json(const ComponentRecord& record) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  for (const auto& d : record.schema.declarations()) {
    parameters.push_back({{"name", d.name}, {"type", parameter_type_name(d.type)}, {"default", nlohmann::ordered_json::parse(value_json(d.default_value))},
                          {"bounds", d.bounds_text()}, {"unit", d.unit}, {"text", d.text}});
  }
  return {{"kind", record.kind}, {"name", record.name}, {"summary", record.summary}, {"capabilities", record.capabilities},
          {"parameters", parameters}, {"language", record.language}, {"file", record.file.string()}, {"plugin", record.plugin}, {"version", record.version},
          {"licence", record.licence}, {"author", record.author}};
}

void list(const Registry& registry, bool json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  Table table;
  table.columns = {"kind", "name", "version", "in", "summary"};
  for (const auto& key : registry.components()) {
    try {
      const ComponentRecord& record = registry.describe(key.kind, key.name);
      all.push_back(component_json(record));
      table.rows.push_back({record.kind, record.name, record.version, record.language, record.summary});
    } catch (const PluginError& problem) {
      table.rows.push_back({key.kind, key.name, "-", "-", std::string("cannot be used: ") + problem.what()});
    }
  }
  if (json) {
    fmt::print("{}\n", all.dump(2));
    return;
  }
  fmt::print("{}", table_text(table));
  for (const auto& library : registry.libraries()) {
    if (library.status == LibraryRecord::Status::kUsable) continue;
    const bool shadowed = library.status == LibraryRecord::Status::kShadowed;
    fmt::print("{} {}: {}\n", shadowed ? "shadowed" : "refused", library.file.string(), fmt::join(library.reasons, "; "));
  }
}

void show(const ComponentRecord& record) {
  fmt::print("{} '{}': {}\n  plugin   {} {}, {}, {}\n  file     {} ({})\n", record.kind, record.name, record.summary,
             record.plugin, record.version, record.licence, record.author, record.file.string(), record.language);
  if (!record.capabilities.empty()) fmt::print("  promises {}\n", fmt::join(record.capabilities, ", "));
  if (record.schema.declarations().empty()) {
    fmt::print("  it has no parameters\n");
    return;
  }
  Table table;
  table.columns = {"parameter", "type", "default", "bounds", "unit", "what it is"};
  for (const auto& d : record.schema.declarations()) {
    const std::string standard = d.default_value.is_nil() ? "(must be given)" : d.default_value.is_string() ? d.default_value.string() : d.default_value.text();
    table.rows.push_back({d.name, std::string(parameter_type_name(d.type)), standard, d.bounds_text(), d.unit, d.text});
  }
  fmt::print("\n{}", table_text(table));
}

}  // namespace

void add_plugins(CLI::App& root, Application& application) {
  auto options = std::make_shared<PluginOptions>();
  CLI::App* verb = root.add_subcommand("plugins", "List the components that can be loaded, or show one with its parameters");
  verb->add_option("name", options->name, "component: kind/name, or its name alone");
  verb->add_flag("--json", options->json, "machine-readable");
  verb->add_flag("--why", options->why, "tell how the component was looked for");
  verb->footer("Examples:\n  preshape plugins\n  preshape plugins contact/salisbury_soft_finger\n  preshape plugins fcl --why");
  verb->callback([options, &application] {
    const Registry& registry = application.registry();
    if (options->name.empty()) return list(registry, options->json);
    if (options->why) {
      const auto slash = options->name.find('/');
      const ComponentKey key = slash == std::string::npos ? find_component(registry, options->name)
                                                          : ComponentKey{options->name.substr(0, slash), options->name.substr(slash + 1)};
      for (const auto& line : registry.why(key.kind, key.name)) fmt::print("{}\n", line);
      if (!registry.has(key.kind, key.name)) application.exit_code = kBadInput;
      return;
    }
    const ComponentKey key = find_component(registry, options->name);
    const ComponentRecord& record = registry.describe(key.kind, key.name);
    if (options->json) fmt::print("{}\n", component_json(record).dump(2));
    else show(record);
  });
}

}  // namespace preshape::app
