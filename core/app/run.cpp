#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/io/report_json.h"
#include "preshape/io/report_text.h"
#include "terminal.h"

namespace preshape::app {

namespace {

struct RunOptions {
  ScenarioOptions scenario;
  std::string json;
};

int exit_code_of(const Report& report) {
  if (report.served()) return kServed;
  return report.status == RunStatus::kRecognised ? kNotServed : kDeadlocked;
}

/// Runs a scenario, lets its script correct it, prints each report.
int run_scenario(Application& application, const RunOptions& options, ScriptRun& run, Progress& progress) {
  Scenario scenario = checked_scenario(application, run.result, options.scenario.script, ScenarioUse::kRun);
  const auto callback = scenario.on_report;
  Session session(std::move(scenario), application.registry(), application.catalogue(),
                  {options.scenario.memory, &progress, nullptr});
  if (const auto lesson = session.pretrain_if_empty(); lesson && !options.scenario.quiet) {
    fmt::print("The memory was empty: pretrained on the {} first ({} rows, {} epochs).\n\n", session.scenario().pretrain,
               lesson->rows_added, lesson->training.epochs);
  }
  std::function<Value(const Value&)> control;
  if (callback) {
    control = [&](const Value& report) { return run.script->call(*callback, {&report, 1}); };
  }
  const auto records = session.run(control);
  const ReportTextOptions text{output_takes_colour(), options.scenario.quiet, true};
  for (std::size_t i = 0; i < records.size(); ++i) fmt::print("{}{}", i ? "\n" : "", report_text(records[i], text));
  if (!options.json.empty()) write_file(options.json, report_json(records.back()));
  return exit_code_of(records.back().report);
}

/// A study has run already: it printed what it wanted and returned its results.
int finish_study(const RunOptions& options, const ScriptRun& run) {
  if (!options.json.empty()) write_file(options.json, value_json(run.result, 2) + "\n");
  return kServed;
}

}  // namespace

void add_run(CLI::App& root, Application& application) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = root.add_subcommand("run", "Run a scenario (or a study) and print its report");
  options->scenario.add_to(*verb);
  verb->add_option("--json", options->json, "also write the report as JSON")->type_name("FILE");
  verb->add_flag("--quiet,-q", options->scenario.quiet, "print the verdict and the preshape only");
  verb->footer("Examples:\n  preshape run demo.lua\n  preshape run demo.lua --set task=T2_1 --set thresholds.estimation=3.5 --json out.json");
  verb->callback([options, &application] {
    TerminalProgress progress(options->scenario.quiet);
    ScriptRun run = run_script(application, options->scenario, &progress);
    application.exit_code = run.returned_scenario || run.result.is_nil() ? run_scenario(application, *options, run, progress)
                                                                        : finish_study(*options, run);
  });
}

}  // namespace preshape::app
