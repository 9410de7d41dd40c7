#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "application.h"
#include "preshape/base/error.h"
#include "preshape/io/membership_svg.h"
#include "preshape/io/table.h"
#include "preshape/script/setting.h"

namespace preshape::app {

namespace {

struct SetsOptions {
  ScenarioOptions scenario;
  std::string svg;
  double bound = 0.5;
  bool symbols = false;
};

constexpr const char* kShapes[] = {"trapezoid", "triangle", "gaussian", "bell", "sigmoid"};

/// The sets of the script or of --set; the thesis's where neither says any. Nothing else of the scenario is read.
FuzzyPartition sets_of(Application& application, const SetsOptions& options) {
  Value description;
  if (!options.scenario.script.empty()) {
    description = run_script(application, options.scenario, nullptr).result;
  } else {
    for (const auto& text : options.scenario.settings) {
      const Setting setting = parse_setting(text);
      set_path(description, setting.key, setting.value);
    }
  }
  const char* key = options.symbols ? "symbols" : "fuzzy";
  const Value* sets = description.is_table() ? description.find(key) : nullptr;
  if (!sets) return FuzzyPartition::thesis();
  if (sets->is_list() && !sets->items().empty() && sets->items().front().is_list()) {
    throw ScriptError(fmt::format("'{}' gives {} families of sets to compare; look at one at a time", key, sets->items().size()));
  }
  std::string wrong;
  for (const auto& mistake : FuzzyPartition::check(*sets)) wrong += (wrong.empty() ? "" : "\n") + mistake.text();
  if (!wrong.empty()) throw ScriptError(wrong);
  return FuzzyPartition::from_value(*sets);
}

std::string points_text(const Membership& set) {
  std::string text;
  for (const double x : set.points) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", x);
  return text;
}

Table table_of(const FuzzyPartition& partition, const PartitionFindings& found) {
  Table table;
  table.columns = {"set", "shape", "points", "top", "crosses_next_at", "height"};
  for (int i = 0; i < partition.size(); ++i) {
    const Membership& set = partition[i];
    std::vector<Value> row = {set.name, kShapes[static_cast<int>(set.shape)], points_text(set), set.top_middle()};
    const bool crosses = i + 1 < partition.size() && found.crossings[static_cast<std::size_t>(i)].height > 0.0;
    row.push_back(crosses ? Value(found.crossings[static_cast<std::size_t>(i)].x) : Value{});
    row.push_back(i + 1 < partition.size() ? Value(found.crossings[static_cast<std::size_t>(i)].height) : Value{});
    table.rows.push_back(std::move(row));
  }
  return table;
}

void tell(const FuzzyPartition& partition, const PartitionFindings& found) {
  fmt::print("{}\n{:.6g} to {:.6g}: the degrees of a number add up to {:.3f} .. {:.3f}; ", table_text(table_of(partition, found)),
             found.universe.from, found.universe.to, found.least_sum, found.most_sum);
  fmt::print("{:g} is {} reached by some set\n", found.bound, found.gaps.empty() ? "everywhere" : "not everywhere");
}

}  // namespace

void add_sets(CLI::App& root, Application& application) {
  auto options = std::make_shared<SetsOptions>();
  CLI::App* verb = root.add_subcommand("sets", "List the fuzzy sets of a scenario, look for gaps and overlaps, draw them");
  options->scenario.add_to(*verb, false);
  verb->add_flag("--symbols", options->symbols, "the sets of the approach value instead of those of tasks and wrenches");
  verb->add_option("--bound", options->bound, "degree that some set should reach everywhere")->check(CLI::Range(0.001, 1.0))->capture_default_str();
  verb->add_option("--svg", options->svg, "draw them to a file, - for standard output")->type_name("FILE");
  verb->footer("Examples:\n  preshape sets\n  preshape sets demo.lua --symbols --svg symbols.svg");
  verb->callback([options, &application] {
    const FuzzyPartition partition = sets_of(application, *options);
    const PartitionFindings found = findings_of(partition, span_of(partition), options->bound);
    const char* what = options->symbols ? "Fuzzy sets of the approach value" : "Fuzzy sets of tasks and wrenches";
    const bool drawn_out = options->svg == "-";
    if (drawn_out) fmt::print("{}", membership_svg(partition, found, what));
    else tell(partition, found);
    if (!drawn_out && !options->svg.empty()) write_file(options->svg, membership_svg(partition, found, what));
    for (const auto& sentence : sentences(found, partition)) fmt::print(drawn_out ? stderr : stdout, "note: {}\n", sentence);
  });
}

}  // namespace preshape::app
