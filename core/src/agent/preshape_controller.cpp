#include "preshape/agent/preshape_controller.h"

#include <fmt/format.h>

#include "preshape/agent/station_search.h"
#include "preshape/base/error.h"

namespace preshape {

std::string_view status_name(RunStatus status) {
  switch (status) {
    case RunStatus::kServed: return "served";
    case RunStatus::kRecognised: return "recognised";
    case RunStatus::kLearned: return "learned";
    case RunStatus::kDeadlock: return "deadlock";
  }
  return "?";
}

PreshapeController::PreshapeController(std::shared_ptr<const PerformanceElement> performance,
                                       std::shared_ptr<const InternalCritic> critic,
                                       std::shared_ptr<LearningElement> learning)
    : performance_(std::move(performance)), critic_(std::move(critic)), learning_(std::move(learning)) {}

/// What the modes of one run share.
struct PreshapeController::Run {
  const SensedObject& object;
  const Task& task;
  Progress* progress;
  Report report;
  Performance estimate;  ///< of mode 0

  void tried(int mode, bool rewarded, std::optional<double> score, std::string words) {
    ModeAttempt& attempt = report.attempts.emplace_back();
    attempt.mode = report.mode = mode;
    attempt.rewarded = rewarded;
    attempt.words = std::move(words);
    attempt.score = score;
  }
};

JudgedGrasp PreshapeController::judged(const SensedObject& object, const Task& task, const VirtualGrasp& grasp) const {
  JudgedGrasp result;
  result.confidence = std::numeric_limits<double>::quiet_NaN();
  result.grasp = grasp;
  result.preshape = performance_->analyser().preshape(object, grasp);
  if (grasp.is_grasp()) result.criticism = critic_->judge(task.screw, components(grasp.resultant));
  return result;
}

bool PreshapeController::mode_0(Run& run) const {
  run.estimate = performance_->perform(run.object, run.task);
  JudgedGrasp result = judged(run.object, run.task, run.estimate.grasp);
  result.preshape = run.estimate.preshape;
  result.confidence = run.estimate.confidence;
  const bool grasp = result.grasp.is_grasp(), serves = grasp && critic_->serves(result.criticism.first);
  const bool rewarded = serves && learning_->reachable(run.object, result.grasp);
  const std::string recalled = fmt::format("the classifier recalls plane {}, approach {}", run.estimate.preshape.plane,
                                           performance_->analyser().symbols().name(run.estimate.preshape.symbol));
  run.tried(0, rewarded, grasp ? std::optional(result.criticism.first) : std::nullopt,
            serves && !rewarded ? recalled + ", which serves the task, but the hand does not carry it out"
            : grasp             ? recalled
                                : fmt::format("{}, but {}", recalled, result.grasp.detail));
  if (grasp) run.report.result = std::move(result);
  return rewarded;
}

bool PreshapeController::mode_1(Run& run) const {
  // The hand is asked only where the grasp would serve.
  const auto reachable = [&](const VirtualGrasp& grasp) {
    return !critic_->serves(critic_->judge(run.task.screw, components(grasp.resultant)).first) || learning_->reachable(run.object, grasp);
  };
  const StationSearch search(performance_->analyser(), *critic_, run.object, run.task.screw, reachable);
  // The extent along the approach is twice the half extent over which stations are counted.
  const double window = (1.0 - critic_->thresholds().search) * 2.0;
  const auto best = search.best_in_plane(run.estimate.preshape.plane - 1, run.estimate.grasp.approach_fraction, window);
  if (!best) {
    run.tried(1, false, std::nullopt, fmt::format("no station of plane {} has a grasp", run.estimate.preshape.plane));
    return false;
  }
  JudgedGrasp result = judged(run.object, run.task, performance_->analyser().analyse(run.object, *best));
  const bool rewarded = critic_->serves(result.criticism.first);  // and then the hand was asked, where that counts
  run.tried(1, rewarded, result.criticism.first,
            fmt::format("the best station of plane {} is x = {:+.2f} of the half extent", result.preshape.plane,
                        result.grasp.approach_fraction));
  // The station recalled need not stand on the grid: it may have been the better one, though not one that is carried out.
  const auto& recalled = run.report.result;
  if (rewarded || !recalled || !critic_->nearer(recalled->criticism, result.criticism)) run.report.result = std::move(result);
  return rewarded;
}

bool PreshapeController::mode_2(Run& run) const {
  const auto applicable = learning_->applicable_task(run.task);
  if (!applicable) {
    run.tried(2, false, std::nullopt, "nothing is remembered by which the object could be known");
    return false;
  }
  const Performance recall = performance_->perform(run.object, *applicable);
  if (!recall.grasp.is_grasp()) {
    run.tried(2, false, std::nullopt, fmt::format("asked for a remembered task, {}: the object is unknown", recall.grasp.detail));
    return false;
  }
  const double score = critic_->judge(applicable->screw, components(recall.grasp.resultant)).first;
  const bool known = critic_->recognises(score);
  run.tried(2, known, score,
            fmt::format("asked for a remembered task, the grasp recalled is {} it: the object is {}",
                        known ? "as near as a known object's to" : "not near enough to", known ? "known" : "unknown"));
  return known;
}

void PreshapeController::mode_3(Run& run) {
  auto exploration = learning_->explore(run.object, run.task, run.progress);
  LessonReport lesson;
  if (!exploration.best) {
    run.tried(3, false, std::nullopt, fmt::format("none of {} stations has a grasp{}", exploration.evaluations,
                                            learning_->asks_the_hand() ? " that the hand carries out" : ""));
    run.report.result.reset();
    return;
  }
  const JudgedGrasp best = *exploration.best;
  const bool servable = critic_->serves(best.criticism.first);
  Run test{run.object, run.task, nullptr, {}, {}};
  const auto accept = [&] {
    // A task that no station serves still teaches the object its best possible task.
    return !servable || mode_0(test) || mode_1(test);
  };
  auto taught = learning_->teach(run.object, run.task, best, servable, accept, run.progress);
  taught.report.evaluations = exploration.evaluations;
  taught.report.explorer = exploration.explorer;
  run.report.lesson = taught.report;
  if (!servable) {
    run.tried(3, false, best.criticism.first,
              fmt::format("even the best of {} stations stays under the estimation threshold", exploration.evaluations));
    run.report.result = best;
    return;
  }
  run.tried(3, taught.accepted, best.criticism.first,
            fmt::format("the {} explorer found plane {} among {} stations; {}", exploration.explorer, best.preshape.plane,
                        exploration.evaluations,
                        taught.accepted ? fmt::format("taught, it is recalled in mode {}", test.report.mode)
                                        : "taught, it is not recalled"));
  run.report.result = taught.accepted ? test.report.result : best;
}

bool PreshapeController::modes_0_and_1(Run& run) const {
  learning_->recall();
  Report& report = run.report;
  report.task = run.task;
  report.thresholds = critic_->thresholds();
  const bool served = mode_0(run) || mode_1(run);
  report.status = served ? RunStatus::kServed : RunStatus::kRecognised;
  report.verdict = !served ? "Neither the recalled preshape nor another station of its plane serves the task."
                   : report.mode == 0 ? "The recalled preshape serves the task."
                                      : "The recalled plane serves the task after a local search for the station.";
  return served;
}

Report PreshapeController::estimate(const SensedObject& object, const Task& task) {
  Run run{object, task, nullptr, {}, {}};
  modes_0_and_1(run);
  return std::move(run.report);
}

Report PreshapeController::run(const SensedObject& object, const Task& task, Progress* progress) {
  if (deadlocked_) throw InputError("the controller is in deadlock; reset it, or correct object, task or thresholds");
  Run run{object, task, progress, {}, {}};
  Report& report = run.report;
  if (modes_0_and_1(run)) return report;
  const bool known = mode_2(run);
  bool learn = !known;
  if (known) {
    const auto exploration = learning_->explore(object, task, progress);
    if (exploration.best && critic_->serves(exploration.best->criticism.first)) {
      report.unrecalled = exploration.best;
      learn = learning_->settings().policy == LearningSettings::Policy::kLearn;
    }
  }
  if (learn) {
    mode_3(run);
    const bool learned = report.attempts.back().rewarded;
    report.status = learned ? RunStatus::kLearned : RunStatus::kDeadlock;
    report.verdict = learned ? (known ? "The object is known; the new task was learned." : "The object was unknown; it was learned with this task.")
                             : "Deadlock: " + report.attempts.back().words + ".";
    deadlocked_ = !learned;
  } else {
    report.status = RunStatus::kRecognised;
    report.verdict = report.unrecalled ? "The object is recognised, but the task is not recalled although a grasp would serve it: "
                                         "correct the task, or let it be learned (learning.policy = \"learn\")."
                     : learning_->asks_the_hand() ? "The object is recognised, but no grasp of it that the hand carries out serves this task: correct "
                                                    "the task, or take another hand."
                                                  : "The object is recognised, but no grasp of it serves this task: correct the task.";
  }
  if (!report.served()) report.nearest = learning_->nearest_servable_task(object, task, progress);
  return report;
}

}  // namespace preshape
