#include "preshape/hand/posture.h"

#include <algorithm>

#include "preshape/base/require.h"

namespace preshape {

std::vector<int> driven_joints(const HandModel& hand) {
  std::vector<int> driven;
  for (std::size_t i = 0; i < hand.joints().size(); ++i) {
    if (hand.joints()[i].leader < 0) driven.push_back(static_cast<int>(i));
  }
  return driven;
}

void apply_couplings(const HandModel& hand, std::span<double> posture) {
  require_size("posture", hand.joints().size(), posture.size());
  for (std::size_t i = 0; i < posture.size(); ++i) {
    const Joint& joint = hand.joints()[i];
    if (joint.leader >= 0) posture[i] = joint.ratio * posture[static_cast<std::size_t>(joint.leader)] + joint.offset;
  }
}

DriveRange drive_range(const HandModel& hand, int driven_joint) { return drive_range(hand.joints(), driven_joint); }

DriveRange drive_range(std::span<const Joint> joints, int driven_joint) {
  const Joint& own = joints[static_cast<std::size_t>(driven_joint)];
  DriveRange range{own.lower, own.upper};
  for (const Joint& joint : joints) {
    if (joint.leader != driven_joint || joint.ratio == 0.0) continue;
    const double a = (joint.lower - joint.offset) / joint.ratio, b = (joint.upper - joint.offset) / joint.ratio;
    range.lower = std::max(range.lower, std::min(a, b));
    range.upper = std::min(range.upper, std::max(a, b));
  }
  return range;
}

Posture middle_posture(const HandModel& hand) {
  Posture posture(hand.joints().size(), 0.0);
  for (const int joint : driven_joints(hand)) {
    const DriveRange range = drive_range(hand, joint);
    posture[static_cast<std::size_t>(joint)] = 0.5 * (range.lower + range.upper);
  }
  apply_couplings(hand, posture);
  return posture;
}

bool within_limits(const HandModel& hand, std::span<const double> posture, double tolerance) {
  require_size("posture", hand.joints().size(), posture.size());
  for (std::size_t i = 0; i < posture.size(); ++i) {
    const Joint& joint = hand.joints()[i];
    if (!(posture[i] >= joint.lower - tolerance && posture[i] <= joint.upper + tolerance)) return false;
  }
  return true;
}

std::span<const double> finger_values(const HandModel& hand, int finger, std::span<const double> posture) {
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  return posture.subspan(static_cast<std::size_t>(about.first_joint), static_cast<std::size_t>(about.joint_count));
}

std::vector<Pose> finger_poses(const HandModel& hand, int finger, std::span<const double> posture) {
  const auto q = finger_values(hand, finger, posture);
  std::vector<Pose> poses_H(q.size() + 2);
  hand.forward(finger, q, poses_H);
  return poses_H;
}

}  // namespace preshape
