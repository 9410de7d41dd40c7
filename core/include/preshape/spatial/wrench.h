#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace preshape {

/// F_P_E: a force and a moment about point P, expressed in frame E. Force before moment, as in the grasp
/// textbooks [MurrayLiSastry1994, ch. 5]; ray coordinates of a screw (thesis eq. 3.6.3).
/// Force [N] and moment [N m], or moment over the characteristic length where a name ends in `_normalised`.
class Wrench {
 public:
  Wrench() = default;
  Wrench(const Eigen::Vector3d& force, const Eigen::Vector3d& moment) : force_(force), moment_(moment) {}
  static Wrench from_vector(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& fm) {
    return {fm.head<3>(), fm.tail<3>()};
  }

  const Eigen::Vector3d& force() const { return force_; }
  const Eigen::Vector3d& moment() const { return moment_; }
  /// (fx, fy, fz, mx, my, mz).
  Eigen::Matrix<double, 6, 1> vector() const {
    return (Eigen::Matrix<double, 6, 1>() << force_, moment_).finished();
  }

  /// The same wrench about Q instead of P: F_Q = (f, m - p_PQ x f). Poinsot's theorem, thesis eq. 3.6.7.
  /// @param p_PQ from P to Q in the wrench's frame, in the length unit of the moment
  Wrench shifted(const Eigen::Vector3d& p_PQ) const { return {force_, moment_ - p_PQ.cross(force_)}; }
  /// The same wrench expressed in B, R_BE given.
  Wrench rotated(const Eigen::Matrix3d& R_BE) const { return {R_BE * force_, R_BE * moment_}; }

  /// Sum of two wrenches about the same point in the same frame.
  Wrench operator+(const Wrench& other) const { return {force_ + other.force_, moment_ + other.moment_}; }
  Wrench& operator+=(const Wrench& other) { return *this = *this + other; }
  Wrench operator*(double scale) const { return {scale * force_, scale * moment_}; }

 private:
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment_ = Eigen::Vector3d::Zero();
};

}  // namespace preshape
