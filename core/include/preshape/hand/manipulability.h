#pragma once

#include <Eigen/Core>

#include "preshape/hand/posture.h"

namespace preshape {

/// How well a fingertip can be moved in a posture, from the linear rows of the fingertip's Jacobian with respect to its
/// drives.
struct Manipulability {
  double measure = 0.0;               ///< sqrt(det(J J')) [Yoshikawa1985], the product of the singular values [m^3]
  Eigen::Vector3d singular_values = Eigen::Vector3d::Zero();  ///< [m], largest first; below three drives the rest is 0
  Eigen::Matrix3d axes_H = Eigen::Matrix3d::Identity();       ///< of the velocity ellipsoid, a column for each
};
PRESHAPE_API Manipulability manipulability(const HandModel& hand, int finger, std::span<const double> posture);

/// Jacobian of one fingertip with respect to the hand's drives (driven_joints): 6 x drives, linear rows first, joints
/// that follow counted with their leaders.
PRESHAPE_API Eigen::Matrix<double, 6, Eigen::Dynamic> drive_jacobian(const HandModel& hand, int finger,
                                                                     std::span<const double> posture);

}  // namespace preshape
