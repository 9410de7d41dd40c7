#pragma once

#include <Eigen/Core>

namespace preshape {

/// X_AB: pose of frame B in frame A. R = R_AB, p = p_AB in A [m]. Plain members, so that its layout does not
/// depend on a compiler's vector flags.
struct Pose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();

  /// X_AB * p_BC = p_AC.
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_BC) const { return R * p_BC + p; }
  /// X_AB * X_BC = X_AC.
  Pose operator*(const Pose& X_BC) const { return {R * X_BC.R, R * X_BC.p + p}; }
  /// X_BA.
  Pose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
};

}  // namespace preshape
