#include "reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace preshape::kinematic {

namespace {

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
  for (int finger = 0; finger < static_cast<int>(task.hand.fingers().size()); ++finger) {
    if (std::find(assignment_.begin(), assignment_.end(), finger) == assignment_.end()) put_aside(finger);
  }
  for (const int finger : assignment_) length_m_ = std::max(length_m_, stretched(task_.hand, finger, last_));
}

/// A finger without a contact is opened as far as it goes: away from the other side of the hand, and back to the palm.
void Reach::put_aside(int finger) {
  constexpr int kDraws = 400;
  const Finger& about = task_.hand.fingers()[static_cast<std::size_t>(finger)];
  const Eigen::Vector3d away(0.0, about.role == FingerRole::kThumb ? -1.0 : 1.0, -1.0);
  Posture best = last_;
  double farthest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDraws; ++i) {
    Posture drawn = last_;
    for (int joint = about.first_joint; joint < about.first_joint + about.joint_count; ++joint) {
      if (task_.hand.joints()[static_cast<std::size_t>(joint)].leader >= 0) continue;
      const DriveRange range = drive_range(task_.hand, joint);
      drawn[static_cast<std::size_t>(joint)] = random_.uniform(range.lower, range.upper);
    }
    apply_couplings(task_.hand, drawn);
    const auto poses = finger_poses(task_.hand, finger, drawn);
    double reach = 0.0;
    for (const Pose& pose : poses) reach += away.dot(pose.p);
    // Sideways it stays where it is, so that it does not run into its neighbours.
    reach -= 2.0 * std::abs(poses.back().p.x() - poses.front().p.x());
    if (reach > farthest) farthest = reach, best = drawn;
  }
  last_ = best;
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

std::vector<FingertipTarget> Reach::targets(const Pose& X_OH, double slant, double apart_m) const {
  constexpr double kPointing = 0.003;  // [m] a radian of direction
  std::vector<FingertipTarget> all;
  const Pose X_HO = X_OH.inverse();
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const ContactFrame& C = task_.contacts[i];
    // Back along the way that the finger pushes, so far that the object's tangent plane is `apart_m` away.
    const Eigen::Vector3d push = (i == 0 ? -1.0 : 1.0) * task_.opposition_O;
    const double cosine = std::max(0.5, std::abs(push.dot(C.n)));
    const Eigen::Vector3d pointing_O = (std::cos(slant) * C.n + std::sin(slant) * task_.approach_O).normalized();
    all.push_back({assignment_[i], X_HO * Eigen::Vector3d(C.p_OC - apart_m / cosine * push), X_HO.R * pointing_O, kPointing});
  }
  return all;
}

Posture Reach::posture(const std::vector<FingertipTarget>& targets, const Posture& start, int starts, double& error_m,
                       std::vector<int>* at_limit) {
  const InverseKinematicsSettings settings{0.01 * tolerance_m_, 40, starts};
  auto solution = solve_fingertips(task_.hand, targets, start, settings, random_);
  error_m = solution.residual_m;
  if (at_limit) *at_limit = std::move(solution.at_limit);
  return std::move(solution.posture);
}

Hold Reach::hold(const Stance& stance) {
  constexpr int kShifts = 2;
  constexpr double kHopeless = 0.3;  // share of a finger's length that no shift sideways makes good
  Hold hold;
  hold.assignment = assignment_;
  hold.X_OH = centred(stance);
  for (int shift = 0;; ++shift) {
    hold.grasp = posture(targets(hold.X_OH, stance.slant, 0.0), last_, starts_, hold.error_m, &hold.at_limit);
    hold.open = posture(targets(hold.X_OH, stance.slant, task_.clearance_m), hold.grasp, starts_, hold.open_error_m, nullptr);
    if (hold.reaches(tolerance_m_) || shift == kShifts || hold.error_m > kHopeless * length_m_) break;
    Eigen::Vector3d lack_H = Eigen::Vector3d::Zero();
    for (const auto& [posture, apart] : {std::pair{&hold.grasp, 0.0}, std::pair{&hold.open, task_.clearance_m}}) {
      for (const auto& target : targets(hold.X_OH, stance.slant, apart)) {
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

/// Mean over the fingers of how near their joints are to the ends of their ranges: the fourth power of the share of the half
/// range, so that the middle third costs next to nothing.
double Reach::strain_of(const Hold& hold) const {
  double strain = 0.0;
  for (const int index : assignment_) {
    const Finger& finger = task_.hand.fingers()[static_cast<std::size_t>(index)];
    for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j) {
      const Joint& joint = task_.hand.joints()[static_cast<std::size_t>(j)];
      const double half = std::max(1e-9, 0.5 * (joint.upper - joint.lower)), middle = 0.5 * (joint.upper + joint.lower);
      const double share = (hold.grasp[static_cast<std::size_t>(j)] - middle) / half;
      strain += std::pow(share, 4) / (finger.joint_count * static_cast<double>(assignment_.size()));
    }
  }
  return strain;
}

bool Reach::comes_from_outside(const Hold& hold) const {
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const Eigen::Vector3d tip_O = hold.X_OH.R * pointing_of(task_.hand, assignment_[i], hold.grasp);
    if (tip_O.dot(task_.contacts[i].n) < -0.05) return false;
  }
  return true;
}

}  // namespace preshape::kinematic
