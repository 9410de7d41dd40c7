#include "preshape/grasp/imparted_twists.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;
using Eigen::Vector3d;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

/// Two hard fingers on either side along y, 0.2 m apart.
const std::vector<ContactFrame>& opposed() {
  static const std::vector<ContactFrame> contacts = {ContactFrame::at({0, 0.1, 0}, {0, -1, 0}, {1, 0, 0}),
                                                     ContactFrame::at({0, -0.1, 0}, {0, 1, 0}, {1, 0, 0})};
  return contacts;
}

JointAction slide(int contact, const Vector3d& direction) { return {contact, Twist(direction, Vector3d::Zero()), 1.0}; }

ImpartedTwists imparted(const std::vector<JointAction>& joints, const std::vector<DriveShare>& drives, const char* model = "hard_finger") {
  return imparted_twists(*registry().create<ContactModel>(model), opposed(), joints, drives, 1.0);
}

/// Whether the basis spans exactly these twists (v, w).
bool spans(const ImpartedTwists& found, const std::vector<Eigen::Matrix<double, 6, 1>>& expected) {
  if (found.twists_O.size() != expected.size()) return false;
  Eigen::MatrixXd both(6, 2 * static_cast<Eigen::Index>(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    both.col(static_cast<Eigen::Index>(i)) = found.twists_O[i].vector();
    both.col(static_cast<Eigen::Index>(expected.size() + i)) = expected[i];
  }
  Eigen::FullPivHouseholderQR<Eigen::MatrixXd> qr(both);
  qr.setThreshold(1e-9);
  return qr.rank() == static_cast<Eigen::Index>(expected.size());
}

Eigen::Matrix<double, 6, 1> twist(double vx, double vy, double vz, double wx, double wy, double wz) {
  return (Eigen::Matrix<double, 6, 1>() << vx, vy, vz, wx, wy, wz).finished();
}

}  // namespace

TEST_CASE("Imparted twists: of a task the share that lies in their space is told") {
  ImpartedTwists found;
  found.twists_O = {Twist(Vector3d::UnitX(), Vector3d::Zero()), Twist(Vector3d::Zero(), Vector3d(0, 0.6, 0.8))};
  const auto share = [&](double tx, double ty, double tz, double rx, double ry, double rz) {
    Task task;
    task.screw = {tx, ty, tz, rx, ry, rz};
    return share_of(found, task);
  };
  CHECK(share(-2, 0, 0, 0, 0, 0) == doctest::Approx(1.0));
  CHECK(share(0, 1, 1, 1, 0, 0) == 0.0);
  CHECK(share(3, 4, 0, 0, 0, 0) == doctest::Approx(0.6));
  CHECK(share(1, 0, 0, 0, 1, 0) == doctest::Approx(std::sqrt((1 + 0.36) / 2)));
  CHECK(share(0, 0, 0, 0, 0, 0) == 1.0);  // nothing asked
  found.twists_O.clear();
  CHECK(share(1, 0, 0, 0, 0, 0) == 0.0);
}

TEST_CASE("Imparted twists: fingers that slide freely in space give any motion, and none moves without the object") {
  std::vector<JointAction> joints;
  std::vector<DriveShare> drives;
  for (int contact = 0; contact < 2; ++contact) {
    for (int k = 0; k < 3; ++k) joints.push_back(slide(contact, Vector3d::Unit(k))), drives.push_back({3 * contact + k, 1.0});
  }
  const auto found = imparted(joints, drives);
  CHECK(found.twists_O.size() == 6);
  CHECK(found.internal_motions == 0);
}

TEST_CASE("Imparted twists: fingers that slide along x alone push, turn about z, and leave the turn about their own line free") {
  const std::vector<JointAction> joints = {slide(0, Vector3d::UnitX()), slide(1, Vector3d::UnitX())};
  CHECK(spans(imparted(joints, {{0, 1.0}, {1, 1.0}}), {twist(1, 0, 0, 0, 0, 0), twist(0, 0, 0, 0, 0, 1), twist(0, 0, 0, 0, 1, 0)}));
  // With soft fingers the turn about the line is held by both, which do not turn.
  CHECK(spans(imparted(joints, {{0, 1.0}, {1, 1.0}}, "soft_finger_elliptic"), {twist(1, 0, 0, 0, 0, 0), twist(0, 0, 0, 0, 0, 1)}));
}

TEST_CASE("Imparted twists: one drive for both fingers pushes or turns, as they are coupled") {
  const std::vector<JointAction> joints = {slide(0, Vector3d::UnitX()), slide(1, Vector3d::UnitX())};
  CHECK(spans(imparted(joints, {{0, 1.0}, {0, 1.0}}), {twist(1, 0, 0, 0, 0, 0), twist(0, 0, 0, 0, 1, 0)}));
  CHECK(spans(imparted(joints, {{0, 1.0}, {0, -1.0}}), {twist(0, 0, 0, 0, 0, 1), twist(0, 0, 0, 0, 1, 0)}));
}

TEST_CASE("Imparted twists: joints that move nothing at the contact are internal motions") {
  const std::vector<JointAction> joints = {slide(0, Vector3d::UnitX()), slide(1, Vector3d::UnitX()), slide(1, 2.0 * Vector3d::UnitX())};
  CHECK(imparted(joints, {{0, 1.0}, {1, 1.0}, {2, 1.0}}).internal_motions == 1);
}

TEST_CASE("Imparted twists: a joint's action is the fingertip's twist in O, and its drive the leader's where it follows") {
  const HandModel& hand = *shipped_hands().at("barrett");
  const std::vector<int> fingers = {0, 1};
  const Pose X_OH{Eigen::AngleAxisd(0.7, Vector3d(1, 2, 2) / 3.0).toRotationMatrix(), {0.1, 0.2, 0.3}};
  const Posture posture = middle_posture(hand);
  const auto actions = joint_actions(hand, fingers, posture, X_OH);
  const auto shares = drive_shares(hand, fingers);
  REQUIRE(actions.size() == shares.size());
  std::size_t i = 0;
  for (std::size_t contact = 0; contact < fingers.size(); ++contact) {
    const Finger& finger = hand.fingers()[static_cast<std::size_t>(fingers[contact])];
    for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j, ++i) {
      constexpr double kStep = 1e-6;
      Posture up = posture, down = posture;  // without couplings: this joint alone
      up[static_cast<std::size_t>(j)] += kStep, down[static_cast<std::size_t>(j)] -= kStep;
      const Vector3d quotient = X_OH.R * (finger_poses(hand, fingers[contact], up).back().p - finger_poses(hand, fingers[contact], down).back().p) / (2 * kStep);
      CHECK(actions[i].contact == static_cast<int>(contact));
      CHECK_NEAR(actions[i].V_C_O.linear(), quotient, 1e-8);
      const Joint& joint = hand.joints()[static_cast<std::size_t>(j)];
      CHECK(shares[i].drive == (joint.leader < 0 ? j : joint.leader));
      CHECK(shares[i].gain == (joint.leader < 0 ? 1.0 : joint.ratio));
    }
  }
  CHECK_THROWS_SAYING(joint_actions(hand, fingers, std::vector<double>(3), X_OH), InputError, "q");
}

TEST_SUITE_END();
