#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "preshape/spatial/wrench.h"

namespace preshape {

/// V_P_E: velocity of point P of a body and its angular velocity, expressed in E. The linear part is written
/// first; axis coordinates of a screw (thesis eq. 3.7.1, which writes the angular part first).
/// Linear [m/s] or over the characteristic length, angular [rad/s].
class Twist {
 public:
  Twist() = default;
  Twist(const Eigen::Vector3d& linear, const Eigen::Vector3d& angular) : linear_(linear), angular_(angular) {}

  const Eigen::Vector3d& linear() const { return linear_; }
  const Eigen::Vector3d& angular() const { return angular_; }
  /// (vx, vy, vz, wx, wy, wz).
  Eigen::Matrix<double, 6, 1> vector() const {
    return (Eigen::Matrix<double, 6, 1>() << linear_, angular_).finished();
  }

  /// The velocity at Q of the same motion: v_Q = v_P + w x p_PQ.
  Twist shifted(const Eigen::Vector3d& p_PQ) const { return {linear_ + angular_.cross(p_PQ), angular_}; }
  Twist rotated(const Eigen::Matrix3d& R_BE) const { return {R_BE * linear_, R_BE * angular_}; }

 private:
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();
};

/// f.v + m.w: the power of a wrench along a twist at the same point and frame; zero when they are reciprocal
/// (thesis eq. 3.7.2).
inline double reciprocal_product(const Wrench& F, const Twist& V) {
  return F.force().dot(V.linear()) + F.moment().dot(V.angular());
}

}  // namespace preshape
