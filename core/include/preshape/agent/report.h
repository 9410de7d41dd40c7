#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "preshape/agent/internal_critic.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/preshape.h"
#include "preshape/grasp/quality.h"
#include "preshape/grasp/task.h"
#include "preshape/grasp/virtual_grasp.h"

namespace preshape {

/// How a run ended (spec section 12).
enum class RunStatus {
  kServed,      ///< mode 0 or 1
  kRecognised,  ///< mode 2: the object is known, the task needs correction
  kLearned,     ///< mode 3: taught, then served
  kDeadlock     ///< mode 3 failed; meta control must reset
};
PRESHAPE_API std::string_view status_name(RunStatus status);

/// A preshape with the grasp that it gives and what the critic says of it before a task.
struct JudgedGrasp {
  Preshape preshape;
  double confidence = 0.0;  ///< of the classifier; NaN where it was not asked
  VirtualGrasp grasp;
  Criticism criticism;      ///< meaningful when grasp.is_grasp()
};

/// One mode that was tried.
struct ModeAttempt {
  int mode = 0;
  bool rewarded = false;
  std::string words;           ///< one sentence: what was done and what came of it
  std::optional<double> score; ///< of the deciding measure, where there was one
};

/// What mode 3 did.
struct LessonReport {
  std::int64_t evaluations = 0;  ///< stations that the explorers looked at
  std::string explorer;          ///< which found the grasp
  std::int64_t rows_added = 0;
  TrainingOutcome training;
};

/// A task of the task space that a grasp of the object serves.
struct NearestTask {
  Task task;
  double similarity = 0.0;  ///< to the task asked, by the deciding measure
  JudgedGrasp grasp;        ///< judged before `task`
};

/// Everything that a run leaves: plain data, drawn and printed by others.
struct Report {
  RunStatus status = RunStatus::kDeadlock;
  int mode = 0;
  std::string verdict;  ///< one or two sentences
  Task task;
  std::vector<ModeAttempt> attempts;
  std::optional<JudgedGrasp> result;        ///< the grasp that serves; else the best that was tried
  std::optional<NearestTask> nearest;       ///< where the task was not served
  std::optional<JudgedGrasp> unrecalled;    ///< a grasp that would serve the task, though not recalled (mode 2)
  std::optional<LessonReport> lesson;       ///< mode 3
  Thresholds thresholds;

  bool served() const { return status == RunStatus::kServed || status == RunStatus::kLearned; }
};

}  // namespace preshape
