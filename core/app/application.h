#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "preshape/plugin/registry.h"
#include "preshape/script/script.h"
#include "preshape/workbench/catalogue.h"
#include "preshape/workbench/scenario.h"
#include "preshape/workbench/script_host.h"
#include "preshape/workbench/session.h"

namespace CLI {
class App;
}

namespace preshape::app {

/// Exit codes (docs/command.md).
enum ExitCode : int {
  kServed = 0,
  kOther = 1,
  kUsage = 2,
  kNotServed = 3,
  kDeadlocked = 4,
  kBadInput = 5,
};

/// What the verbs share: options before the verb, plugins and catalogue, made when first asked for.
class Application {
 public:
  std::vector<std::string> plugin_paths;
  std::filesystem::path scenario;  ///< the script that is run; components may lie beside it
  int exit_code = kServed;

  const Registry& registry();
  const Catalogue& catalogue();

 private:
  std::unique_ptr<Registry> registry_;
  std::unique_ptr<Catalogue> catalogue_;
};

/// Options of every verb that reads a scenario.
struct ScenarioOptions {
  std::string script;
  std::vector<std::string> settings;  ///< key=value
  std::string memory;
  bool trust = false;
  bool quiet = false;

  void add_to(CLI::App& verb, bool script_required = true);
};

/// The description that a script returns, with --set applied. `returned_scenario` is false for a study, whose result is
/// something else.
struct ScriptRun {
  std::unique_ptr<ScriptHost> host;  ///< the script's functions call into it, also from callbacks
  std::unique_ptr<Script> script;
  Value result;
  bool returned_scenario = false;
};
ScriptRun run_script(Application& application, const ScenarioOptions& options, class ::preshape::Progress* progress);

/// The checked scenario of a script's result.
/// @throws ScriptError naming every mistake, a line each
Scenario checked_scenario(Application& application, const Value& description, const std::string& file, ScenarioUse use);

/// "kind/name", or a name that only one kind has.
/// @throws PluginError
ComponentKey find_component(const Registry& registry, const std::string& text);

/// Writes a file whole or not at all.
/// @throws InputError
void write_file(const std::filesystem::path& path, const std::string& text);

void add_run(CLI::App& root, Application& application);
void add_check(CLI::App& root, Application& application);
void add_explore(CLI::App& root, Application& application);
void add_pretrain(CLI::App& root, Application& application);
void add_memory(CLI::App& root, Application& application);
void add_lua_meta(CLI::App& root, Application& application);
void add_new_plugin(CLI::App& root, Application& application);
void add_conform(CLI::App& root, Application& application);
void add_plugins(CLI::App& root, Application& application);
void add_objects(CLI::App& root, Application& application);
void add_sets(CLI::App& root, Application& application);
void add_tasks(CLI::App& root, Application& application);
void add_hand(CLI::App& root, Application& application);
void add_doctor(CLI::App& root, Application& application);

}  // namespace preshape::app
