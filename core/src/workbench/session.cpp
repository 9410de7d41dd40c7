#include "preshape/workbench/session.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "preshape/agent/station_search.h"
#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "preshape/base/suggest.h"
#include "preshape/io/object_reader.h"
#include "preshape/io/report_json.h"
#include "preshape/plugin/fingerprint.h"
#include "grasp_execution.h"
#include "scenario_parts.h"

namespace preshape {

namespace {

/// Seconds since it was made or last read.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// ":memory:" and ":memory:anything" live as long as the session.
std::shared_ptr<Memory> open_memory(const std::filesystem::path& path) {
  if (path.string().starts_with(":memory:")) return std::make_shared<Memory>(Memory::in_memory());
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  return std::make_shared<Memory>(Memory::open(path, Memory::Mode::kCreate));
}

}  // namespace

struct Session::State {
  Scenario scenario;
  const Registry& registry;
  const Catalogue& catalogue;
  Options options;
  std::vector<ComponentUse> uses;

  std::shared_ptr<HandModel> hand;
  std::shared_ptr<Memory> memory;
  std::shared_ptr<Similarity> similarity, tie_break;
  NamedClassifier classifier;
  NamedExplorer explorer, proof;
  std::shared_ptr<const CollisionBackend> collision;
  std::shared_ptr<const GraspExecution> execution;  ///< null when the grasp shall not be carried out
  std::shared_ptr<const PreshapeAnalyser> analyser;
  std::unique_ptr<EnvironmentSensing> sensing;
  std::shared_ptr<const SensedObject> object;

  std::shared_ptr<const InternalCritic> critic;
  std::shared_ptr<LearningElement> learning;
  std::unique_ptr<PreshapeController> controller;
  std::vector<Timing> timings;

  State(Scenario s, const Registry& r, const Catalogue& c, Options o)
      : scenario(std::move(s)), registry(r), catalogue(c), options(std::move(o)) {}

  template <class T>
  std::shared_ptr<T> make(const ComponentChoice& choice) {
    auto component = registry.create<T>(choice.name, choice.parameters, choice.place);
    const ComponentRecord& record = registry.describe(choice.kind, choice.name);
    ComponentUse use{choice.role, choice.kind, choice.name, {}, record.plugin, record.version, fingerprint_of(record)};
    use.parameters = Value::table(record.schema.resolve(choice.parameters, choice.place).values());
    uses.push_back(std::move(use));
    return component;
  }
  NamedExplorer make_explorer(const ComponentChoice& choice);

  std::string fingerprint_of(const ComponentRecord& record) const;
  void make_components();
  void make_agent();
  std::shared_ptr<const SensedObject> sense(const ObjectChoice& choice) const;
  Value resolved() const;
};

std::string Session::State::fingerprint_of(const ComponentRecord& record) const {
  for (const LibraryRecord& library : registry.libraries()) {
    if (library.file != record.file) continue;
    if (library.language == "C++") return fingerprint_text(library.manifest.fingerprint);
    std::ifstream stream(record.file, std::ios::binary);  // a script is its text
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return fmt::format("{}, SHA-256 {}", library.language, sha256_hex(text));
  }
  return "";
}

NamedExplorer Session::State::make_explorer(const ComponentChoice& choice) {
  NamedExplorer made{choice.name, make<Explorer>(choice), {}};
  const std::int64_t budget = exploration_schema().resolve(choice.exploration, choice.place).integer("budget");
  if (budget > 0) {
    made.budget = budget;
    uses.back().parameters.set("budget", budget);
  }
  return made;
}

void Session::State::make_components() {
  const auto contact = make<ContactModel>(scenario.contact);
  similarity = make<Similarity>(scenario.similarity);
  tie_break = make<Similarity>(scenario.tie_break);
  classifier.name = scenario.classifier.name;
  classifier.classifier = make<Classifier>(scenario.classifier);
  classifier.parameters_json = value_json(uses.back().parameters);
  collision = make<CollisionBackend>(scenario.collision);
  std::vector<std::shared_ptr<const QualityMeasure>> quality;
  for (const auto& choice : scenario.quality) quality.push_back(make<QualityMeasure>(choice));
  explorer = make_explorer(scenario.explorer);
  proof = make_explorer(scenario.proof);
  hand = make<HandModel>({"hand", "hand", scenario.hand.model, hand_parameters(scenario.hand, registry), {}, scenario.hand.place});
  uses.back().parameters = {};  // the hand's description stands in the hand's own file
  std::shared_ptr<const GraspSimulator> simulator;
  if (scenario.simulator) simulator = make<GraspSimulator>(*scenario.simulator);

  auto settings = AnalysisSettings::from(scenario.analysis);
  settings.most_forefingers = std::clamp(static_cast<int>(std::count_if(hand->fingers().begin(), hand->fingers().end(),
                                             [](const Finger& finger) { return finger.role != FingerRole::kThumb; })),
                                         1, kMostVirtualFingers);
  analyser = std::make_shared<PreshapeAnalyser>(PreshapeAnalyser::Models{contact, quality}, hand->dimensions(), scenario.planes,
                                                ApproachSymbols(scenario.symbols, settings.universe), settings);
  if (simulator) {
    execution = std::make_shared<GraspExecution>(GraspExecution::Parts{hand, collision, simulator, analyser, contact,
                                                                       ExecutionSettings::from(scenario.execution), scenario.seed, options.progress});
  }
  sensing = std::make_unique<EnvironmentSensing>(collision, hand->dimensions(), scenario.planes, settings);
}

void Session::State::make_agent() {
  critic = std::make_shared<InternalCritic>(similarity, tie_break, scenario.sets, Thresholds::from(scenario.thresholds));
  LearningElement::Parts parts{memory, classifier, explorer, proof, analyser, critic, LearningSettings::from(scenario.learning), scenario.seed};
  if (execution && execution->settings().reachable) {
    parts.reachable = [carry_out = execution](const SensedObject& on, const VirtualGrasp& grasp) {
      return carry_out->simulate(on, grasp).status == Simulation::Status::kReached;
    };
  }
  learning = std::make_shared<LearningElement>(std::move(parts));
  controller = std::make_unique<PreshapeController>(std::make_shared<PerformanceElement>(classifier.classifier, analyser),
                                                    critic, learning);
}

std::shared_ptr<const SensedObject> Session::State::sense(const ObjectChoice& choice) const {
  try {
    RawObject raw = read_object(choice.mesh, choice.weld);
    raw.name = choice.name;
    return sensing->sense(std::move(raw), choice.placement);
  } catch (const InputError& problem) {
    if (!choice.place.known()) throw;
    throw InputError(fmt::format("{}: {}", choice.place.text(), problem.what()));
  }
}

/// The scenario with every default filled in.
Value Session::State::resolved() const {
  Value all = scenario.description.is_table() ? scenario.description : Value{};
  Value::List quality;
  for (const auto& use : uses) {
    if (use.role == "hand") continue;
    Value component = use.parameters;
    component.set("name", use.name);
    if (use.role == "quality") quality.push_back(std::move(component));
    else all.set(use.role, std::move(component));
  }
  all.set("quality", Value::list(std::move(quality)));
  all.set("analysis", Value::table(scenario.analysis.values()));
  all.set("thresholds", Value::table(scenario.thresholds.values()));
  all.set("learning", Value::table(scenario.learning.values()));
  all.set("execution", Value::table(scenario.execution.values()));
  if (!scenario.simulator) all.set("simulator", "none");
  if (!all.find("hand")) all.set("hand", scenario.hand.name);  // a path or a description in place stays as given
  all.set("stations", Value::numbers(scenario.pretraining.stations));
  all.set("seed", static_cast<std::int64_t>(scenario.seed));
  all.set("pretrain", scenario.pretrain);
  all.set("memory", scenario.memory);
  return all;
}

Session::Session(Scenario scenario, const Registry& registry, const Catalogue& catalogue, Options options)
    : state_(std::make_unique<State>(std::move(scenario), registry, catalogue, std::move(options))) {
  Stopwatch watch;
  State& s = *state_;
  s.make_components();
  s.timings.push_back({"plugins", watch.lap()});
  s.object = s.sense(s.scenario.object);
  s.timings.push_back({"object", watch.lap()});
  s.memory = s.options.shared_memory
                 ? s.options.shared_memory
                 : open_memory(memory_path(s.options.memory.empty() ? s.scenario.memory : s.options.memory));
  s.timings.push_back({"memory", watch.lap()});
  s.make_agent();
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;

std::optional<LessonReport> Session::pretrain_if_empty() {
  State& s = *state_;
  if (s.scenario.pretrain == "none" || s.memory->statistics().samples() > 0) return std::nullopt;
  Stopwatch watch;
  const auto cube = s.sense(object_from_value(Value(s.scenario.pretrain), s.scenario.file, s.catalogue));
  auto report = s.learning->pretrain(*cube, s.scenario.pretraining, s.options.progress);
  s.timings.push_back({"pretraining", watch.lap()});
  return report;
}

LessonReport Session::pretrain() { return state_->learning->pretrain(*state_->object, state_->scenario.pretraining, state_->options.progress); }

RunRecord Session::record() const {
  const State& s = *state_;
  RunRecord record;
  record.object = s.object;
  record.scenario = s.scenario.file;
  record.description = s.resolved();
  record.components = s.uses;
  record.hand = s.scenario.hand.name;
  record.hand_dimensions = s.hand->dimensions();
  record.hand_model = s.hand;
  record.memory = s.memory->name();
  record.seed = s.scenario.seed;
  record.partition = s.critic->partition();
  record.planes = s.scenario.planes;
  for (int symbol = 1; symbol <= s.analyser->symbols().count(); ++symbol) {
    record.symbol_names.push_back(s.analyser->symbols().name(symbol));
  }
  record.quality_numbers = s.analyser->quality_numbers();
  record.scale = s.critic->scale();
  record.second_scale = s.critic->second_scale();
  record.measure = s.scenario.similarity.name;
  record.second_measure = s.scenario.tie_break.name;
  record.timings = s.timings;
  return record;
}

RunRecord Session::finish(Report report, double seconds) const {
  RunRecord result = record();
  result.report = std::move(report);
  result.timings.push_back({"controller", seconds});
  if (state_->execution && result.report.served() && result.report.result && result.report.result->grasp.is_grasp()) {
    Stopwatch watch;
    const GraspExecution& execution = *state_->execution;
    JudgedGrasp& served = *result.report.result;
    result.simulation = execution.carry_out(*state_->object, served.grasp);
    result.imparted = execution.imparted(*state_->object, served.grasp, *result.simulation);
    if (result.simulation->status != Simulation::Status::kReached) {
      result.second_try = execution.try_others(*state_->object, *state_->critic, task(), served);
    }
    result.timings.push_back({"simulation", watch.lap()});
  }
  return result;
}

const Task& Session::task() const {
  const Scenario& scenario = state_->scenario;
  if (!scenario.task) throw InputError(fmt::format("{}: 'task' is missing", scenario.file));
  return *scenario.task;
}

RunRecord Session::run() {
  Stopwatch watch;
  Report report = state_->controller->run(*state_->object, task(), state_->options.progress);
  return finish(std::move(report), watch.lap());
}

RunRecord Session::estimate() {
  Stopwatch watch;
  Report report = state_->controller->estimate(*state_->object, task());
  return finish(std::move(report), watch.lap());
}

std::vector<RunRecord> Session::run(const std::function<Value(const Value& report)>& control) {
  std::vector<RunRecord> records;
  for (;;) {
    records.push_back(run());
    if (!control) return records;
    const Value correction = control(report_value(records.back()));
    if (correction.is_nil()) return records;
    if (records.size() >= kMostCorrections) {
      throw InputError(fmt::format("'on_report' has corrected the task {} times; let it return nil to stop", kMostCorrections));
    }
    change(correction);
  }
}

void Session::change(const Value& correction) {
  State& s = *state_;
  static const std::vector<std::string> known = {"object", "task", "thresholds"};
  if (!correction.is_table()) throw InputError(fmt::format("'on_report' returns nil or a table, got {} {}", correction.kind(), correction.text()));
  for (const auto& [key, value] : correction.entries()) {
    if (key == "task") {
      s.scenario.task = task_from_value(value);
    } else if (key == "object") {
      s.object = s.sense(s.scenario.object = object_from_value(value, s.scenario.file, s.catalogue));
    } else if (key == "thresholds") {
      Value merged = Value::table(s.scenario.thresholds.values());
      for (const auto& [name, threshold] : value.is_table() ? value.entries() : Value::Table{}) merged.set(name, threshold);
      s.scenario.thresholds = threshold_schema().resolve(value.is_table() ? merged : value, value.place());
      s.make_agent();
    } else {
      throw InputError(fmt::format("'on_report' returned the unknown key '{}'{}", key, did_you_mean(key, known)));
    }
    s.scenario.description.set(key, value);
  }
  s.controller->reset();
}

std::vector<Session::WorkspaceRow> Session::workspace(double step) const {
  const State& s = *state_;
  std::vector<Station> stations;
  for (int plane = 0; plane < static_cast<int>(s.analyser->planes().size()); ++plane) {
    for (const double x : station_grid(step)) stations.push_back({plane, x, 0});
  }
  std::vector<VirtualGrasp> grasps(stations.size());
  s.analyser->analyse(*s.object, stations, grasps);
  std::vector<WorkspaceRow> rows;
  for (auto& grasp : grasps) {
    WorkspaceRow row;
    row.preshape = s.analyser->preshape(*s.object, grasp);
    if (grasp.is_grasp() && s.scenario.task) row.criticism = s.critic->judge(s.scenario.task->screw, components(grasp.resultant));
    row.grasp = std::move(grasp);
    rows.push_back(std::move(row));
  }
  return rows;
}

LearningElement::Exploration Session::best() const {
  const State& s = *state_;
  return s.learning->explore(*s.object, task(), s.options.progress);
}

LearningElement::Taught Session::taught() { return state_->learning->taught(); }

const Scenario& Session::scenario() const { return state_->scenario; }
const SensedObject& Session::object() const { return *state_->object; }
const Memory& Session::memory() const { return *state_->memory; }

}  // namespace preshape
