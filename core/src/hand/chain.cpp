#include "preshape/hand/chain.h"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {

/// X_HJ * Z(q), where Z turns about or slides along z.
Pose moved(const Pose& X_HJ, bool prismatic, double q) {
  if (prismatic) return {X_HJ.R, X_HJ.p + q * X_HJ.R.col(2)};
  const double c = std::cos(q), s = std::sin(q);
  Pose X_HM = X_HJ;
  X_HM.R.col(0) = c * X_HJ.R.col(0) + s * X_HJ.R.col(1);
  X_HM.R.col(1) = c * X_HJ.R.col(1) - s * X_HJ.R.col(0);
  return X_HM;
}

void demand_size(const char* what, std::size_t given, std::size_t needed) {
  if (given != needed) {
    throw InputError(fmt::format("a finger's chain needs {} {}, got {}", needed, what, given));
  }
}

}  // namespace

Chain::Chain(const Pose& X_HB, std::vector<ChainJoint> joints, const Pose& X_LD)
    : X_HB_(X_HB), joints_(std::move(joints)), X_LD_(X_LD) {}

void Chain::forward(std::span<const double> q, std::span<Pose> poses_H) const {
  demand_size("joint values", q.size(), joints_.size());
  demand_size("poses", poses_H.size(), joints_.size() + 2);
  poses_H[0] = X_HB_;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& joint = joints_[i];
    poses_H[i + 1] = moved(poses_H[i] * joint.X_PJ, joint.prismatic, q[i]) * joint.X_JL;
  }
  poses_H.back() = poses_H[joints_.size()] * X_LD_;
}

void Chain::jacobian(std::span<const double> q, Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const {
  demand_size("joint values", q.size(), joints_.size());
  demand_size("columns of the Jacobian", static_cast<std::size_t>(jacobian.cols()), joints_.size());
  // The tip is known only after the last joint, so each column first keeps its joint's point and axis.
  Pose X_HL = X_HB_;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ChainJoint& joint = joints_[i];
    const Pose X_HJ = X_HL * joint.X_PJ;
    jacobian.col(static_cast<Eigen::Index>(i)) << X_HJ.p, X_HJ.R.col(2);
    X_HL = moved(X_HJ, joint.prismatic, q[i]) * joint.X_JL;
  }
  const Eigen::Vector3d p_HD = X_HL * X_LD_.p;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    auto column = jacobian.col(static_cast<Eigen::Index>(i));
    const Eigen::Vector3d p_HJ = column.head<3>(), axis = column.tail<3>();
    if (joints_[i].prismatic) {
      column << axis, Eigen::Vector3d::Zero();
    } else {
      column.head<3>() = axis.cross(p_HD - p_HJ);
    }
  }
}

}  // namespace preshape
