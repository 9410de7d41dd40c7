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

/// To a billionth, a nanometre: what is left of rounding where the same scene is met in another place.
Eigen::Vector3d rounded(const Eigen::Vector3d& v) { return 1e-9 * (1e9 * v).array().round().matrix(); }

/// The frame of the task's axes in the middle of its contacts.
Pose task_frame(const SimulationTask& task) {
  Pose X_OT{Reach::orientation(task), Eigen::Vector3d::Zero()};
  for (const ContactFrame& C : task.contacts) X_OT.p += C.p_OC / static_cast<double>(task.contacts.size());
  return X_OT;
}

}  // namespace

Reach::Reach(const SimulationTask& task, Assignment assignment, double tolerance_m, double turn, std::uint64_t seed)
    : task_(task), assignment_(std::move(assignment)), tolerance_m_(tolerance_m), turn_(turn), random_(seed), X_OT_(task_frame(task)), last_(middle_posture(task.hand)) {
  const Eigen::Matrix3d R_TO = X_OT_.R.transpose();
  opposition_T_ = rounded(R_TO * task.opposition_O);
  for (const ContactFrame& C : task.contacts) {
    p_TC_.push_back(rounded(R_TO * (C.p_OC - X_OT_.p)));
    n_T_.push_back(rounded(R_TO * C.n));
  }
  for (const int finger : assignment_) length_m_ = std::max(length_m_, stretched(task_.hand, finger, last_));
}

Eigen::Matrix3d Reach::orientation(const SimulationTask& task) {
  Eigen::Matrix3d R_OT;
  const Eigen::Vector3d push = task.opposition_O - task.opposition_O.dot(task.approach_O) * task.approach_O;
  R_OT.col(2) = task.approach_O;
  R_OT.col(1) = -push.normalized();
  R_OT.col(0) = R_OT.col(1).cross(R_OT.col(2));
  return R_OT;
}

Pose Reach::centred(const Stance& stance) const {
  Pose X_TH{Eigen::AngleAxisd(stance.lean, Eigen::Vector3d::UnitX()).toRotationMatrix(), Eigen::Vector3d::Zero()};
  const auto forefingers = static_cast<double>(assignment_.size() - 1);
  Eigen::Vector3d fore_contact = Eigen::Vector3d::Zero(), fore_base = fore_contact;
  for (std::size_t i = 1; i < assignment_.size(); ++i) {
    fore_contact += p_TC_[i] / forefingers;
    fore_base += finger_poses(task_.hand, assignment_[i], last_).front().p / forefingers;
  }
  const Eigen::Vector3d thumb_base = finger_poses(task_.hand, assignment_[0], last_).front().p;
  const Eigen::Vector3d contact_H = X_TH.R.transpose() * (0.5 * (p_TC_[0] + fore_contact));
  const Eigen::Vector3d base_H = 0.5 * (thumb_base + fore_base);
  X_TH.p = X_TH.R * Eigen::Vector3d(contact_H.x() - base_H.x(), contact_H.y() - base_H.y(), contact_H.z() - stance.stand_off_m);
  return X_TH;
}

std::vector<FingertipTarget> Reach::targets(const Pose& X_TH, double slant, double apart_m) const {
  constexpr double kPointing = 0.003;  // [m] a radian of direction
  std::vector<FingertipTarget> all;
  const Pose X_HT = X_TH.inverse();
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    // Back along the way that the finger pushes, so far that the object's tangent plane is `apart_m` away.
    const Eigen::Vector3d push = (i == 0 ? -1.0 : 1.0) * opposition_T_;
    const double cosine = std::max(0.5, std::abs(push.dot(n_T_[i])));
    const Eigen::Vector3d pointing_T = (std::cos(slant) * n_T_[i] + std::sin(slant) * Eigen::Vector3d::UnitZ()).normalized();
    all.push_back({assignment_[i], X_HT * Eigen::Vector3d(p_TC_[i] - apart_m / cosine * push), X_HT.R * pointing_T, kPointing});
  }
  return all;
}

/// Brings the fingertips to their contacts from the object's outside, the hand going along no more than it must.
void Reach::close(Hold& hold, double slant) {
  constexpr double kSideways = 0.5, kAlong = 0.1;  // shares of a finger's length
  constexpr double kHopeless = 0.3;                // of it, too: what no move of the hand makes good
  const HandFreedom sideways{{kSideways * length_m_, kSideways * length_m_, 0.0}, Eigen::Vector3d::Zero()};
  const HandFreedom all{{kSideways * length_m_, kSideways * length_m_, kAlong * length_m_}, Eigen::Vector3d::Constant(turn_)};
  const Pose centred = hold.X_TH;
  const auto wanted = targets(centred, slant, 0.0);
  for (const bool turned : {false, true}) {
    auto solution = solve_fingertips(task_.hand, wanted, last_, {0.01 * tolerance_m_, 40, starts_, turned ? all : sideways}, random_);
    const bool reached = solution.residual_m <= tolerance_m_;
    if (!reached && hold.reached(tolerance_m_)) return;
    hold.turned = turned;
    hold.X_TH = centred * solution.X_HM;
    hold.grasp = std::move(solution.posture);
    hold.error_m = solution.residual_m;
    hold.at_limit = std::move(solution.at_limit);
    hold.from_inside = from_inside(hold);
    if (reached ? hold.from_outside() : hold.error_m > kHopeless * length_m_) return;
  }
}

/// Opens the fingers where the hand stands: to the places before the contacts, or, where the fingers cannot meet them, so
/// that every fingertip is at least the clearance away from its contact's tangent plane.
void Reach::open(Hold& hold, double slant) {
  for (const double wider : {1.0, 1.5, 2.5, 4.0}) {
    InverseKinematicsSettings settings{0.01 * tolerance_m_, 40, starts_};
    auto solution = solve_fingertips(task_.hand, targets(hold.X_TH, slant, wider * task_.clearance_m), hold.grasp, settings, random_);
    hold.open = std::move(solution.posture);
    hold.open_error_m = solution.reached ? 0.0 : lacking_clearance_m(hold);
    if (hold.open_error_m <= tolerance_m_) return;
  }
}

double Reach::lacking_clearance_m(const Hold& hold) const {
  double lacking = 0.0;
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const Eigen::Vector3d tip_T = hold.X_TH * finger_poses(task_.hand, assignment_[i], hold.open).back().p;
    lacking = std::max(lacking, task_.clearance_m - n_T_[i].dot(p_TC_[i] - tip_T));
  }
  return lacking;
}

Hold Reach::hold(const Stance& stance) {
  Hold hold;
  hold.assignment = assignment_;
  hold.X_TH = centred(stance);
  close(hold, stance.slant);
  if (hold.reached(tolerance_m_) && hold.from_outside()) open(hold, stance.slant);
  else hold.open = hold.grasp;
  if (hold.reaches(tolerance_m_)) last_ = hold.grasp;
  hold.X_OH = X_OT_ * hold.X_TH;
  hold.strain = strain_of(hold);
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

std::vector<int> Reach::from_inside(const Hold& hold) const {
  std::vector<int> fingers;
  for (std::size_t i = 0; i < assignment_.size(); ++i) {
    const Eigen::Vector3d tip_T = hold.X_TH.R * pointing_of(task_.hand, assignment_[i], hold.grasp);
    if (tip_T.dot(n_T_[i]) < -0.05) fingers.push_back(assignment_[i]);
  }
  return fingers;
}

}  // namespace preshape::kinematic
