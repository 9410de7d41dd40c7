#pragma once

#include <optional>
#include <set>
#include <utility>

#include "reach.h"

namespace preshape::kinematic {

/// The hand's solids among everything that they may run into.
class Bodies {
 public:
  explicit Bodies(const SimulationTask& task);

  /// What a posture runs into first, or none: the support, the object (the last links of `touching` fingers may touch it),
  /// or another solid of the hand.
  /// @param touching fingers whose last links may be at the object
  std::optional<Collision> first(const Pose& X_OH, const Posture& posture, const std::vector<int>& touching) const;

  /// "the middle finger's link 2".
  std::string name(int solid) const;
  std::string other_name(int other) const;

 private:
  std::vector<PosedSolid> posed(const Pose& X_OH, const Posture& posture) const;
  std::optional<Collision> with_support(const std::vector<PosedSolid>& solids_O) const;
  std::optional<Collision> with_object(const std::vector<PosedSolid>& solids_O, const std::vector<int>& touching) const;
  std::optional<Collision> with_itself(const std::vector<PosedSolid>& solids_O) const;
  std::vector<std::pair<int, int>> candidate_pairs() const;
  double distance(const std::vector<PosedSolid>& solids, std::pair<int, int> pair) const;

  const SimulationTask& task_;
  std::vector<std::pair<int, int>> pairs_;  ///< of the hand's solids that could meet and do not always
};

}  // namespace preshape::kinematic
