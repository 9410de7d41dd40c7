#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/fuzzy/partition_findings.h"
#include "preshape/workbench/variants.h"

namespace preshape::app {

namespace {

/// What is amiss with sets, each told once. Sets that leave gaps or crowd each other are no mistake; they may be meant.
void add_notes(const char* key, const FuzzyPartition& sets, std::vector<std::string>& notes) {
  const Interval span = span_of(sets);
  if (span.width() == 0.0) return;  // a single point
  for (const auto& sentence : sentences(findings_of(sets, span), sets)) {
    const std::string note = fmt::format("{}: {}", key, sentence);
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
}

/// A hand that is described by hand has mistakes of its own.
void demand_hand(Application& application, const Value& scenario, const std::string& script) {
  if (const Value* hand = scenario.find("hand")) load_hand(*hand, script, application.registry(), application.catalogue());
}

}  // namespace

void add_check(CLI::App& root, Application& application) {
  auto options = std::make_shared<ScenarioOptions>();
  CLI::App* verb = root.add_subcommand("check", "Name every mistake of a scenario and its hand; run nothing");
  options->add_to(*verb);
  verb->footer("Example:\n  preshape check demo.lua && echo fine");
  verb->callback([options, &application] {
    const ScriptRun run = run_script(application, *options, nullptr);
    const bool pretraining = run.result.is_table() && !run.result.find("task") && run.result.find("stations");
    const Variants variants = variants_of(run.result, application.registry());
    std::vector<std::string> notes;
    for (const Variant& variant : variants.all) {
      const Scenario scenario = checked_scenario(application, variant.description, options->script,
                                                 pretraining ? ScenarioUse::kPretrain : ScenarioUse::kRun);
      demand_hand(application, variant.description, options->script);
      add_notes("fuzzy", scenario.sets, notes);
      add_notes("symbols", scenario.symbols, notes);
    }
    if (variants.keys.empty()) fmt::print("{}: no mistakes\n", options->script);
    else fmt::print("{}: no mistakes in {} combinations\n", options->script, variants.all.size());
    for (const auto& note : notes) fmt::print("note: {}\n", note);
  });
}

}  // namespace preshape::app
