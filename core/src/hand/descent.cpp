#include "descent.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace preshape {

Descent::Descent(const HandModel& hand, std::span<const FingertipTarget> targets, const Drives& drives, Configuration start)
    : hand_(hand), targets_(targets), drives_(drives), at_(std::move(start)) {
  for (int d = 0; d < drives_.count(); ++d) {
    const DriveRange& range = drives_.range(d);
    drives_.value(at_, d) = std::clamp(drives_.value(at_, d), range.lower, range.upper);
  }
  apply_couplings(hand_, at_.posture);
}

void Descent::run(const InverseKinematicsSettings& settings) {
  const bool wishes = std::any_of(targets_.begin(), targets_.end(), [](const auto& t) { return t.pointing_weight_m > 0.0; });
  if (wishes) descend(settings, true);
  descend(settings, false);
}

double Descent::residual() const {
  const Equations error = errors(at_, false);
  double largest = 0.0;
  for (Eigen::Index row = 0; row < error.size(); row += 3) largest = std::max(largest, error.segment<3>(row).norm());
  return largest;
}

void Descent::descend(const InverseKinematicsSettings& settings, bool wishes) {
  constexpr double kStalled = 1e-6;  // least share of the squared error that a step must take away
  const double enough = std::pow(0.01 * settings.tolerance_m, 2);
  double damping = 1e-3;
  Equations error = errors(at_, wishes);
  int stalls = 0;
  for (int i = 0; i < settings.iterations && error.squaredNorm() > enough && damping < 1e8 && stalls < 3; ++i) {
    const Configuration next = stepped(jacobian(wishes), error, damping);
    const Equations after = errors(next, wishes);
    const double gain = error.squaredNorm() - after.squaredNorm();
    if (gain > 0.0) {
      stalls = gain < kStalled * error.squaredNorm() ? stalls + 1 : 0;
      at_ = next, error = after;
      damping = std::max(1e-12, damping / 10);
    } else {
      damping *= 10;
    }
  }
}

Descent::Equations Descent::errors(const Configuration& at, bool wishes) const {
  const Eigen::Index each = wishes ? 6 : 3;
  const Standing standing(hand_, at.moved);
  Equations error(each * std::ssize(targets_));
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const FingertipTarget& target = targets_[i];
    const auto row = each * static_cast<Eigen::Index>(i);
    error.segment<3>(row) = target.p_HD - standing.X_HM * finger_poses(hand_, target.finger, at.posture).back().p;
    if (!wishes) continue;
    error.segment<3>(row + 3) = target.pointing_weight_m * (target.pointing_H - standing.X_HM.R * pointing_of(hand_, target.finger, at.posture));
  }
  return error;
}

/// Of all fingertips, and of their directions, with respect to the drives.
Descent::Sensitivity Descent::jacobian(bool wishes) const {
  const Eigen::Index each = wishes ? 6 : 3;
  const Standing standing(hand_, at_.moved);
  Sensitivity J = Sensitivity::Zero(each * std::ssize(targets_), drives_.count());
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const FingertipTarget& target = targets_[i];
    const Finger& finger = hand_.fingers()[static_cast<std::size_t>(target.finger)];
    Eigen::Matrix<double, 6, Eigen::Dynamic> own(6, finger.joint_count);
    hand_.jacobian(target.finger, finger_values(hand_, target.finger, at_.posture), own);
    const Eigen::Vector3d direction_M = wishes ? pointing_of(hand_, target.finger, at_.posture) : Eigen::Vector3d::Zero();
    const auto row = each * static_cast<Eigen::Index>(i);
    for (int k = 0; k < finger.joint_count; ++k) {
      const int joint = finger.first_joint + k;
      const double gain = drives_.gain(joint);
      auto column = J.col(drives_.of(joint));
      column.segment<3>(row) += gain * (standing.X_HM.R * own.col(k).head<3>());
      if (wishes) column.segment<3>(row + 3) += target.pointing_weight_m * gain * (standing.X_HM.R * Eigen::Vector3d(own.col(k).tail<3>()).cross(direction_M));
    }
    if (drives_.move_the_hand()) add_hand_columns(row, target, standing, wishes, J);
  }
  return J;
}

/// What the hand's own moves do to one fingertip: a turn about an axis w through M moves it by w x p_MD, its direction d by
/// w x d.
void Descent::add_hand_columns(Eigen::Index row, const FingertipTarget& target, const Standing& standing, bool wishes, Sensitivity& J) const {
  const Eigen::Vector3d p_MD_H = standing.X_HM.R * finger_poses(hand_, target.finger, at_.posture).back().p;
  const Eigen::Vector3d direction_H = wishes ? Eigen::Vector3d(standing.X_HM.R * pointing_of(hand_, target.finger, at_.posture)) : Eigen::Vector3d::Zero();
  for (int d = drives_.joint_drives(); d < drives_.count(); ++d) {
    const int way = drives_.way(d);
    if (way < 3) {
      J.col(d).segment<3>(row) = hand_.dimensions().unit_length_m * Eigen::Vector3d::Unit(way);
      continue;
    }
    const Eigen::Vector3d axis_H = standing.axes_H.col(way - 3);
    J.col(d).segment<3>(row) = axis_H.cross(p_MD_H);
    if (wishes) J.col(d).segment<3>(row + 3) = target.pointing_weight_m * axis_H.cross(direction_H);
  }
}

/// The configuration after a damped step, drives that would leave their ranges stopped at the ends.
Configuration Descent::stepped(Sensitivity J, Equations error, double damping) const {
  Configuration next = at_;
  const double scale = std::max(1e-300, J.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, J.cols())));
  for (;;) {
    Sensitivity normal = J.lazyProduct(J.transpose());
    normal.diagonal().array() += damping * scale + 1e-18 * scale;
    const Equations weights = normal.llt().solve(error);
    const Equations step = J.transpose().lazyProduct(weights);
    int worst = -1;
    double excess = 0.0;
    for (int d = 0; d < drives_.count(); ++d) {
      if (J.col(d).isZero(0.0)) continue;
      const double wanted = drives_.value(next, d) + step[d], kept = std::clamp(wanted, drives_.range(d).lower, drives_.range(d).upper);
      if (std::abs(wanted - kept) > excess) worst = d, excess = std::abs(wanted - kept);
    }
    if (worst < 0) {
      for (int d = 0; d < drives_.count(); ++d) {
        if (!J.col(d).isZero(0.0)) drives_.value(next, d) += step[d];
      }
      break;
    }
    const DriveRange& range = drives_.range(worst);
    const double stop = step[worst] > 0.0 ? range.upper : range.lower;
    error -= J.col(worst) * (stop - drives_.value(next, worst));
    drives_.value(next, worst) = stop;
    J.col(worst).setZero();
  }
  apply_couplings(hand_, next.posture);
  return next;
}

}  // namespace preshape
