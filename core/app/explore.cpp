#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "application.h"
#include "preshape/agent/internal_critic.h"
#include "preshape/io/heat_map_svg.h"
#include "preshape/io/table.h"
#include "preshape/script/setting.h"
#include "terminal.h"

namespace preshape::app {

namespace {

struct ExploreOptions {
  ScenarioOptions scenario;
  std::string object, task, csv, svg;
  double step = 0.25;
  bool all = false;
};

Value description_of(Application& application, ExploreOptions& options) {
  Value description;
  if (!options.scenario.script.empty()) {
    description = run_script(application, options.scenario, nullptr).result;
  } else {
    for (const auto& text : options.scenario.settings) {
      const Setting setting = parse_setting(text);
      set_path(description, setting.key, setting.value);
    }
  }
  if (!options.object.empty()) description.set("object", parse_value(options.object));
  if (!options.task.empty()) description.set("task", parse_value(options.task));
  if (!description.find("task")) description.set("task", "T1_1");
  description.set("memory", ":memory:");
  return description;
}

Table workspace_table(const Session& session, const std::vector<Session::WorkspaceRow>& rows, bool all) {
  const RunRecord about = session.record();
  Table table;
  table.columns = {"plane", "x/half", "x_mm", "symbol", "vf", "depth_U", "fx", "fy", "fz", "mx", "my", "mz", "sta", "manu",
                   about.measure, about.second_measure, "status"};
  for (const auto& row : rows) {
    const VirtualGrasp& g = row.grasp;
    if (!g.is_grasp() && !all) continue;
    std::vector<Value> cells = {g.plane + 1, g.approach_fraction, g.approach_m * 1e3,
                                about.symbol_names[static_cast<std::size_t>(row.preshape.symbol - 1)], g.virtual_fingers,
                                g.depth_m / about.hand_dimensions.unit_length_m};
    for (const double c : components(g.resultant)) cells.push_back(g.is_grasp() ? Value(c) : Value{});
    const bool grasp = g.is_grasp();
    for (const double x : {g.stability, g.manipulability, row.criticism.first, row.criticism.second}) {
      cells.push_back(grasp ? Value(x) : Value{});
    }
    cells.push_back(grasp ? "grasp" : g.detail);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The rows come plane by plane, the stations of each in one order.
HeatMap heat_map_of(const Session& session, const std::vector<Session::WorkspaceRow>& rows) {
  const RunRecord about = session.record();
  const auto& task = session.scenario().task;
  HeatMap map;
  map.title = fmt::format("{}, task {}: {} of each station's grasp", about.object->object.name, task && !task->name.empty() ? task->name : "as given", about.measure);
  map.measure = about.measure;
  map.scale = about.scale;
  for (std::size_t p = 0; p < about.planes.size(); ++p) map.planes.push_back(fmt::format("{}: {}", p + 1, about.planes[p].text()));
  for (const auto& row : rows) {
    const VirtualGrasp& grasp = row.grasp;
    if (grasp.plane == 0) map.stations.push_back(grasp.approach_fraction);
    map.cells.push_back({grasp.is_grasp() ? std::optional(row.criticism.first) : std::nullopt, grasp.detail});
  }
  return map;
}

}  // namespace

void add_explore(CLI::App& root, Application& application) {
  auto options = std::make_shared<ExploreOptions>();
  CLI::App* verb = root.add_subcommand("explore", "The workspace of an object: all planes x stations with wrench, measures and similarity");
  options->scenario.add_to(*verb, false);
  verb->add_option("--object", options->object, "object, instead of the script's")->type_name("NAME|MESH");
  verb->add_option("--task", options->task, "task, instead of the script's")->type_name("TASK");
  verb->add_option("--step", options->step, "step of the stations, over the half extent")->check(CLI::Range(0.001, 0.95))->capture_default_str();
  verb->add_option("--csv", options->csv, "write CSV with full precision to a file, - for standard output")->type_name("FILE");
  verb->add_option("--svg", options->svg, "also draw how near each station is to the task, - for standard output alone")->type_name("FILE");
  verb->add_flag("--all", options->all, "also the stations without a grasp, with the reason");
  verb->footer("Examples:\n  preshape explore --object mug --task T1_2\n  preshape explore demo.lua --step 0.05 --csv workspace.csv\n  preshape explore --object mug --task T1_2 --svg workspace.svg");
  verb->callback([options, &application] {
    if (options->scenario.script.empty() && options->object.empty()) {
      throw CLI::ValidationError("explore", "give a script or --object");
    }
    TerminalProgress progress(false);
    Session session(checked_scenario(application, description_of(application, *options), options->scenario.script, ScenarioUse::kRun),
                    application.registry(), application.catalogue(), {":memory:", &progress, nullptr});
    const auto rows = session.workspace(options->step);
    const Table table = workspace_table(session, rows, options->all);
    if (!options->svg.empty() && options->svg != "-") write_file(options->svg, heat_map_svg(heat_map_of(session, rows)));
    if (options->svg == "-") {
      fmt::print("{}", heat_map_svg(heat_map_of(session, rows)));
    } else if (options->csv == "-") {
      fmt::print("{}", table_csv(table));
    } else if (!options->csv.empty()) {
      write_file(options->csv, table_csv(table));
    } else {
      fmt::print("{}", table_text(table));
    }
  });
}

}  // namespace preshape::app
