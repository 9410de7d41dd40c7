#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/workbench/variants.h"

namespace preshape::app {

void add_check(CLI::App& root, Application& application) {
  auto options = std::make_shared<ScenarioOptions>();
  CLI::App* verb = root.add_subcommand("check", "Name every mistake of a scenario; run nothing");
  options->add_to(*verb);
  verb->footer("Example:\n  preshape check demo.lua && echo fine");
  verb->callback([options, &application] {
    const ScriptRun run = run_script(application, *options, nullptr);
    const bool pretraining = run.result.is_table() && !run.result.find("task") && run.result.find("stations");
    const Variants variants = variants_of(run.result, application.registry());
    for (const Variant& variant : variants.all) {
      checked_scenario(application, variant.description, options->script, pretraining ? ScenarioUse::kPretrain : ScenarioUse::kRun);
    }
    if (variants.keys.empty()) fmt::print("{}: no mistakes\n", options->script);
    else fmt::print("{}: no mistakes in {} combinations\n", options->script, variants.all.size());
  });
}

}  // namespace preshape::app
