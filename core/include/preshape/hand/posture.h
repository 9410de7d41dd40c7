#pragma once

#include <span>
#include <vector>

#include "preshape/hand/hand_model.h"

namespace preshape {

/// A value for each joint of a hand, in the order of HandModel::joints() [rad or m].
using Posture = std::vector<double>;

/// The joints that have a drive of their own, ascending: a posture is theirs to choose, the others follow.
PRESHAPE_API std::vector<int> driven_joints(const HandModel& hand);

/// Sets every joint that follows another to what its leader gives.
/// @throws InputError when `posture` has not a value for each joint
PRESHAPE_API void apply_couplings(const HandModel& hand, std::span<double> posture);

/// What a drive may do without taking its own joint or one that follows beyond a limit [rad or m]; empty (lower above
/// upper) when the couplings leave nothing.
struct DriveRange {
  double lower = 0.0, upper = 0.0;
};
PRESHAPE_API DriveRange drive_range(const HandModel& hand, int driven_joint);
PRESHAPE_API DriveRange drive_range(std::span<const Joint> joints, int driven_joint);

/// The middle of every drive's range, followers with their leaders.
PRESHAPE_API Posture middle_posture(const HandModel& hand);

/// Whether all joints are within their limits, to `tolerance` [rad or m].
PRESHAPE_API bool within_limits(const HandModel& hand, std::span<const double> posture, double tolerance = 0.0);

/// One finger's values.
PRESHAPE_API std::span<const double> finger_values(const HandModel& hand, int finger, std::span<const double> posture);

/// Poses in H of all links of one finger: base, after each joint, tip.
PRESHAPE_API std::vector<Pose> finger_poses(const HandModel& hand, int finger, std::span<const double> posture);

}  // namespace preshape
