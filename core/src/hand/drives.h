#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "preshape/hand/inverse_kinematics.h"

namespace preshape {

/// What inverse kinematics looks for: the joints, and how far the hand has moved [U, rad].
struct Configuration {
  Posture posture;
  Eigen::Matrix<double, 6, 1> moved = Eigen::Matrix<double, 6, 1>::Zero();  ///< along, then about x, y, z
};

/// What may be chosen to bring some fingers to their targets, and how far each may go: the drives of their joints, then
/// the ways in which the hand itself is free. Not owning.
class Drives {
 public:
  Drives(const HandModel& hand, std::span<const FingertipTarget> targets, const HandFreedom& freedom = {});

  int count() const { return static_cast<int>(ranges_.size()); }
  int joint_drives() const { return static_cast<int>(joints_.size()); }
  int joint(int drive) const { return joints_[static_cast<std::size_t>(drive)]; }
  /// Of a drive that moves the hand: 0 .. 2 along x, y, z; 3 .. 5 about them.
  int way(int drive) const { return ways_[static_cast<std::size_t>(drive - joint_drives())]; }
  bool move_the_hand() const { return !ways_.empty(); }
  const DriveRange& range(int drive) const { return ranges_[static_cast<std::size_t>(drive)]; }
  /// The drive that moves a joint, and how much it does.
  int of(int joint) const { return place_[static_cast<std::size_t>(leader(joint))]; }
  double gain(int joint) const;

  double& value(Configuration& at, int drive) const {
    return drive < joint_drives() ? at.posture[static_cast<std::size_t>(joint(drive))] : at.moved[way(drive)];
  }
  double value(const Configuration& at, int drive) const {
    return drive < joint_drives() ? at.posture[static_cast<std::size_t>(joint(drive))] : at.moved[way(drive)];
  }

 private:
  int leader(int joint) const;
  void add(int joint);

  const HandModel& hand_;
  std::vector<int> place_, joints_, ways_;  ///< drive of each leader; leader of each drive; ways of those that follow
  std::vector<DriveRange> ranges_;
};

/// Where a hand that has moved stands, and the axes that its turns went about, all in H.
struct Standing {
  Standing(const HandModel& hand, const Eigen::Matrix<double, 6, 1>& moved);
  Pose X_HM;
  Eigen::Matrix3d axes_H;
};

}  // namespace preshape
