#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "preshape/agent/preshape_controller.h"
#include "preshape/io/run_record.h"
#include "preshape/workbench/scenario.h"

namespace preshape {

/// A scenario brought to life: components made, hand and object loaded, memory open. [one thread at a time]
class PRESHAPE_API Session {
 public:
  struct Options {
    std::string memory;         ///< overrides the scenario's when not empty: a name or a path
    Progress* progress = nullptr;
    std::shared_ptr<Memory> shared_memory;  ///< used instead of a file when given
  };

  /// @throws InputError, PluginError, ScriptError
  Session(Scenario scenario, const Registry& registry, const Catalogue& catalogue, Options options);
  ~Session();
  Session(Session&&) noexcept;

  /// Teaches the scenario's pretraining object if the memory knows nothing.
  /// @returns what was taught, or none when it was not needed
  std::optional<LessonReport> pretrain_if_empty();
  /// Teaches the session's own object at the pretraining stations.
  LessonReport pretrain();

  /// Runs the controller on the session's object and task.
  RunRecord run();
  /// Modes 0 and 1 alone, with nothing learned.
  RunRecord estimate();
  /// Runs, and lets meta control look at each report and go on: `control` returns nil to stop, or a table with task,
  /// object or thresholds to change; a deadlock is reset by any change.
  std::vector<RunRecord> run(const std::function<Value(const Value& report)>& control);

  /// Meta control's change: a table with task, object and thresholds.
  /// @throws InputError on an unknown key or a wrong value
  void change(const Value& correction);

  /// A virtual grasp of the session's object with what the critic says of it before the session's task.
  struct WorkspaceRow {
    VirtualGrasp grasp;
    Preshape preshape;
    Criticism criticism;
  };
  /// Every plane at every station of the grid.
  /// @param step of the grid, over the half extent
  std::vector<WorkspaceRow> workspace(double step) const;
  /// The best grasp that the explorers find for the session's task.
  LearningElement::Exploration best() const;

  /// How much of what its memory holds the classifier predicts.
  LearningElement::Taught taught();

  const Scenario& scenario() const;
  const SensedObject& object() const;
  const Memory& memory() const;
  /// Everything about the session that a record of it carries, without a report.
  RunRecord record() const;

 private:
  RunRecord finish(Report report, double seconds) const;
  const Task& task() const;

  struct State;
  std::unique_ptr<State> state_;
};

/// Most reports that meta control sees in one run: a script that never stops correcting is stopped.
inline constexpr int kMostCorrections = 1000;

}  // namespace preshape
