#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "application.h"
#include "component_pages.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/io/table.h"

namespace preshape::app {

namespace {

struct PluginOptions {
  std::string name;
  bool json = false, why = false, markdown = false, exists = false;
};

void list(const Registry& registry) {
  Table table;
  table.columns = {"kind", "name", "version", "in", "summary"};
  for (const auto& key : registry.components()) {
    try {
      const ComponentRecord& record = registry.describe(key.kind, key.name);
      table.rows.push_back({record.kind, record.name, record.version, record.language, record.summary});
    } catch (const PluginError& problem) {
      table.rows.push_back({key.kind, key.name, "-", "-", std::string("cannot be used: ") + problem.what()});
    }
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

/// Whether there is such a component; nothing is loaded for that.
bool exists(const Registry& registry, const std::string& text) {
  const auto keys = registry.components();
  return std::any_of(keys.begin(), keys.end(), [&](const ComponentKey& key) {
    return text == key.name || text == key.kind + "/" + key.name;
  });
}

void why(Application& application, const std::string& text) {
  const Registry& registry = application.registry();
  const ComponentKey key = find_component(registry, text);
  for (const auto& line : registry.why(key.kind, key.name)) fmt::print("{}\n", line);
  if (!registry.has(key.kind, key.name)) application.exit_code = kBadInput;
}

void plugins(Application& application, const PluginOptions& options) {
  const Registry& registry = application.registry();
  if (options.name.empty()) {
    if (options.exists || options.why) throw CLI::ValidationError("--exists and --why ask about one component; name it");
    if (options.json) fmt::print("{}\n", listing_json(registry).dump(2));
    else if (options.markdown) fmt::print("{}", reference_markdown(registry));
    else list(registry);
    return;
  }
  if (options.exists) {
    application.exit_code = exists(registry, options.name) ? kServed : kBadInput;
    return;
  }
  if (options.why) return why(application, options.name);
  const ComponentKey key = find_component(registry, options.name);
  const ComponentRecord& record = registry.describe(key.kind, key.name);
  if (options.json) fmt::print("{}\n", component_json(record).dump(2));
  else if (options.markdown) fmt::print("{}", component_markdown(record));
  else show(record);
}

}  // namespace

void add_plugins(CLI::App& root, Application& application) {
  auto options = std::make_shared<PluginOptions>();
  CLI::App* verb = root.add_subcommand("plugins", "List the components that can be loaded, or show one with its parameters");
  verb->add_option("name", options->name, "component: kind/name, or its name alone");
  CLI::Option* json = verb->add_flag("--json", options->json, "machine-readable");
  CLI::Option* markdown = verb->add_flag("--markdown", options->markdown, "as a page: summary, promises, table of parameters");
  CLI::Option* exists = verb->add_flag("--exists", options->exists, "say nothing; exit 0 when there is such a component, else 5");
  CLI::Option* why = verb->add_flag("--why", options->why, "tell how the component was looked for");
  for (CLI::Option* option : {json, markdown, exists, why}) {
    for (CLI::Option* other : {json, markdown, exists, why}) {
      if (option != other) option->excludes(other);
    }
  }
  verb->footer("Examples:\n  preshape plugins\n  preshape plugins contact/salisbury_soft_finger\n  preshape plugins fcl --why");
  verb->callback([options, &application] { plugins(application, *options); });
}

}  // namespace preshape::app
