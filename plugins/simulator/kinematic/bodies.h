#pragma once

#include <optional>
#include <span>
#include <utility>

#include "reach.h"

namespace preshape::kinematic {

/// How far solids were from the object where they were last looked at. A solid that has moved less since is still off it.
struct LastSeen {
  struct Place {
    Pose X_OS;
    double distance_m = 0.0;
  };
  std::vector<Place> places;  ///< one a solid of the hand; empty before the first look
};

/// The hand's solids among everything that they may run into.
class Bodies {
 public:
  explicit Bodies(const SimulationTask& task);

  /// What a posture runs into first, or none: the support, the object (the last links of `touching` fingers may touch it),
  /// or another solid of the hand.
  /// @param touching fingers whose last links may be at the object
  /// @param seen of the motion that the posture is of; saves looking where nothing can have changed
  std::optional<Collision> first(const Pose& X_OH, const Posture& posture, const std::vector<int>& touching, LastSeen& seen) const;

  /// Whether one finger is off the object, the support and every other solid of the hand.
  bool finger_is_free(const Pose& X_OH, const Posture& posture, int finger) const;

  /// "link 2 of the middle".
  std::string name(int solid) const;
  std::string other_name(int other) const;

 private:
  std::vector<PosedSolid> posed(const Pose& X_OH, const Posture& posture) const;
  std::optional<Collision> with_support(const std::vector<PosedSolid>& solids_O) const;
  std::optional<Collision> with_object(const std::vector<PosedSolid>& solids_O, const std::vector<int>& touching, LastSeen& seen) const;
  void look(const std::vector<PosedSolid>& solids_O, LastSeen& seen) const;
  std::optional<Collision> with_itself(const std::vector<PosedSolid>& solids_O, std::span<const std::pair<int, int>> pairs) const;
  std::vector<std::pair<int, int>> candidate_pairs() const;
  double distance(const std::vector<PosedSolid>& solids, std::pair<int, int> pair) const;

  const SimulationTask& task_;
  std::vector<std::pair<int, int>> pairs_;  ///< of the hand's solids that could meet and do not always
  std::vector<std::vector<int>> solids_of_;  ///< per finger
  std::vector<std::vector<std::pair<int, int>>> pairs_of_;  ///< per finger: those of `pairs_` with a solid of it
};

}  // namespace preshape::kinematic
