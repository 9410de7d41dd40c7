#pragma once

#include <Eigen/Geometry>

#include "preshape/hand/chain.h"

namespace preshape::dh {

/// A rotation that takes the z axis to a direction. One that is nearly -z is turned over first: the shortest
/// turn would lose digits there.
inline Eigen::Matrix3d z_along(const Eigen::Vector3d& direction) {
  const bool over = direction.z() < 0.0;
  const Eigen::Vector3d up = over ? Eigen::Vector3d(-direction) : direction;
  const Eigen::Matrix3d R =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
  return over ? Eigen::Matrix3d(R * Eigen::Vector3d(1, -1, -1).asDiagonal()) : R;
}

/// Roll, pitch, yaw [rad]: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).
inline Eigen::Matrix3d turned(const Eigen::Vector3d& rpy) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return (AngleAxisd(rpy.z(), Vector3d::UnitZ()) * AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

/// A joint about, or along, an axis of its own frame. The moved link's frame is the joint's at q = 0.
/// @param X_PJ of the joint's frame in that of the link before; @param axis_J of any length but zero
inline ChainJoint joint_about(const Pose& X_PJ, const Eigen::Vector3d& axis_J, bool prismatic) {
  const Eigen::Matrix3d R_JA = z_along(axis_J);
  return {prismatic, {X_PJ.R * R_JA, X_PJ.p}, {R_JA.transpose(), Eigen::Vector3d::Zero()}};
}

}  // namespace preshape::dh
