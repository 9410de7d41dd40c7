#pragma once

#include "idle_fingers.h"

namespace preshape::kinematic {

struct TrialSettings {
  double tolerance_m = 0.0;  ///< of a fingertip from its place
  double way_m = 0.0;        ///< along its own z axis that the open hand must be free to come
  double way_step_m = 0.0;   ///< of the places in which it is looked at there
};

/// Goes through the whole motion of a hold and says how it ends. Not owning.
class Trial {
 public:
  Trial(const SimulationTask& task, const Bodies& bodies, const IdleFingers& idle, const TrialSettings& settings)
      : task_(task), bodies_(bodies), idle_(idle), settings_(settings) {}

  /// @param hold its idle fingers are put out of the way
  Simulation of(Hold& hold) const;

 private:
  std::optional<Collision> freed_way(Hold& hold, Simulation& simulation) const;
  std::optional<Collision> on_the_way(const Hold& hold, Simulation& simulation) const;
  std::vector<FingerOutcome> outcomes(const Hold& hold) const;
  std::string unreached(const Simulation& simulation) const;
  std::string through_the_object(const Hold& hold) const;
  std::string met(const Collision& collision, const Simulation& simulation) const;

  const SimulationTask& task_;
  const Bodies& bodies_;
  const IdleFingers& idle_;
  const TrialSettings& settings_;
};

}  // namespace preshape::kinematic
