#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/io/report_json.h"
#include "preshape/io/report_text.h"
#include "preshape/workbench/variants.h"
#include "run_pictures.h"
#include "scene_files.h"
#include "terminal.h"

namespace preshape::app {

namespace {

struct RunOptions {
  ScenarioOptions scenario;
  std::string json;
  RunPictures pictures;
  SceneFiles files;
  bool first_try = false;

  ShownTry shown() const { return first_try ? ShownTry::kFirst : ShownTry::kCarriedOut; }
};

int exit_code_of(const Report& report) {
  if (report.served()) return kServed;
  return report.status == RunStatus::kRecognised ? kNotServed : kDeadlocked;
}

/// Meta control: the script's on_report, where it has one.
std::function<Value(const Value&)> control_of(const std::optional<Value::Function>& callback, ScriptRun& run) {
  if (!callback) return {};
  return [callback, &run](const Value& report) { return run.script->call(*callback, {&report, 1}); };
}

/// Runs every combination of a scenario's lists and prints the table.
int run_comparison(Application& application, const RunOptions& options, ScriptRun& run, const Variants& variants,
                   Progress& progress) {
  const Value* callback = run.result.find("on_report");
  const auto control = control_of(callback && callback->is_function() ? std::optional(callback->function()) : std::nullopt, run);
  const Comparison comparison = compare(variants, options.scenario.script, application.registry(), application.catalogue(),
                                        {options.scenario.memory, &progress, nullptr}, control);
  fmt::print("{}", comparison_text(comparison, output_takes_colour()));
  if (!options.json.empty()) write_file(options.json, value_json(comparison_value(comparison), 2) + "\n");
  const bool refused = std::any_of(comparison.runs.begin(), comparison.runs.end(), [](const auto& r) { return !r.record; });
  return refused ? kBadInput : kServed;
}

/// Runs a scenario, lets its script correct it, prints each report.
int run_scenario(Application& application, const RunOptions& options, ScriptRun& run, Progress& progress) {
  const Variants variants = variants_of(run.result, application.registry());
  options.pictures.check(variants.keys.empty());
  options.files.check(application.catalogue(), variants.keys.empty());
  if (!variants.keys.empty()) return run_comparison(application, options, run, variants, progress);
  Scenario scenario = checked_scenario(application, run.result, options.scenario.script, ScenarioUse::kRun);
  const auto callback = scenario.on_report;
  Session session(std::move(scenario), application.registry(), application.catalogue(),
                  {options.scenario.memory, &progress, nullptr});
  if (const auto lesson = session.pretrain_if_empty(); lesson && !options.scenario.quiet) {
    fmt::print("The memory was empty: pretrained on the {} first ({} rows, {} epochs).\n\n", session.scenario().pretrain,
               lesson->rows_added, lesson->training.epochs);
  }
  const auto records = session.run(control_of(callback, run));
  const ReportTextOptions text{output_takes_colour(), options.scenario.quiet, true};
  for (std::size_t i = 0; i < records.size(); ++i) fmt::print("{}{}", i ? "\n" : "", report_text(records[i], text));
  if (!options.json.empty()) write_file(options.json, report_json(records.back()));
  options.pictures.write(application, records.back(), options.shown());
  options.files.write(application.catalogue(), records.back(), options.shown());
  return exit_code_of(records.back().report);
}

/// A study has run already: it printed what it wanted and returned its results.
int finish_study(Application& application, const RunOptions& options, const ScriptRun& run) {
  options.files.check(application.catalogue(), false);
  options.pictures.check(false);
  if (!options.json.empty()) write_file(options.json, value_json(run.result, 2) + "\n");
  return kServed;
}

}  // namespace

void add_run(CLI::App& root, Application& application) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = root.add_subcommand("run", "Run a scenario (or a study) and print its report");
  options->scenario.add_to(*verb);
  verb->add_option("--json", options->json, "also write the report as JSON")->type_name("FILE");
  options->pictures.add_to(*verb);
  options->files.add_to(*verb);
  verb->add_flag(
      "--first-try", options->first_try,
      "let picture, scene and page show the first try, even where the hand carried out a second one");
  verb->add_flag("--quiet,-q", options->scenario.quiet, "print the verdict and the preshape only");
  verb->footer("Examples:\n  preshape run demo.lua\n  preshape run demo.lua --set task=T2_1 --set thresholds.estimation=3.5 --json out.json");
  verb->callback([options, &application] {
    TerminalProgress progress(options->scenario.quiet);
    ScriptRun run = run_script(application, options->scenario, &progress);
    application.exit_code = run.returned_scenario || run.result.is_nil() ? run_scenario(application, *options, run, progress)
                                                                        : finish_study(application, *options, run);
  });
}

}  // namespace preshape::app
