#pragma once

#include <vector>

#include "../context.h"
#include "preshape/hand/hand_model.h"

namespace preshape::conformance {

/// Poses of one finger at q: base, links, tip.
std::vector<Pose> poses_at(const HandModel& hand, int finger, const std::vector<double>& q);
Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian_at(const HandModel& hand, int finger,
                                                     const std::vector<double>& q);

/// The joints of one finger.
std::span<const Joint> joints_of(const HandModel& hand, int finger);
/// Joint values of one finger, in the middle `share` of their limits.
std::vector<double> posture(const HandModel& hand, int finger, Random& random, double share = 1.0);
/// Length of a finger [m]: from frame to frame, and what its prismatic joints add.
double reach(const HandModel& hand, int finger);

/// The middle of the limits.
std::vector<double> middle_posture(const HandModel& hand, int finger);

/// One joint's motion, seen in H at the middle posture: exp(xi (q - middle)) turns about an axis through a
/// point, or slides along the axis.
struct JointScrew {
  bool prismatic = false;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero(), point = Eigen::Vector3d::Zero();
  double flaw = 0.0;  ///< how far the joint's motion is from that of such a screw
  Pose exp(double by) const;
};
/// Measured from the forward kinematics of single joints, within their limits.
std::vector<JointScrew> measured_screws(const HandModel& hand, int finger);

/// Largest difference of two poses: of the entries of R, and of p over `length`.
double difference(const Pose& a, const Pose& b, double length);

std::string finger_text(const HandModel& hand, int finger, const std::vector<double>& q);

}  // namespace preshape::conformance
