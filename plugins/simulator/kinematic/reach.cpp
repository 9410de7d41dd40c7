#include "reach.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace preshape::kinematic {

namespace {

/// Direction in H from a finger's last joint to its tip, zero where that joint slides or the tip is on its axis.
Eigen::Vector3d pointing(const HandModel& hand, int finger, const Posture& posture) {
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, about.joint_count);
  hand.jacobian(finger, finger_values(hand, finger, posture), J);
  const Eigen::Matrix<double, 6, 1> last = J.rightCols<1>();
  const Eigen::Vector3d from_axis = last.head<3>().cross(last.tail<3>());
  return from_axis.norm() > 1e-9 ? Eigen::Vector3d(from_axis.normalized()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Greatest length of a finger: the sum of the ways from frame to frame.
double stretched(const HandModel& hand, int finger, const Posture& posture) {
  const auto poses = finger_poses(hand, finger, posture);
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) length += (poses[i].p - poses[i - 1].p).norm();
  return length;
}

}  // namespace

Reach::Reach(const SimulationTask& task, Assignment assignment, double tolerance_m, std::uint64_t seed)
    : task_(task), assignment_(std::move(assignment)), tolerance_m_(tolerance_m), random_(seed), last_(middle_posture(task.hand)) {
  for (const int finger : assignment_) length_m_ = std::max(length_m_, stretched(task_.hand, finger, last_));
}

Eigen::Matrix3d Reach::orientation(const SimulationTask& task, double lean) {
  Eigen::Matrix3d R_OH;
  const Eigen::Vector3d push = task.opposition_O - task.opposition_O.dot(task.approach_O) * task.approach_O;
  R_OH.col(2) = task.approach_O;
  R_OH.col(1) = -push.normalized();
  R_OH.col(0) = R_OH.col(1).cross(R_OH.col(2));
  return R_OH * Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

Pose Reach::centred(const Stance& stance) const {
  Pose X_OH{orientation(task_, stance.lean), Eigen::Vector3d::Zero()};
  const auto forefingers = static_cast<double>(assignment_.size() - 1);
  Eigen::Vector3d fore_contact = Eigen::Vector3d::Zero(), fore_base = fore_contact;
  for (std::size_t i = 1; i < assignment_.size(); ++i) {
    fore_contact += task_.contacts[i].p_OC / forefingers;
    fore_base += finger_poses(task_.hand, assignment_[i], last_).front().p / forefingers;
  }
  const Eigen::Vector3d thumb_base = finger_poses(task_.hand, assignment_[0], last_).front().p;
  const Eigen::Vector3d contact_H = X_OH.R.transpose() * (0.5 * (task_.contacts[0].p_OC + fore_contact));
  const Eigen::Vector3d base_H = 0.5 * (thumb_base + fore_base);
  X_OH.p = X_OH.R * Eigen::Vector3d(contact_H.x() - base_H.x(), contact_H.y() - base_H.y(), contact_H.z() - stance.stand_off_m);
  return X_OH;
}

std::vector<FingertipTarget> Reach::targets(const Pose& X_OH, double apart_m) const {
  std::vector<FingertipTarget> all;
  const Pose X_HO = X_OH.inverse();
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const ContactFrame& C = task_.contacts[i];
    // Back along the way that the finger pushes, so far that the object's tangent plane is `apart_m` away.
    const Eigen::Vector3d push = (i == 0 ? -1.0 : 1.0) * task_.opposition_O;
    const double cosine = std::max(0.5, std::abs(push.dot(C.n)));
    all.push_back({assignment_[i], X_HO * Eigen::Vector3d(C.p_OC - apart_m / cosine * push)});
  }
  return all;
}

Posture Reach::posture(const std::vector<FingertipTarget>& targets, const Posture& start, int starts, double& error_m,
                       std::vector<int>* at_limit) {
  const InverseKinematicsSettings settings{0.01 * tolerance_m_, 60, starts};
  auto solution = solve_fingertips(task_.hand, targets, start, settings, random_);
  error_m = solution.residual_m;
  if (at_limit) *at_limit = std::move(solution.at_limit);
  return std::move(solution.posture);
}

Hold Reach::hold(const Stance& stance) {
  constexpr int kShifts = 4;
  Hold hold;
  hold.assignment = assignment_;
  hold.X_OH = centred(stance);
  for (int shift = 0;; ++shift) {
    hold.grasp = posture(targets(hold.X_OH, 0.0), last_, 3, hold.error_m, &hold.at_limit);
    hold.open = posture(targets(hold.X_OH, task_.clearance_m), hold.grasp, 2, hold.open_error_m, nullptr);
    if (hold.reaches(tolerance_m_) || shift == kShifts) break;
    Eigen::Vector3d lack_H = Eigen::Vector3d::Zero();
    for (const auto& [posture, apart] : {std::pair{&hold.grasp, 0.0}, std::pair{&hold.open, task_.clearance_m}}) {
      for (const auto& target : targets(hold.X_OH, apart)) {
        lack_H += (target.p_HD - finger_poses(task_.hand, target.finger, *posture).back().p) / (2.0 * static_cast<double>(assignment_.size()));
      }
    }
    lack_H.z() = 0.0;  // the stand-off is the stance's
    if (lack_H.norm() < 0.1 * tolerance_m_) break;
    hold.X_OH.p += hold.X_OH.R * lack_H;
  }
  if (hold.reaches(tolerance_m_)) last_ = hold.grasp;
  hold.strain = strain_of(hold);
  hold.from_outside = comes_from_outside(hold);
  return hold;
}

/// Mean over the fingers of: how near the drives are to the ends of their ranges (the fourth power of the share of the half
/// range, so that the middle third costs next to nothing), and how far the last link points away from where a pad meets
/// the object best, half way between the approach axis and the contact's normal.
double Reach::strain_of(const Hold& hold) const {
  double strain = 0.0;
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const Finger& finger = task_.hand.fingers()[static_cast<std::size_t>(assignment_[i])];
    double bend = 0.0;
    for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j) {
      const Joint& joint = task_.hand.joints()[static_cast<std::size_t>(j)];
      const double half = std::max(1e-9, 0.5 * (joint.upper - joint.lower)), middle = 0.5 * (joint.upper + joint.lower);
      bend += std::pow((hold.grasp[static_cast<std::size_t>(j)] - middle) / half, 4) / finger.joint_count;
    }
    const Eigen::Vector3d tip_O = hold.X_OH.R * pointing(task_.hand, assignment_[i], hold.grasp);
    const Eigen::Vector3d best_O = (task_.contacts[i].n + task_.approach_O).normalized();
    strain += (bend + 0.5 * (1.0 - tip_O.dot(best_O))) / static_cast<double>(assignment_.size());
  }
  return strain;
}

bool Reach::comes_from_outside(const Hold& hold) const {
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const Eigen::Vector3d tip_O = hold.X_OH.R * pointing(task_.hand, assignment_[i], hold.grasp);
    if (tip_O.dot(task_.contacts[i].n) < -0.05) return false;
  }
  return true;
}

}  // namespace preshape::kinematic
