#include "io/run_approach.h"

namespace preshape {

std::optional<ApproachVolume> approach_volume_of(const RunRecord& record, const VirtualGrasp& grasp,
                                                 const Simulation& simulation) {
  std::vector<int> fingers;
  for (const FingerOutcome& outcome : simulation.fingers) {
    if (outcome.finger >= 0) fingers.push_back(outcome.finger);
  }
  if (!record.hand_model || simulation.path.empty() || fingers.size() < 2) return std::nullopt;
  const ApproachPlane& plane = record.planes[static_cast<std::size_t>(grasp.plane)];
  return approach_volume(
      {*record.hand_model, simulation.X_OH, simulation.path.front(), fingers, plane.a, plane.n_f});
}

}  // namespace preshape
