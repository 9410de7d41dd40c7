#include "preshape/agent/learning_element.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/agent/station_search.h"
#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "preshape/grasp/task_space.h"

namespace preshape {

namespace {

/// Two rows whose inputs differ by less than this are the same question to the classifier.
constexpr double kSameInput = 1e-6;

constexpr const char* kMeaning = "answers";  // the memory's note of what plane and symbol numbers mean

bool same_question(const Sample& a, const Sample& b) {
  for (std::size_t i = 0; i < a.inputs.size(); ++i) {
    if (std::abs(a.inputs[i] - b.inputs[i]) > kSameInput) return false;
  }
  return true;
}

bool same_answer(const Sample& a, const Sample& b) {
  return a.plane == b.plane && a.symbol == b.symbol && a.virtual_fingers == b.virtual_fingers;
}

MemoryObject memory_object(const SensedObject& sensed) {
  MemoryObject object;
  object.hash = sensed.object.hash;
  object.name = sensed.object.name;
  object.file = sensed.object.file;
  const Eigen::Vector3d extents = sensed.object.box_O.extents();
  object.extents_m = {extents.x(), extents.y(), extents.z()};
  object.attributes = sensed.attributes;
  return object;
}

}  // namespace

/// Samples as the classifier takes them.
struct LearningElement::Rows {
  RowMatrix inputs, targets;

  Rows(const std::vector<Sample>& samples, const PreshapeCode& code)
      : inputs(samples.size(), kFeatures), targets(samples.size(), code.bits()) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const Sample& sample = samples[i];
      inputs.row(row) = Eigen::Map<const Eigen::RowVectorXd>(sample.inputs.data(), kFeatures);
      targets.row(row) = code.encode({sample.plane, sample.symbol, sample.virtual_fingers}).transpose();
    }
  }
};

LearningElement::LearningElement(Parts parts)
    : parts_(std::move(parts)),
      code_(static_cast<int>(parts_.analyser->planes().size()), parts_.analyser->symbols().count()) {}

void LearningElement::recall() {
  if (parts_.memory->generation() == generation_) return;
  const auto snapshot = parts_.memory->snapshot();
  load_or_fit();
}

/// What plane and symbol numbers of the rows mean, as the memory notes it.
std::string LearningElement::meaning() const {
  std::string text;
  for (const ApproachPlane& plane : parts_.analyser->planes()) {
    for (const Eigen::Vector3d& axis : {plane.a, plane.n_f}) {
      for (const double c : axis) text += fmt::format("{:+.9f} ", c + 0.0);
    }
  }
  const ApproachSymbols& symbols = parts_.analyser->symbols();
  for (int symbol = 1; symbol <= symbols.count(); ++symbol) text += symbols.name(symbol) + ' ';
  text += parts_.analyser->settings().universe == ApproachSymbols::Universe::kHalfExtent ? "half extent" : "normalised";
  return fmt::format("{} planes, {} symbols, SHA-256 {}", parts_.analyser->planes().size(), symbols.count(), sha256_hex(text));
}

void LearningElement::require_same_meaning() const {
  const auto noted = parts_.memory->note(kMeaning);
  if (!noted || *noted == meaning()) return;
  throw InputError(fmt::format("memory '{}' was taught with other approach planes or symbols ({}; here {}), so that its "
                               "rows mean nothing to this scenario; give it a memory of its own (--memory NAME)",
                               parts_.memory->name(), *noted, meaning()));
}

void LearningElement::load_or_fit() {
  require_same_meaning();
  const std::vector<Sample> samples = parts_.memory->samples();
  const std::int64_t last = samples.empty() ? 0 : samples.back().id;
  const auto state = parts_.memory->latest_state(parts_.classifier.name);
  Classifier& classifier = *parts_.classifier.classifier;
  if (state && state->last_sample == last && state->parameters_json == parts_.classifier.parameters_json) {
    classifier.load(state->bytes);
  } else if (!samples.empty()) {
    const Rows rows(samples, code_);
    classifier.fit(rows.inputs, rows.targets, parts_.seed, nullptr);
  }
  generation_ = parts_.memory->generation();
}

void LearningElement::recall_for_learning() {
  load_or_fit();  // another process may have learned meanwhile
  // The number of a learning that is not committed may yet become that of another process' learning.
  generation_ = -1;
}

LearningElement::Taught LearningElement::taught() {
  recall();
  const std::vector<Sample> samples = parts_.memory->samples();
  Taught taught{static_cast<std::int64_t>(samples.size()), 0};
  if (samples.empty()) return taught;
  const Rows rows(samples, code_);
  RowMatrix bits(rows.targets.rows(), rows.targets.cols());
  parts_.classifier.classifier->predict(rows.inputs, bits);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Preshape wanted{samples[i].plane, samples[i].symbol, samples[i].virtual_fingers};
    taught.predicted += code_.decode(bits.row(static_cast<Eigen::Index>(i)).transpose()).preshape == wanted;
  }
  return taught;
}

bool LearningElement::reachable(const SensedObject& object, const VirtualGrasp& grasp) const {
  return !parts_.reachable || parts_.reachable(object, grasp);
}

LearningElement::Exploration LearningElement::explore(const SensedObject& object, const Task& task,
                                                      Progress* progress) const {
  StationSearch::Reachable reachable;
  if (parts_.reachable) reachable = [&](const VirtualGrasp& grasp) { return parts_.reachable(object, grasp); };
  const StationSearch search(*parts_.analyser, *parts_.critic, object, task.screw, std::move(reachable));
  Exploration exploration;
  StationScore best;
  for (const NamedExplorer* named : {&parts_.explorer, &parts_.proof}) {
    const auto found = named->explorer->explore(search, named->budget.value_or(parts_.settings.budget), parts_.seed, progress);
    exploration.evaluations += found.evaluations;
    if (!found.score.better_than(best)) continue;
    best = found.score;
    exploration.explorer = named->name;
    JudgedGrasp grasp;
    grasp.confidence = std::numeric_limits<double>::quiet_NaN();
    grasp.grasp = parts_.analyser->analyse(object, found.best);
    grasp.preshape = parts_.analyser->preshape(object, grasp.grasp);
    grasp.criticism = parts_.critic->judge(task.screw, components(grasp.grasp.resultant));
    exploration.best = std::move(grasp);
    if (parts_.critic->serves(exploration.best->criticism.first)) break;
  }
  return exploration;
}

std::optional<NearestTask> LearningElement::nearest_servable_task(const SensedObject& object, const Task& asked,
                                                                   Progress* progress) const {
  std::vector<std::pair<Criticism, Task>> candidates;
  for (const Task& task : signed_task_space()) {
    if (task.screw != asked.screw) candidates.emplace_back(parts_.critic->judge(asked.screw, task.screw), task);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const auto& a, const auto& b) { return parts_.critic->nearer(a.first, b.first); });
  double done = 0.0;
  for (auto& [similarity, task] : candidates) {
    if (progress) progress->advance("nearest task", done++ / static_cast<double>(candidates.size()), task.name);
    auto exploration = explore(object, task, nullptr);
    if (exploration.best && parts_.critic->serves(exploration.best->criticism.first)) {
      return NearestTask{task, similarity.first, std::move(*exploration.best)};
    }
  }
  return std::nullopt;
}

std::optional<Task> LearningElement::applicable_task(const Task& asked) const {
  const std::vector<Sample> samples = parts_.memory->samples();
  const bool patterns = std::any_of(samples.begin(), samples.end(),
                                    [](const Sample& s) { return s.provenance != Provenance::kTask; });
  std::optional<Task> nearest;
  Criticism nearest_criticism;
  for (const Sample& sample : samples) {
    if (patterns && sample.provenance == Provenance::kTask) continue;
    Task task;
    std::copy_n(sample.inputs.begin(), kComponents, task.screw.begin());
    task.stability = sample.inputs[6] * 6.0;
    task.manipulability = sample.inputs[7] * 6.0;
    const Criticism criticism = parts_.critic->judge(asked.screw, task.screw);
    if (!nearest || parts_.critic->nearer(criticism, nearest_criticism)) nearest = task, nearest_criticism = criticism;
  }
  return nearest;
}

Sample LearningElement::make_sample(const SensedObject& object, const VirtualGrasp& grasp, const Task& inputs,
                                    Provenance provenance, double score) const {
  const Preshape preshape = parts_.analyser->preshape(object, grasp);
  Sample sample;
  sample.object = object.object.hash;
  sample.provenance = provenance;
  sample.inputs = make_features(inputs.screw, inputs.stability, inputs.manipulability, object.attributes);
  sample.plane = preshape.plane;
  sample.symbol = preshape.symbol;
  sample.virtual_fingers = preshape.virtual_fingers;
  sample.approach_m = grasp.approach_m;
  sample.approach_ratio = grasp.approach_fraction;
  sample.wrench = components(grasp.resultant);
  sample.score = score;
  sample.task = inputs.name;
  return sample;
}

namespace {

/// A grasp's own wrench and measures as the task that it is best at.
Task own_task(const VirtualGrasp& grasp) {
  return {components(grasp.resultant), grasp.stability, grasp.manipulability, ""};
}

}  // namespace

std::int64_t LearningElement::add_rows(Learning& learning, const SensedObject& object, const std::vector<Sample>& rows) const {
  std::vector<std::int64_t> outdated;
  std::vector<bool> known(rows.size(), false);
  for (const Sample& sample : parts_.memory->samples()) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!same_question(sample, rows[i])) continue;
      // The last lesson is right: an older row that contradicts it could only stand in the way.
      if (same_answer(sample, rows[i])) known[i] = true;
      else outdated.push_back(sample.id);
    }
  }
  if (!outdated.empty()) learning.forget_samples(outdated);
  learning.add_object(memory_object(object));
  learning.set_note(kMeaning, meaning());
  std::int64_t added = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool repeated = known[i] || std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(i),
                                                  [&](const Sample& row) { return same_question(row, rows[i]); });
    if (!repeated) learning.add_sample(rows[i]), ++added;
  }
  return added;
}

TrainingOutcome LearningElement::train(Learning& learning, Progress* progress) {
  const std::vector<Sample> samples = parts_.memory->samples();
  const auto first_new = std::find_if(samples.begin(), samples.end(),
                                      [&](const Sample& s) { return s.session == learning.session(); });
  const Rows rows(samples, code_);
  Classifier& classifier = *parts_.classifier.classifier;
  const TrainingOutcome outcome =
      classifier.extend(rows.inputs, rows.targets, first_new - samples.begin(), parts_.seed, progress);
  ClassifierState state;
  state.component = parts_.classifier.name;
  state.parameters_json = parts_.classifier.parameters_json;
  state.bytes = classifier.save();
  state.last_sample = samples.back().id;
  state.outcome = outcome;
  state.seed = parts_.seed;
  learning.store_state(state);
  return outcome;
}

LearningElement::Lesson LearningElement::teach(const SensedObject& object, const Task& task, const JudgedGrasp& grasp,
                                               bool task_is_served, const std::function<bool()>& accept,
                                               Progress* progress) {
  Lesson lesson;
  Learning learning = parts_.memory->begin_learning();
  recall_for_learning();
  Classifier& classifier = *parts_.classifier.classifier;
  const std::string before = classifier.trained() ? classifier.save() : "";
  std::vector<Sample> rows;
  const auto teach = parts_.settings.teach;
  const double score = grasp.criticism.first;
  if (teach != LearningSettings::Teach::kTask || !task_is_served) {
    rows.push_back(make_sample(object, grasp.grasp, own_task(grasp.grasp), Provenance::kWrench, score));
  }
  if (teach != LearningSettings::Teach::kWrench && task_is_served) {
    rows.push_back(make_sample(object, grasp.grasp, task, Provenance::kTask, score));
  }
  lesson.report.rows_added = add_rows(learning, object, rows);
  lesson.report.training = train(learning, progress);
  lesson.accepted = accept();
  if (lesson.accepted) {
    learning.commit();
    generation_ = learning.session();
  } else if (!before.empty()) {
    classifier.load(before);
  }
  return lesson;
}

LessonReport LearningElement::pretrain(const SensedObject& object, const Pretraining& pretraining, Progress* progress) {
  LessonReport report;
  report.explorer = "pretraining";
  std::vector<Station> stations;
  for (int plane = 0; plane < static_cast<int>(parts_.analyser->planes().size()); ++plane) {
    for (const double x : pretraining.stations) stations.push_back({plane, x, 0});
  }
  std::vector<VirtualGrasp> grasps(stations.size());
  parts_.analyser->analyse(object, stations, grasps);
  std::vector<Sample> rows;
  for (const auto& grasp : grasps) {
    if (!grasp.is_grasp()) continue;
    const Task own = own_task(grasp);
    rows.push_back(make_sample(object, grasp, own, Provenance::kPretrain,
                               parts_.critic->judge(own.screw, components(grasp.resultant)).first));
  }
  if (rows.empty()) {
    throw InputError(fmt::format("object '{}' has no grasp at any pretraining station; choose another object or hand",
                                 object.object.name));
  }
  report.evaluations = static_cast<std::int64_t>(stations.size());

  Learning learning = parts_.memory->begin_learning();
  recall_for_learning();
  report.rows_added = add_rows(learning, object, rows);
  report.training = train(learning, progress);
  learning.commit();
  generation_ = learning.session();
  return report;
}

}  // namespace preshape
