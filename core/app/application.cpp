#include "application.h"

#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/script/setting.h"
#include "preshape/workbench/components.h"
#include "preshape/workbench/script_host.h"

namespace preshape::app {

const Registry& Application::registry() {
  if (!registry_) {
    const std::vector<std::filesystem::path> first(plugin_paths.begin(), plugin_paths.end());
    registry_ = open_registry(catalogue(), first, scenario);
  }
  return *registry_;
}

const Catalogue& Application::catalogue() {
  if (!catalogue_) catalogue_ = std::make_unique<Catalogue>(Catalogue::standard());
  return *catalogue_;
}

namespace {

/// A shipped script is found wherever one is: scripts/scenarios/demo.lua. What is nowhere stays as it is.
std::string found_script(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::exists(name, ignored)) return name;
  const Catalogue catalogue = Catalogue::standard();
  for (const auto& root : catalogue.roots()) {
    if (std::filesystem::is_regular_file(root / name, ignored)) return (root / name).string();
  }
  return name;
}

}  // namespace

void ScenarioOptions::add_to(CLI::App& verb, bool script_required) {
  verb.add_option("script", script, "Lua script")->required(script_required)->type_name("SCRIPT.lua")->transform(found_script);
  verb.add_option("--set", settings, "change a key of the scenario, such as contact.ka=0.3 or classifier=knn; may be repeated")
      ->type_name("KEY=VALUE");
  verb.add_option("--memory", memory, "memory to use instead of the scenario's: a name or a file")->type_name("NAME|FILE");
  verb.add_flag("--trust", trust, "give the script Lua's io, os and package");
}

ScriptRun run_script(Application& application, const ScenarioOptions& options, Progress* progress) {
  ScriptRun run;
  application.scenario = options.script;
  run.script = std::make_unique<Script>(std::filesystem::path(options.script),
                                        script_options(application.catalogue(), options.trust, 1));
  run.host = std::make_unique<ScriptHost>(application.registry(), application.catalogue(),
                                          ScriptHost::Options{options.memory, progress});
  run.host->add_to(*run.script);
  run.result = run.script->run();
  run.returned_scenario = run.result.is_table() && (run.result.find("object") || run.result.find("task"));
  for (const auto& text : options.settings) {
    const Setting setting = parse_setting(text);
    set_path(run.result, setting.key, setting.value);
  }
  return run;
}

Scenario checked_scenario(Application& application, const Value& description, const std::string& file, ScenarioUse use) {
  auto reading = read_scenario(description, file, use, application.registry(), application.catalogue());
  if (reading.mistakes.empty()) return std::move(reading.scenario);
  std::string text;
  for (const auto& mistake : reading.mistakes) text += (text.empty() ? "" : "\n") + mistake.text();
  throw ScriptError(text);
}

ComponentKey find_component(const Registry& registry, const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) return {text.substr(0, slash), text.substr(slash + 1)};
  std::vector<ComponentKey> found, refused;
  std::vector<std::string> names;
  for (const auto& library : registry.libraries()) {
    for (const auto& key : library.components()) {
      if (library.status == LibraryRecord::Status::kRefused && key.name == text) refused.push_back(key);
    }
  }
  for (const auto& key : registry.components()) {
    names.push_back(key.name);
    if (key.name == text) found.push_back(key);
  }
  if (found.empty() && !refused.empty()) return refused.front();
  if (found.empty()) throw PluginError(fmt::format("there is no component '{}'{}", text, did_you_mean(text, names)));
  if (found.size() > 1) throw PluginError(fmt::format("several kinds have a '{}'; say {}/{}", text, found.front().kind, text));
  return found.front();
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(part, path, error);
  if (!stream || error) {
    std::filesystem::remove(part, error);
    throw InputError(fmt::format("'{}' cannot be written; check that its folder exists and may be written to", path.string()));
  }
}

}  // namespace preshape::app
