#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "preshape/agent/internal_critic.h"
#include "preshape/agent/memory.h"
#include "preshape/agent/performance_element.h"
#include "preshape/agent/report.h"
#include "preshape/agent/settings.h"
#include "preshape/grasp/explorer.h"

namespace preshape {

/// An explorer with the name that reports give it.
struct NamedExplorer {
  std::string name;
  std::shared_ptr<const Explorer> explorer;
  std::optional<std::int64_t> budget = {};  ///< most stations of one exploration; none: LearningSettings::budget
};

/// The classifier with what identifies its states in a memory.
struct NamedClassifier {
  std::string name;
  std::string parameters_json;  ///< resolved; a state made with others is not used
  std::shared_ptr<Classifier> classifier;
};

/// Stations that a pretraining set teaches (spec section 8).
struct Pretraining {
  std::vector<double> stations = {-0.25, 0.25};  ///< over the half extent
};

/// The agent's learning element (thesis sec. 3.1): the fuzzy explorer as problem generator, and supervised training of
/// the classifier with what was found. It alone changes the memory. [one thread at a time]
class PRESHAPE_API LearningElement {
 public:
  struct Parts {
    std::shared_ptr<Memory> memory;
    NamedClassifier classifier;
    NamedExplorer explorer;  ///< the problem generator
    NamedExplorer proof;     ///< asked when the first finds nothing that serves
    std::shared_ptr<const PreshapeAnalyser> analyser;
    std::shared_ptr<const InternalCritic> critic;
    LearningSettings settings;
    std::uint64_t seed = 1;
    /// When given, only grasps that it accepts count: what explorers find, and what is recalled.
    std::function<bool(const SensedObject& object, const VirtualGrasp& grasp)> reachable = {};
  };
  explicit LearningElement(Parts parts);

  /// Brings the classifier to what the memory holds: its newest state, or a fit of all samples where that is older
  /// or was made with other parameters. Cheap when nothing changed. Leaves it as it is when the memory is empty.
  void recall();

  /// How many of the memory's rows the classifier predicts: plane, symbol and finger count all right.
  struct Taught {
    std::int64_t rows = 0, predicted = 0;
  };
  Taught taught();

  /// The best grasp of the object for a task that the explorers find, or none. When the first explorer's best does
  /// not serve, the second's is taken if better.
  struct Exploration {
    std::optional<JudgedGrasp> best;
    std::int64_t evaluations = 0;
    std::string explorer;
  };
  Exploration explore(const SensedObject& object, const Task& task, Progress* progress) const;

  /// Whether grasps count only when the hand carries them out.
  bool asks_the_hand() const { return parts_.reachable != nullptr; }
  /// Whether the hand carries a grasp out, where that counts; else yes.
  bool reachable(const SensedObject& object, const VirtualGrasp& grasp) const;

  /// The task of the signed task space nearest to `task` (itself excepted) that some grasp of the object serves.
  std::optional<NearestTask> nearest_servable_task(const SensedObject& object, const Task& task,
                                                   Progress* progress = nullptr) const;

  /// The remembered pattern nearest to a task: resultant wrenches of taught and pretraining grasps, all rows where
  /// there are none. As a task, with the stability and manipulability that it was taught with.
  std::optional<Task> applicable_task(const Task& task) const;

  /// One lesson as one transaction: rows of the grasp, training, the new state. Rows with the same inputs and other
  /// targets are superseded. `accept` is asked with the newly trained classifier in place; unless it agrees, memory and
  /// classifier are as before.
  struct Lesson {
    bool accepted = false;
    LessonReport report;
  };
  Lesson teach(const SensedObject& object, const Task& task, const JudgedGrasp& grasp, bool task_is_served,
               const std::function<bool()>& accept, Progress* progress);

  /// Teaches two stations of every plane of an object, with their own wrenches as tasks (spec section 8), as one
  /// transaction. @returns how the training went; rows_added counts the stations that have a grasp
  LessonReport pretrain(const SensedObject& object, const Pretraining& pretraining, Progress* progress);

  const Memory& memory() const { return *parts_.memory; }
  const LearningSettings& settings() const { return parts_.settings; }

 private:
  struct Rows;
  std::string meaning() const;
  void require_same_meaning() const;
  void load_or_fit();
  void recall_for_learning();
  Sample make_sample(const SensedObject& object, const VirtualGrasp& grasp, const Task& inputs, Provenance provenance,
                     double score) const;
  std::int64_t add_rows(Learning& learning, const SensedObject& object, const std::vector<Sample>& rows) const;
  TrainingOutcome train(Learning& learning, Progress* progress);

  Parts parts_;
  PreshapeCode code_;
  std::int64_t generation_ = -1;  ///< of the memory, as recalled
};

}  // namespace preshape
