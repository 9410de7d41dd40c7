#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/fuzzy/partition_findings.h"

namespace preshape::app {

namespace {

/// Sets that leave gaps or crowd each other are no mistake; they may be meant.
void note_sets(const char* key, const FuzzyPartition& sets) {
  const Interval span = span_of(sets);
  if (span.width() == 0.0) return;  // a single point
  for (const auto& sentence : sentences(findings_of(sets, span), sets)) fmt::print("note: {}: {}\n", key, sentence);
}

}  // namespace

void add_check(CLI::App& root, Application& application) {
  auto options = std::make_shared<ScenarioOptions>();
  CLI::App* verb = root.add_subcommand("check", "Name every mistake of a scenario; run nothing");
  options->add_to(*verb);
  verb->footer("Example:\n  preshape check demo.lua && echo fine");
  verb->callback([options, &application] {
    const ScriptRun run = run_script(application, *options, nullptr);
    const bool pretraining = run.result.is_table() && !run.result.find("task") && run.result.find("stations");
    const Scenario scenario =
        checked_scenario(application, run.result, options->script, pretraining ? ScenarioUse::kPretrain : ScenarioUse::kRun);
    fmt::print("{}: no mistakes\n", options->script);
    note_sets("fuzzy", scenario.sets);
    note_sets("symbols", scenario.symbols);
  });
}

}  // namespace preshape::app
