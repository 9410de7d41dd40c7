#pragma once

#include <memory>

#include "preshape/agent/preshape_analyser.h"
#include "preshape/agent/settings.h"
#include "preshape/grasp/simulator.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// Carries grasps out with a session's hand (thesis sec. 4.4). [any thread, const]
class GraspExecution {
 public:
  struct Parts {
    std::shared_ptr<const HandModel> hand;
    std::shared_ptr<const CollisionBackend> collision;
    std::shared_ptr<const GraspSimulator> simulator;
    std::shared_ptr<const PreshapeAnalyser> analyser;
    std::shared_ptr<const ContactModel> contact;
    ExecutionSettings settings;
    std::uint64_t seed = 1;
    Progress* progress = nullptr;  ///< may be null
  };
  explicit GraspExecution(Parts parts) : parts_(std::move(parts)) {}

  const ExecutionSettings& settings() const { return parts_.settings; }

  Simulation simulate(const SensedObject& object, const VirtualGrasp& grasp) const;
  /// The same; where the hand holds the object, the grasp's measures are taken anew with its posture.
  Simulation carry_out(const SensedObject& object, VirtualGrasp& grasp) const;
  /// The motions that the hand can give the object where a simulation ends in its holding it, else none.
  std::optional<ImpartedTwists> imparted(const SensedObject& object, const VirtualGrasp& grasp, const Simulation& simulation) const;
  /// The next-best stations that serve the task, one for each plane and approach symbol, tried until the hand carries one
  /// out.
  SecondTry try_others(const SensedObject& object, const InternalCritic& critic, const Task& task, const JudgedGrasp& first) const;

 private:
  std::vector<JudgedGrasp> serving(const SensedObject& object, const InternalCritic& critic, const Task& task) const;

  Parts parts_;
};

}  // namespace preshape
