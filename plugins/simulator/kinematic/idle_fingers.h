#pragma once

#include "bodies.h"

namespace preshape::kinematic {

/// The fingers that make no contact: they are kept out of the way.
class IdleFingers {
 public:
  IdleFingers(const SimulationTask& task, const Bodies& bodies, const Assignment& assignment, std::uint64_t seed);

  /// Opens the idle fingers of a hold as far as they go.
  void open(Hold& hold) const;

  /// Whether a collision is one of theirs.
  bool have(const Collision& collision) const;

  /// Gives each idle finger of a hold the first of its postures, the most opened one first, in which it is free of
  /// everything while the hand is open and while it holds.
  /// @returns false when there is none for a finger
  bool put_aside(Hold& hold) const;

 private:
  struct Finger {
    int index = 0;
    std::vector<int> drives;                  ///< that move no finger of the grasp
    std::vector<std::vector<double>> aside;   ///< values of the drives, the most opened first
  };
  void draw(Finger& finger, Random& random) const;
  void set(const Finger& finger, const std::vector<double>& values, Posture& posture) const;
  void set(const Finger& finger, const std::vector<double>& values, Hold& hold) const;

  const SimulationTask& task_;
  const Bodies& bodies_;
  std::vector<Finger> fingers_;
};

}  // namespace preshape::kinematic
