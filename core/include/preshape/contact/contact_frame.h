#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace preshape {

/// A fingertip's contact with the object, in the object frame O (thesis sec. 3.6).
/// n is the inward unit normal of the object, a the approach axis of the grasp (not projected into the contact
/// plane, as the thesis has it), t = n x a, so t turns over with the normal.
struct ContactFrame {
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  /// @param n inward unit normal; @param a unit approach axis
  static ContactFrame at(const Eigen::Vector3d& p_OC, const Eigen::Vector3d& n, const Eigen::Vector3d& a) {
    return {p_OC, n, a, n.cross(a)};
  }
};

}  // namespace preshape
