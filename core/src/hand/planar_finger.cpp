#include "preshape/hand/planar_finger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace preshape {

namespace {

constexpr double kParallel = 1e-9;  // sine of an angle that counts as none
constexpr double kPi = std::numbers::pi;

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

Eigen::Vector3d turned(const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& v) {
  return Eigen::AngleAxisd(angle, axis) * v;
}

/// A point of a joint's axis: the foot of the perpendicular from the tip. The Jacobian's column is (z x (D - p); z).
Eigen::Vector3d foot_of_tip(const Eigen::Vector3d& p_HD, const Eigen::Vector3d& z, const Eigen::Vector3d& v) {
  return p_HD - v.cross(z);
}

Eigen::Vector2d rotated(const Eigen::Vector2d& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

std::optional<PlanarFinger> PlanarFinger::recognise(const HandModel& hand, int finger) {
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  if (about.joint_count != 4) return std::nullopt;
  const std::array<double, 4> zero{};
  std::vector<Pose> poses(6);
  hand.forward(finger, zero, poses);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 4);
  hand.jacobian(finger, zero, J);
  PlanarFinger planar;
  for (std::size_t i = 0; i < 4; ++i) {
    const Joint& joint = hand.joints()[static_cast<std::size_t>(about.first_joint) + i];
    if (joint.prismatic || joint.leader >= 0) return std::nullopt;
    planar.lower_[i] = joint.lower, planar.upper_[i] = joint.upper;
  }
  const Eigen::Vector3d tip = poses.back().p;
  const auto axis = [&](Eigen::Index i) -> Eigen::Vector3d { return J.col(i).tail<3>(); };
  planar.z1_ = axis(0);
  planar.n_ = axis(1);
  const bool parallel = axis(2).cross(planar.n_).norm() < kParallel && axis(3).cross(planar.n_).norm() < kParallel &&
                        axis(2).dot(planar.n_) > 0.0 && axis(3).dot(planar.n_) > 0.0;
  if (!parallel || std::abs(planar.z1_.dot(planar.n_)) > kParallel) return std::nullopt;
  planar.p1_ = foot_of_tip(tip, planar.z1_, J.col(0).head<3>());
  planar.d_ = planar.n_.dot(tip - planar.p1_);
  planar.e1_ = planar.z1_;
  planar.e2_ = planar.n_.cross(planar.e1_);
  std::array<Eigen::Vector3d, 4> points;  // of the flexion axes and the tip, all in the plane of the tip
  for (int i = 0; i < 3; ++i) points[static_cast<std::size_t>(i)] = foot_of_tip(tip, planar.n_, J.col(i + 1).head<3>());
  points[3] = tip;
  planar.p2_ = points[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d link = points[i + 1] - points[i];
    planar.link_[i] = {planar.e1_.dot(link), planar.e2_.dot(link)};
  }
  return planar;
}

std::vector<double> PlanarFinger::abductions(const Eigen::Vector3d& p_HD) const {
  const Eigen::Vector3d r = p_HD - p1_;
  // n(q1) = n cos q1 + (z1 x n) sin q1, since n is at right angles to z1.
  const double A = n_.dot(r), B = z1_.cross(n_).dot(r), length = std::hypot(A, B);
  if (length < std::abs(d_) || length == 0.0) {
    // A tip on the abduction axis is in the plane at any angle, unless the links stand off it.
    if (length == 0.0 && std::abs(d_) == 0.0) return {0.0};
    return {};
  }
  const double middle = std::atan2(B, A), off = std::acos(std::clamp(d_ / length, -1.0, 1.0));
  return {wrapped(middle + off), wrapped(middle - off)};
}

std::vector<PlanarFinger::Values> PlanarFinger::solve(const Eigen::Vector3d& p_HD, double phi) const {
  std::vector<Values> all;
  for (const double q1 : abductions(p_HD)) {
    const Eigen::Vector3d r = p1_ + turned(z1_, -q1, p_HD - p1_) - p2_;
    const Eigen::Vector2d wrist = Eigen::Vector2d(e1_.dot(r), e2_.dot(r)) - rotated(link_[2], phi);
    const double a = link_[0].norm(), b = link_[1].norm(), w = wrist.norm();
    if (a == 0.0 || b == 0.0) continue;
    const double cosine = (w * w - a * a - b * b) / (2.0 * a * b);
    if (std::abs(cosine) > 1.0 + 1e-12) continue;
    const double bend = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double elbow : {bend, -bend}) {
      // `elbow` is the angle from the first link to the second; at q = 0 it is that of the links as built.
      const double q3 = wrapped(elbow - (angle_of(link_[1]) - angle_of(link_[0])));
      const Eigen::Vector2d reach = link_[0] + rotated(link_[1], q3);
      const double q2 = wrapped(angle_of(wrist) - angle_of(reach));
      all.push_back({q1, q2, q3, wrapped(phi - q2 - q3)});
      if (bend == 0.0) break;
    }
  }
  return all;
}

std::optional<PlanarFinger::Values> PlanarFinger::solve_within_limits(const Eigen::Vector3d& p_HD, const Values& preferred) const {
  constexpr int kSteps = 240;
  constexpr double kSlack = 1e-12;
  std::optional<Values> best;
  double least = std::numeric_limits<double>::infinity(), best_phi = 0.0;
  const auto look_at = [&](double phi) {
    for (const Values& values : solve(p_HD, phi)) {
      double distance = 0.0;
      bool within = true;
      for (std::size_t i = 0; i < 4; ++i) {
        within = within && values[i] >= lower_[i] - kSlack && values[i] <= upper_[i] + kSlack;
        distance += (values[i] - preferred[i]) * (values[i] - preferred[i]);
      }
      if (within && distance < least) least = distance, best = values, best_phi = phi;
    }
  };
  const double low = lower_[1] + lower_[2] + lower_[3], high = upper_[1] + upper_[2] + upper_[3];
  double step = (high - low) / kSteps;
  for (int i = 0; i <= kSteps; ++i) look_at(low + i * step);
  look_at(preferred[1] + preferred[2] + preferred[3]);
  for (int refinement = 0; best && refinement < 40; ++refinement, step /= 2) {
    const double around = best_phi;
    look_at(around - step / 2);
    look_at(around + step / 2);
  }
  return best;
}

}  // namespace preshape
