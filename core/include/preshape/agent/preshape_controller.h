#pragma once

#include <memory>
#include <vector>

#include "preshape/agent/internal_critic.h"
#include "preshape/agent/learning_element.h"
#include "preshape/agent/performance_element.h"
#include "preshape/agent/report.h"

namespace preshape {

/// The multistate decision control (thesis secs. 3.1, 4.3; spec section 12): modes 0 to 3 in order, each entered when
/// the one before it failed. A deadlock stays until it is reset. [one thread at a time]
class PRESHAPE_API PreshapeController {
 public:
  PreshapeController(std::shared_ptr<const PerformanceElement> performance, std::shared_ptr<const InternalCritic> critic,
                     std::shared_ptr<LearningElement> learning);

  /// Serves one task on one object.
  /// @throws InputError when the controller is in deadlock, or the classifier has learned nothing
  Report run(const SensedObject& object, const Task& task, Progress* progress = nullptr);

  /// Modes 0 and 1 alone: what is recalled for the task as things stand, with nothing learned. The status is kServed or,
  /// for want of the object's recognition, kRecognised.
  Report estimate(const SensedObject& object, const Task& task);

  bool deadlocked() const { return deadlocked_; }
  void reset() { deadlocked_ = false; }

 private:
  struct Run;
  bool modes_0_and_1(Run& run) const;
  bool mode_0(Run& run) const;
  bool mode_1(Run& run) const;
  bool mode_2(Run& run) const;
  void mode_3(Run& run);
  JudgedGrasp judged(const SensedObject& object, const Task& task, const VirtualGrasp& grasp) const;

  std::shared_ptr<const PerformanceElement> performance_;
  std::shared_ptr<const InternalCritic> critic_;
  std::shared_ptr<LearningElement> learning_;
  bool deadlocked_ = false;
};

}  // namespace preshape
