#include "kinematics.h"

#include <cmath>

namespace preshape::conformance {

namespace {

/// The motion that takes X_HA to X_HB, in H, also of poses that are not quite rigid.
Pose motion(const Pose& X_HA, const Pose& X_HB) {
  const Eigen::Matrix3d R = X_HB.R * X_HA.R.inverse();
  return {R, X_HB.p - R * X_HA.p};
}

}  // namespace

std::vector<Pose> poses_at(const HandModel& hand, int finger, const std::vector<double>& q) {
  std::vector<Pose> poses(q.size() + 2);
  hand.forward(finger, q, poses);
  return poses;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian_at(const HandModel& hand, int finger,
                                                     const std::vector<double>& q) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, static_cast<Eigen::Index>(q.size()));
  jacobian.setConstant(std::nan(""));
  hand.jacobian(finger, q, jacobian);
  return jacobian;
}

std::span<const Joint> joints_of(const HandModel& hand, int finger) {
  const Finger& f = hand.fingers()[static_cast<std::size_t>(finger)];
  return hand.joints().subspan(static_cast<std::size_t>(f.first_joint),
                               static_cast<std::size_t>(f.joint_count));
}

std::vector<double> posture(const HandModel& hand, int finger, Random& random, double share) {
  std::vector<double> q;
  for (const Joint& joint : joints_of(hand, finger)) {
    const double middle = 0.5 * (joint.lower + joint.upper), half = 0.5 * (joint.upper - joint.lower);
    q.push_back(middle + share * half * random.uniform(-1, 1));
  }
  return q;
}

double reach(const HandModel& hand, int finger) {
  const auto joints = joints_of(hand, finger);
  const auto poses = poses_at(hand, finger, std::vector<double>(joints.size(), 0.0));
  double length = 1e-3;
  for (std::size_t k = 1; k < poses.size(); ++k) length += (poses[k].p - poses[k - 1].p).norm();
  for (const Joint& joint : joints)
    length += joint.prismatic ? std::max(std::abs(joint.lower), std::abs(joint.upper)) : 0.0;
  return length;
}

std::vector<double> middle_posture(const HandModel& hand, int finger) {
  std::vector<double> q;
  for (const Joint& joint : joints_of(hand, finger)) q.push_back(0.5 * (joint.lower + joint.upper));
  return q;
}

Pose JointScrew::exp(double by) const {
  if (prismatic) return {Eigen::Matrix3d::Identity(), by * axis};
  const Eigen::Matrix3d R = Eigen::AngleAxisd(by, axis).toRotationMatrix();
  return {R, point - R * point};
}

std::vector<JointScrew> measured_screws(const HandModel& hand, int finger) {
  const auto joints = joints_of(hand, finger);
  const auto middle = middle_posture(hand, finger);
  const auto rest = poses_at(hand, finger, middle);
  std::vector<JointScrew> screws;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    auto q = middle;
    const double step = std::min(1.0, joints[i].upper - middle[i]);
    q[i] += step;
    const Pose X = motion(rest[i + 1], poses_at(hand, finger, q)[i + 1]);
    JointScrew screw{joints[i].prismatic};
    if (screw.prismatic) {
      screw.axis = X.p.normalized();
    } else {
      // Of a turn by the step: R - R^T = 2 sin(step) [a], and the point of the axis next to the origin.
      const Eigen::Matrix3d skew = X.R - X.R.transpose();
      screw.axis = Eigen::Vector3d(skew(2, 1), skew(0, 2), skew(1, 0)).normalized();
      screw.point = 0.5 * (X.p + screw.axis.cross(X.p) / std::tan(0.5 * step));
    }
    screw.flaw = difference(screw.exp(step), X, reach(hand, finger));
    screws.push_back(screw);
  }
  return screws;
}

double difference(const Pose& a, const Pose& b, double length) {
  return std::max((a.R - b.R).cwiseAbs().maxCoeff(), (a.p - b.p).norm() / length);
}

std::string finger_text(const HandModel& hand, int finger, const std::vector<double>& q) {
  std::string values;
  for (const double x : q) values += (values.empty() ? "" : " ") + number_text(x);
  return fmt::format("finger {} at q = {{{}}}", hand.fingers()[static_cast<std::size_t>(finger)].name,
                     values);
}

}  // namespace preshape::conformance
