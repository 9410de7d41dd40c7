#include "preshape/workbench/script_host.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "preshape/grasp/task_space.h"
#include "preshape/io/report_json.h"
#include "preshape/version.h"
#include "preshape/workbench/variants.h"

namespace preshape {

namespace {

Value task_value(const Task& task) {
  std::vector<double> T(task.screw.begin(), task.screw.begin() + 3), R(task.screw.begin() + 3, task.screw.end());
  return Value::table({{"name", task.name}, {"T", Value::numbers(T)}, {"R", Value::numbers(R)}});
}

Value names_value(const std::vector<std::string>& names) {
  return Value::list(Value::List(names.begin(), names.end()));
}

const Value& table_argument(std::span<const Value> arguments, const char* function) {
  if (arguments.size() != 1 || !arguments[0].is_table()) {
    throw ScriptError(fmt::format("preshape.{}: expected one table, got {}", function,
                                  arguments.empty() ? "nothing" : std::string(arguments[0].kind())));
  }
  return arguments[0];
}

/// A scenario that says what to do: a session kept from an earlier call must not lend it its task.
const Value& task_argument(std::span<const Value> arguments, const char* function) {
  const Value& scenario = table_argument(arguments, function);
  if (!scenario.find("task")) throw ScriptError(fmt::format("preshape.{}: 'task' is missing", function));
  return scenario;
}

Value component_value(const ComponentRecord& record) {
  Value::List parameters;
  for (const auto& declaration : record.schema.declarations()) {
    Value parameter = Value::table({{"name", declaration.name},
                                    {"type", std::string(parameter_type_name(declaration.type))},
                                    {"default", declaration.default_value},
                                    {"unit", declaration.unit},
                                    {"text", declaration.text}});
    if (std::isfinite(declaration.minimum)) parameter.set("minimum", declaration.minimum);
    if (std::isfinite(declaration.maximum)) parameter.set("maximum", declaration.maximum);
    if (!declaration.choices.empty()) parameter.set("choices", names_value(declaration.choices));
    parameters.push_back(std::move(parameter));
  }
  return Value::table({{"kind", record.kind},
                       {"name", record.name},
                       {"summary", record.summary},
                       {"plugin", record.plugin},
                       {"version", record.version},
                       {"capabilities", names_value(record.capabilities)},
                       {"parameters", Value::list(std::move(parameters))}});
}

/// Every component that can be used, of one kind or of all.
Value components_value(const Registry& registry, std::span<const Value> arguments) {
  const bool all = arguments.empty() || arguments[0].is_nil();
  const std::vector<std::string> kinds(kKinds.begin(), kKinds.end());
  const std::string kind = !all && arguments[0].is_string() ? arguments[0].string() : "";
  if (!all && std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
    throw ScriptError(fmt::format("preshape.components: there is no kind {}{}", arguments[0].text(), did_you_mean(kind, kinds)));
  }
  Value::List components;
  for (const auto& key : registry.components()) {
    if (!all && key.kind != kind) continue;
    try {
      components.push_back(component_value(registry.describe(key.kind, key.name)));
    } catch (const PluginError&) {
      // Its library was refused when it was loaded: it cannot be used.
    }
  }
  return Value::list(std::move(components));
}

double workspace_step(std::span<const Value> arguments) {
  if (arguments.size() < 2 || arguments[1].is_nil()) return 0.25;
  const bool fits = arguments[1].is_number() && arguments[1].number() >= 0.001 && arguments[1].number() <= 0.95;
  if (!fits) throw ScriptError(fmt::format("preshape.workspace: the step must be a number in 0.001 .. 0.95, got {}", arguments[1].text()));
  return arguments[1].number();
}

/// The stations that have a grasp.
Value workspace_value(const std::vector<Session::WorkspaceRow>& workspace, const RunRecord& about) {
  Value::List rows;
  for (const auto& row : workspace) {
    const VirtualGrasp& grasp = row.grasp;
    if (!grasp.is_grasp()) continue;
    const auto wrench = preshape::components(grasp.resultant);
    Value quality = Value::table({});
    for (std::size_t i = 0; i < about.quality_numbers.size(); ++i) quality.set(about.quality_numbers[i].name, grasp.quality[i]);
    rows.push_back(Value::table({{"plane", row.preshape.plane},
                                 {"symbol", row.preshape.symbol},
                                 {"virtual_fingers", grasp.virtual_fingers},
                                 {"approach", grasp.approach_fraction},
                                 {"wrench", Value::numbers({wrench.begin(), wrench.end()})},
                                 {"quality", std::move(quality)},
                                 {"first", row.criticism.first},
                                 {"second", row.criticism.second}}));
  }
  return Value::list(std::move(rows));
}

Value lesson_value(const LessonReport& lesson) {
  return Value::table({{"rows_added", lesson.rows_added},
                       {"evaluations", lesson.evaluations},
                       {"arrived", lesson.training.status == TrainingOutcome::Status::kArrived},
                       {"epochs", lesson.training.epochs},
                       {"restarts", lesson.training.restarts},
                       {"wrong_rows", lesson.training.wrong_rows},
                       {"mean_squared_error", lesson.training.mean_squared_error}});
}

}  // namespace

ScriptOptions script_options(const Catalogue& catalogue, bool trust, std::uint64_t seed) {
  ScriptOptions options;
  options.module_roots = catalogue.module_roots();
  options.trust = trust;
  options.seed = seed;
  return options;
}

ScriptHost::ScriptHost(const Registry& registry, const Catalogue& catalogue, Options options)
    : registry_(registry), catalogue_(catalogue), options_(std::move(options)) {}

ScriptHost::~ScriptHost() = default;

Session& ScriptHost::session(const Value& description, const SourcePlace& caller) {
  // What a session can change by itself is no part of its key.
  Value key = description, changes;
  for (const char* name : {"object", "task"}) {
    if (const Value* value = description.find(name)) changes.set(name, *value), key.erase(name);
  }
  auto& session = sessions_[key.text()];
  if (session) {
    if (!changes.find("object")) throw ScriptError("'object' is missing");
    const Value& now = session->scenario().description;
    if (now.find("object") && changes.find("object") && *now.find("object") == *changes.find("object")) changes.erase("object");
    if (!changes.is_nil()) session->change(changes);
    return *session;
  }
  const auto use = description.find("task") ? ScenarioUse::kRun : ScenarioUse::kPretrain;
  auto reading = read_scenario(description, caller.file, use, registry_, catalogue_);
  if (!reading.mistakes.empty()) throw ScriptError(reading.mistakes.front().text());
  session = std::make_unique<Session>(std::move(reading.scenario), registry_, catalogue_,
                                      Session::Options{options_.memory, options_.progress, nullptr});
  return *session;
}

void ScriptHost::add_to(Script& script) {
  script.add_constant("version", "version of preshape", PRESHAPE_VERSION_STRING);
  script.add_function("scenario", "(description: preshape.Scenario): preshape.Scenario", "marks a table as a scenario; returns it as it is",
                      [](auto arguments, const SourcePlace&) { return table_argument(arguments, "scenario"); });
  script.add_function("run", "(scenario: preshape.Scenario): preshape.Report", "runs the controller once and returns its report",
                      [this](auto arguments, const SourcePlace& caller) {
                        Session& s = session(task_argument(arguments, "run"), caller);
                        s.pretrain_if_empty();
                        return report_value(s.run());
                      });
  script.add_function("estimate", "(scenario: preshape.Scenario): preshape.Report", "modes 0 and 1 alone, with nothing learned; returns the report",
                      [this](auto arguments, const SourcePlace& caller) {
                        Session& s = session(task_argument(arguments, "estimate"), caller);
                        s.pretrain_if_empty();
                        return report_value(s.estimate());
                      });
  script.add_function("pretrain", "(scenario: preshape.Scenario): preshape.Lesson", "teaches the scenario's object at the pretraining stations",
                      [this](auto arguments, const SourcePlace& caller) {
                        return lesson_value(session(table_argument(arguments, "pretrain"), caller).pretrain());
                      });
  script.add_function("best", "(scenario: preshape.Scenario): preshape.Best?",
                      "the best grasp that the explorers find for the task: plane, approach, score; nil when there is none",
                      [this](auto arguments, const SourcePlace& caller) {
                        const auto best = session(task_argument(arguments, "best"), caller).best();
                        if (!best.best) return Value{};
                        return Value::table({{"plane", best.best->preshape.plane},
                                             {"symbol", best.best->preshape.symbol},
                                             {"virtual_fingers", best.best->preshape.virtual_fingers},
                                             {"approach", best.best->grasp.approach_fraction},
                                             {"transverse", best.best->grasp.transverse_fraction},
                                             {"first", best.best->criticism.first},
                                             {"second", best.best->criticism.second},
                                             {"evaluations", best.evaluations}});
                      });
  script.add_function("taught", "(scenario: preshape.Scenario): preshape.Taught",
                      "how many rows the scenario's memory holds, and how many of them its classifier predicts",
                      [this](auto arguments, const SourcePlace& caller) {
                        const auto taught = session(table_argument(arguments, "taught"), caller).taught();
                        return Value::table({{"rows", taught.rows}, {"predicted", taught.predicted}});
                      });
  script.add_function("workspace", "(scenario: preshape.Scenario, step: number?): preshape.WorkspaceRow[]",
                      "the grasp at every station of a grid with its wrench, measures and similarity to the task; stations without a grasp are left out",
                      [this](auto arguments, const SourcePlace& caller) {
                        const double step = workspace_step(arguments);
                        Session& s = session(task_argument(arguments.first(1), "workspace"), caller);
                        return workspace_value(s.workspace(step), s.record());
                      });
  script.add_function("compare", "(scenario: preshape.Scenario): preshape.Comparison",
                      "runs every combination of a scenario that gives lists where it gives one; keys, and rows with choices and report",
                      [this](auto arguments, const SourcePlace& caller) {
                        const Value& description = task_argument(arguments, "compare");
                        return comparison_value(compare(variants_of(description, registry_), caller.file, registry_, catalogue_,
                                                        {options_.memory, options_.progress, nullptr}, {}));
                      });
  script.add_function("tasks", "(signs: boolean?): preshape.TaskRecord[]", "the task space; with signs its 84 variants",
                      [](auto arguments, const SourcePlace&) {
                        const bool signs = !arguments.empty() && arguments[0].is_boolean() && arguments[0].boolean();
                        Value::List tasks;
                        for (const auto& task : signs ? signed_task_space() : task_space()) tasks.push_back(task_value(task));
                        return Value::list(std::move(tasks));
                      });
  script.add_function("components", "(kind: preshape.Kind?): preshape.ComponentRecord[]",
                      "the components that can be used: kind, name, summary, plugin, version, capabilities, parameters",
                      [this](auto arguments, const SourcePlace&) { return components_value(registry_, arguments); });
  script.add_function("objects", "(): string[]", "names of the objects that are found by name",
                      [this](auto, const SourcePlace&) { return names_value(catalogue_.objects()); });
  script.add_function("hands", "(): string[]", "names of the hands that are found by name",
                      [this](auto, const SourcePlace&) { return names_value(catalogue_.hands()); });
}

}  // namespace preshape
