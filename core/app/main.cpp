// The `preshape` command.
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/plugin/fingerprint.h"
#include "preshape/version.h"

namespace {

constexpr const char* kAbout =
    "preshape finds the preshape of a multi-fingered hand that serves a manipulation task on an object,\n"
    "says why, and learns new objects one by one.";

constexpr const char* kFooter =
    "Examples:\n"
    "  preshape run scripts/scenarios/demo.lua           run a scenario and print its report\n"
    "  preshape run demo.lua --set task=T2_3 --json out.json\n"
    "  preshape check demo.lua                           name every mistake, run nothing\n"
    "  preshape explore --object mug --task T1_2         the whole workspace of an object\n"
    "  preshape plugins similarity/tfvadi                a component and its parameters\n"
    "  preshape new-plugin contact rubber_pad            a component of your own to start from\n"
    "\n"
    "Exit codes: 0 served or learned, 1 other error, 2 wrong use, 3 recognised but not served,\n"
    "            4 deadlock, 5 bad input (script, object, hand, plugin)";

/// One "preshape: " in front, then the message; several mistakes stand a line each.
void tell(const char* message) { fmt::print(stderr, "preshape: {}\n", message); }

}  // namespace

int main(int argc, char** argv) {
  using namespace preshape;
  app::Application application;
  CLI::App root(kAbout, "preshape");
  root.footer(kFooter);
  root.require_subcommand(1);
  root.set_version_flag("--version", fmt::format("preshape {} ({})", PRESHAPE_VERSION_STRING, fingerprint_text(host_fingerprint())));
  root.add_option("--plugin-path", application.plugin_paths, "folder to look for plugins in first; may be repeated")
      ->type_name("FOLDER");
  app::add_run(root, application);
  app::add_check(root, application);
  app::add_explore(root, application);
  app::add_pretrain(root, application);
  app::add_memory(root, application);
  app::add_plugins(root, application);
  app::add_new_plugin(root, application);
  app::add_lua_meta(root, application);
  app::add_conform(root, application);
  app::add_objects(root, application);
  app::add_hand(root, application);
  app::add_tasks(root, application);
  app::add_sets(root, application);
  app::add_doctor(root, application);
  try {
    root.parse(argc, argv);
    return application.exit_code;
  } catch (const CLI::ParseError& problem) {
    return root.exit(problem) == 0 ? app::kServed : app::kUsage;
  } catch (const Error& problem) {
    tell(problem.what());
    return app::kBadInput;
  } catch (const std::exception& problem) {
    tell(problem.what());
    return app::kOther;
  }
}
