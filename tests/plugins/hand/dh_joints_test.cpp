// Joints given by frame and axis, and joints that follow others.
#include <cmath>

#include <Eigen/Geometry>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

Value axis_joint(const std::string& name, std::vector<double> position, std::vector<double> rotation,
                 std::vector<double> axis, const char* type = "revolute") {
  return Value::table({{"name", name},
                       {"type", type},
                       {"position", Value::numbers(position)},
                       {"rotation", Value::numbers(rotation)},
                       {"axis", Value::numbers(axis)},
                       {"limits", Value::numbers({-1.5, 1.5})}});
}

Value coupled(const std::string& leader, double ratio, double offset = 0.0) {
  return Value::table({{"joint", leader}, {"ratio", ratio}, {"offset", offset}});
}

/// The planar hand, where joint `name` has another entry.
Value with_entry(Value description, const std::string& name, const std::string& key, const Value& value) {
  for (Value& finger : description.find("fingers")->items()) {
    for (Value& joint : finger.find("joints")->items()) {
      if (joint.find("name")->string() == name) joint.set(key, value);
    }
  }
  return description;
}

}  // namespace

TEST_CASE(
    "DH joints: a joint by frame and axis turns its link's frame about the axis through the frame's origin") {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> p(3), rpy(3), n(3);
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = random.uniform(-1, 1), rpy[k] = random.uniform(-3, 3), n[k] = random.normal();
    if (i % 4 == 0) n = {1e-5 * n[0], 1e-5 * n[1], -1};  // nearly against z
    const bool prismatic = i % 5 == 0;
    const auto hand = make_hand(hand_table(
        {finger_table("thumb", {axis_joint("t", p, rpy, n, prismatic ? "prismatic" : "revolute")})}));
    const double q = random.uniform(-1.5, 1.5);
    const Eigen::Vector3d axis = Eigen::Vector3d(n[0], n[1], n[2]).normalized();
    const Eigen::Matrix3d frame = (Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
                                   Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX()))
                                      .toRotationMatrix();
    const Pose link = forward(*hand, 0, {q})[1];
    const Eigen::Matrix3d turn = prismatic ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                           : Eigen::AngleAxisd(q, axis).toRotationMatrix();
    CHECK_NEAR(link.R, Eigen::Matrix3d(frame * turn), 1e-14);
    CHECK_NEAR(link.p,
               Eigen::Vector3d(Eigen::Vector3d(p[0], p[1], p[2]) + (prismatic ? q : 0.0) * frame * axis),
               1e-14);
  }
}

TEST_CASE("DH joints: joints of both kinds stand in one finger, and lengths in U count for both") {
  const auto finger = finger_table(
      "thumb", {joint_table("t1", 2, 0, 0, 0), axis_joint("t2", {1, 0, 0}, {0, 0, 0}, {0, 0, 1})});
  const auto hand = make_hand(with(hand_table({finger}), "lengths", "U"));
  CHECK_NEAR(forward(*hand, 0, {0.5, 0}).back().p,
             Eigen::Vector3d(0.09 * std::cos(0.5), 0.09 * std::sin(0.5), 0), kEps);
}

TEST_CASE("DH joints: an axis alone turns about it where the link before ends, and without one it is z") {
  Value joint = axis_joint("t", {0, 0, 0.2}, {0, 0, 0}, {0, 1, 0});
  joint.erase("axis");
  const auto hand = make_hand(hand_table({finger_table("thumb", {joint})}));
  CHECK_NEAR(forward(*hand, 0, {0.5}).back().R.col(0), Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0),
             kEps);
  CHECK_NEAR(forward(*hand, 0, {0.5}).back().p, Eigen::Vector3d(0, 0, 0.2), 0);
}

TEST_CASE("DH joints: a joint given in both ways, or about no direction, is refused") {
  const auto mixed = with_joint(planar_hand(), "axis", Value::numbers({0, 0, 1}));
  CHECK_THROWS_SAYING(make_hand(mixed), InputError,
                      "finger 1 'thumb', joint 1 'thumb_1': 'axis' and 'a' exclude each other: "
                      "give a joint by a, alpha, d, theta or by position, rotation, axis");
  const auto still = hand_table({finger_table("thumb", {axis_joint("t", {0, 0, 0}, {0, 0, 0}, {0, 0, 0})})});
  CHECK_THROWS_SAYING(make_hand(still), InputError, "joint 1 't': 'axis' must have a direction");
}

TEST_CASE(
    "DH couplings: a joint follows its leader by ratio and offset, also one of a finger that comes later") {
  auto description = with_entry(planar_hand(), "thumb_1", "follows", coupled("index_1", -0.5, 0.25));
  description = with_entry(description, "index_2", "follows", coupled("index_1", 1));
  const auto hand = make_hand(description);
  const auto joints = hand->joints();
  CHECK(joints[0].leader == 2);
  CHECK(joints[0].ratio == -0.5);
  CHECK(joints[0].offset == 0.25);
  CHECK(joints[1].leader == -1);
  CHECK(joints[3].leader == 2);
  CHECK(driven_joints(*hand) == std::vector<int>{1, 2});
  Posture q = {0, 0.1, 0.4, 0};
  apply_couplings(*hand, q);
  CHECK_NEAR(q[0], 0.05, kEps);
  CHECK(q[3] == 0.4);
}

TEST_CASE("DH couplings: forward takes a follower's value as it stands") {
  const auto free = make_hand(planar_hand()),
             bound = make_hand(with_entry(planar_hand(), "thumb_2", "follows", coupled("thumb_1", 2)));
  CHECK_NEAR(forward(*bound, 0, {0.3, -0.7}).back().p, forward(*free, 0, {0.3, -0.7}).back().p, 0);
}

TEST_CASE("DH couplings: between a sliding and a turning joint the ratio is a length, in the file's unit") {
  auto description = with(planar_hand(), "lengths", "U");
  description = with_entry(with_entry(description, "thumb_2", "type", "prismatic"), "thumb_2", "follows",
                           coupled("thumb_1", 1, 0.5));
  description = with_entry(with_entry(description, "index_1", "type", "prismatic"), "index_2", "follows",
                           coupled("index_1", 1, 0.5));
  const auto hand = make_hand(description);
  CHECK_NEAR(hand->joints()[1].ratio, 0.03, kEps);
  CHECK_NEAR(hand->joints()[1].offset, 0.015, kEps);
  CHECK_NEAR(hand->joints()[3].ratio, 1 / 0.03, 1e-12);
  CHECK(hand->joints()[3].offset == 0.5);
}

TEST_CASE("DH couplings: a leader that is unknown, the joint itself or a follower is refused with the mend") {
  const auto follow = [](const std::string& follower, const Value& follows) {
    return with_entry(planar_hand(), follower, "follows", follows);
  };
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", coupled("thumb_l", 1))), InputError,
                      "finger 1 'thumb', joint 2 'thumb_2', follows: 'joint' names no joint of the hand, got "
                      "'thumb_l'; did you mean 'thumb_1'?");
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", coupled("thumb_2", 1))), InputError,
                      "'joint' is the joint itself");
  auto chained = follow("thumb_2", coupled("thumb_1", 1));
  chained = with_entry(chained, "index_1", "follows", coupled("thumb_2", 1));
  CHECK_THROWS_SAYING(
      make_hand(chained), InputError,
      "joint 1 'index_1', follows: 'joint' 'thumb_2' itself follows 'thumb_1'; follow that one");
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", coupled("thumb_1", 0))), InputError,
                      "'ratio' must not be 0");
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", coupled("thumb_1", 1, 4))), InputError,
                      "'joint' 'thumb_1' has no room left");
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", coupled("thumb_1", 1, 3))), InputError,
                      "'joint' 'thumb_1' has no room left");  // but for a single posture
  Value misspelt = coupled("thumb_1", 1);
  misspelt.set("ofset", 1);
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", misspelt)), InputError,
                      "follows: unknown key 'ofset'; did you mean 'offset'?");
  CHECK_THROWS_SAYING(make_hand(follow("thumb_2", Value::table({{"joint", "thumb_1"}}))), InputError,
                      "'ratio' is missing");
}

TEST_SUITE_END();
