#include "preshape/workbench/scenario.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"
#include "scenario_parts.h"

namespace preshape {

const std::vector<ScenarioKey>& scenario_keys() {
  static const std::vector<ScenarioKey> keys = {
      {"title", "string", "what the scenario asks, for reports"},
      {"object", "name | path | table", "the object: a shipped one, a mesh file, or { name|mesh, unit, fit, frame, centre, weld }"},
      {"hand", "name | path | table", "the hand: a shipped one, a description file, or { model = a hand component, its parameters }; default \"utah_mit\""},
      {"task", "name | list | table", "the task: \"T1_2\", { Tx, Ty, Tz, Rx, Ry, Rz }, { T = , R = }, or { manipulation = , approach = , opposition = }"},
      {"contact", "component", "contact model; default \"salisbury_soft_finger\""},
      {"similarity", "component", "similarity measure that decides; default \"tfvadi\""},
      {"tie_break", "component", "similarity measure that breaks ties; default \"tfdist\""},
      {"classifier", "component", "classifier; default \"mlp\""},
      {"collision", "component", "collision backend; default \"fcl\""},
      {"quality", "list of components", "quality measures; default { \"sta_manu\" }"},
      {"explorer", "component", "problem generator; default \"beam\""},
      {"proof", "component", "explorer asked when the first finds nothing that serves; default \"exhaustive\""},
      {"simulator", "component", "carries the grasp out with the hand; \"none\": it is not carried out; default \"kinematic\""},
      {"analysis", "table", "how virtual grasps are analysed"},
      {"thresholds", "table", "thresholds of the critic"},
      {"learning", "table", "how the agent learns"},
      {"execution", "table", "how the hand carries the grasp out"},
      {"fuzzy", "list of sets", "fuzzy sets of tasks and wrenches; default the thesis's seven"},
      {"symbols", "list of sets", "fuzzy sets of the approach value; default the thesis's seven"},
      {"planes", "list of planes", "approach planes; default the thesis's twelve"},
      {"memory", "name | path", "the agent's memory; a bare name is kept in the user's folder; default \"default\""},
      {"pretrain", "object name", "object that an empty memory is taught first; \"none\": do not; default \"cube\""},
      {"stations", "list of numbers", "stations that pretraining teaches, over the half extent; default { -0.25, 0.25 }"},
      {"seed", "integer", "seed of all randomness; default 1"},
      {"on_report", "function", "meta control: gets each report, returns nil or { task = , object = , thresholds = } to go on"}};
  return keys;
}

namespace {

/// Reads a scenario key by key and collects every mistake.
class Reader {
 public:
  Reader(const Value& description, const std::filesystem::path& file, ScenarioUse use, const Registry& registry,
         const Catalogue& catalogue)
      : given_(description), file_(file), use_(use), registry_(registry), catalogue_(catalogue) {}

  ScenarioReading read() {
    Scenario& s = reading_.scenario;
    s.file = file_.string();
    s.description = given_;
    if (!given_.is_table()) {
      mistake(given_.place(), given_.is_nil() ? std::string("the script returns nothing; end it with return { object = ..., task = ... }, "
                                                           "or with a study's results")
                                              : fmt::format("a scenario returns a table, this returns {} {}", given_.kind(), given_.text()));
      return std::move(reading_);
    }
    check_keys();
    read_what(s);
    s.contact = component("contact");
    s.similarity = component("similarity");
    s.tie_break = component("tie_break");
    s.classifier = component("classifier");
    s.collision = component("collision");
    s.explorer = component("explorer");
    s.proof = component("proof");
    read_quality(s);
    const Value* simulator = given_.find("simulator");
    if (!simulator || !(simulator->is_string() && simulator->string() == "none")) s.simulator = component("simulator");
    s.analysis = parameters("analysis", analysis_schema());
    s.thresholds = parameters("thresholds", threshold_schema());
    s.learning = parameters("learning", learning_schema());
    s.execution = parameters("execution", execution_schema());
    if (!s.simulator && s.execution.flag("reachable")) {
      mistake(given_.find("execution")->place(), "execution: 'reachable' asks a simulator, and simulator is \"none\"; name one or leave it out");
    }
    s.sets = sets("fuzzy");
    s.symbols = sets("symbols");
    read_planes(s);
    read_rest(s);
    return std::move(reading_);
  }

 private:
  void mistake(const SourcePlace& place, std::string sentence) {
    SourcePlace at = place.known() ? place : SourcePlace{file_.string(), 0};
    reading_.mistakes.push_back({std::move(at), std::move(sentence)});
  }

  /// Runs a reader that throws; what it throws becomes a mistake at `value`, unless it names a place itself.
  template <class F>
  void attempt(const Value& value, F&& read) {
    try {
      read();
    } catch (const Error& problem) {
      const std::string text = problem.what();
      const std::string where = value.place().text();
      const bool placed = !where.empty() && text.starts_with(where);
      mistake(value.place(), placed ? text.substr(std::min(text.size(), where.size() + 2)) : text);
    }
  }

  void check_keys() {
    std::vector<std::string> known;
    for (const auto& key : scenario_keys()) known.push_back(key.name);
    for (const auto& [key, value] : given_.entries()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        mistake(value.place(), fmt::format("unknown key '{}'{}", key, did_you_mean(key, known)));
      }
    }
    for (const char* key : {"object", "task"}) {
      const bool needed = use_ == ScenarioUse::kRun || std::string_view(key) == "object";
      if (needed && !given_.find(key)) mistake(given_.place(), fmt::format("'{}' is missing", key));
    }
  }

  /// Whether a table, if it is one, has every key as declared: all mistakes of one table are told at once.
  bool fits(const Value& value, const ParameterSchema& schema) {
    if (!value.is_table()) return true;
    const auto wrong = schema.check(value, value.place());
    for (const auto& m : wrong) mistake(m.place, m.sentence);
    return wrong.empty();
  }

  void read_what(Scenario& s) {
    if (const Value* object = given_.find("object")) {
      if (fits(*object, object_schema())) {
        attempt(*object, [&] { s.object = object_from_value(*object, file_, catalogue_); });
      }
    }
    if (const Value* task = given_.find("task"); task && fits(*task, task_schema())) {
      attempt(*task, [&] { s.task = task_from_value(*task); });
    }
    const Value* hand = given_.find("hand");
    static const Value kDefault("utah_mit");
    attempt(hand ? *hand : kDefault, [&] {
      s.hand = hand_from_value(hand ? *hand : kDefault, file_, catalogue_);
      check_component({"hand", "hand", s.hand.model, hand_parameters(s.hand, registry_), {}, s.hand.place});
    });
  }

  /// A component by its name, as { "name", key = value }, or as { key = value } of the default one.
  ComponentChoice choice(const char* role, const std::string& kind, const std::string& standard, const Value& value) {
    ComponentChoice choice{role, kind, "", {}, {}, value.place()};
    if (value.is_string()) {
      choice.name = value.string();
    } else if (value.is_list() && value.items().size() == 1 && value.items()[0].is_string()) {
      choice.name = value.items()[0].string();  // { "name" } without any key
    } else if (value.is_table() && (!value.find("name") || value.find("name")->is_string())) {
      choice.name = value.find("name") ? value.find("name")->string() : standard;
      choice.parameters = value;
      choice.parameters.erase("name");
      if (choice.name.empty()) mistake(value.place(), fmt::format("'{0}' does not say which: {0} = {{ \"name\", key = value }}", role));
    } else {
      mistake(value.place(), fmt::format("'{}' is a name or {{ \"name\", key = value }}, got {}{}", role, value.text(),
                                         value.is_list() ? "; only `preshape run` compares a list of choices" : ""));
    }
    return choice;
  }

  ComponentChoice component(const char* role) {
    const ScenarioPart& part = scenario_part(role);
    const Value* value = given_.find(role);
    ComponentChoice chosen = value ? choice(role, part.kind, part.standard, *value)
                                   : ComponentChoice{role, part.kind, part.standard, {}, {}, {}};
    if (part.kind == "explorer") take_exploration(chosen);
    if (!chosen.name.empty()) check_component(chosen);
    return chosen;
  }

  /// Moves what any explorer can be given out of its own parameters, unless it declares a parameter of that name.
  void take_exploration(ComponentChoice& chosen) {
    for (const auto& name : exploration_schema().names()) {
      const Value* value = chosen.parameters.find(name);
      if (!value || declares(chosen, name)) continue;
      chosen.exploration.set(name, *value);
      chosen.parameters.erase(name);
    }
    const auto wrong = exploration_schema().check(chosen.exploration, chosen.place);
    for (const auto& m : wrong) mistake(m.place, m.sentence);
  }

  bool declares(const ComponentChoice& chosen, const std::string& name) const {
    try {
      return registry_.describe(chosen.kind, chosen.name).schema.find(name) != nullptr;
    } catch (const PluginError&) {
      return false;  // told by check_component
    }
  }

  void check_component(const ComponentChoice& chosen) {
    try {
      const auto& record = registry_.describe(chosen.kind, chosen.name);
      for (const auto& wrong : record.schema.check(chosen.parameters, chosen.place)) mistake(wrong.place, wrong.sentence);
    } catch (const PluginError& problem) {
      mistake(chosen.place, fmt::format("{}{}", chosen.role == chosen.kind ? "" : chosen.role + ": ", problem.what()));
    }
  }

  void read_quality(Scenario& s) {
    const Value* given = given_.find("quality");
    const Value value = given ? *given : Value("sta_manu");
    const bool list = value.is_list();
    for (const Value& item : list ? value.items() : Value::List{value}) {
      s.quality.push_back(choice("quality", "quality", "sta_manu", item));
      if (!s.quality.back().name.empty()) check_component(s.quality.back());
    }
  }

  Parameters parameters(const char* key, const ParameterSchema& schema) {
    const Value* given = given_.find(key);
    const Value value = given ? *given : Value{};
    const auto wrong = schema.check(value, value.place());
    for (const auto& m : wrong) mistake(m.place, m.sentence);
    return wrong.empty() ? schema.resolve(value) : schema.defaults();
  }

  FuzzyPartition sets(const char* key) {
    const Value* given = given_.find(key);
    if (!given) return FuzzyPartition::thesis();
    const auto wrong = FuzzyPartition::check(*given);
    for (const auto& m : wrong) mistake(m.place.known() ? m.place : given->place(), m.sentence);
    return wrong.empty() ? FuzzyPartition::from_value(*given) : FuzzyPartition::thesis();
  }

  void read_planes(Scenario& s) {
    const Value* given = given_.find("planes");
    if (!given) {
      s.planes = thesis_planes();
      return;
    }
    const auto wrong = check_planes(*given);
    for (const auto& m : wrong) mistake(m.place, m.sentence);
    if (wrong.empty()) s.planes = planes_from_value(*given);
  }

  void read_rest(Scenario& s) {
    static const ParameterSchema schema(
        "scenario", {ParameterDeclaration::label("title", "", ""), ParameterDeclaration::label("memory", "default", ""),
                     ParameterDeclaration::label("pretrain", "cube", ""),
                     ParameterDeclaration::integer("seed", 1, 0, 9007199254740992.0, "1", ""),
                     ParameterDeclaration::list("stations", {-0.25, 0.25}, -1.0, 1.0, "1", "")});
    Value own;
    for (const auto& name : schema.names()) {
      if (const Value* value = given_.find(name)) own.set(name, *value);
    }
    if (const Value* callback = given_.find("on_report")) {
      if (callback->is_function()) s.on_report = callback->function();
      else mistake(callback->place(), fmt::format("'on_report' must be a function, got {} {}", callback->kind(), callback->text()));
    }
    const Value* pretrain = given_.find("pretrain");
    if (pretrain && pretrain->is_string() && pretrain->string() != "none") {
      attempt(*pretrain, [&] { object_from_value(*pretrain, file_, catalogue_); });
    }
    const auto wrong = schema.check(own);
    for (const auto& m : wrong) mistake(m.place, m.sentence);
    if (!wrong.empty()) return;
    const Parameters p = schema.resolve(own);
    s.memory = p.text("memory");
    s.pretrain = p.text("pretrain");
    s.seed = static_cast<std::uint64_t>(p.integer("seed"));
    s.pretraining.stations = p.numbers("stations");
  }

  const Value& given_;
  std::filesystem::path file_;
  ScenarioUse use_;
  const Registry& registry_;
  const Catalogue& catalogue_;
  ScenarioReading reading_;
};

}  // namespace

ScenarioReading read_scenario(const Value& description, const std::filesystem::path& file, ScenarioUse use,
                              const Registry& registry, const Catalogue& catalogue) {
  return Reader(description, file, use, registry, catalogue).read();
}

}  // namespace preshape
