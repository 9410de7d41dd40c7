#include <cmath>

#include "components.h"
#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

/// Two fingers of two joints in the plane: a thumb turned by half a turn about z.
std::string hand_body(const std::string& more = "") {
  return "local function finger(name, role, base)\n"
         "  return { name = name, role = role, base = base, joints = {\n"
         "    { name = name .. '_1', lower = -1, upper = 1, torque_limit = 2 },\n"
         "    { name = name .. '_2', lower = 0, upper = 1.5, X_PJ = { p = { 0.3, 0, 0 } } } },\n"
         "    tip = { p = { 0.2, 0, 0 } } }\n"
         "end\n"
         "return { dimensions = { unit_length = 0.03, finger_spacing = 0.03, maximum_opening = 0.12, base_width = 0.15 },\n"
         "  fingers = { finger('t', 'thumb', { R = { -1, 0, 0, 0, -1, 0, 0, 0, 1 }, p = { 0, 0.1, 0 } }), finger('i', 'index') },\n"
         "  solids = { { shape = 'box', half_extents = { 0.1, 0.1, 0.02 } }, { finger = 'i', link = 2, shape = 'capsule', radius = 0.01, half_length = 0.1, X_LS = { p = { 0.1, 0, 0 } } } }," +
         more + " }";
}

std::string failing(std::string body, const std::string& from, const std::string& to) {
  const OneComponent component("hand", "x", body.replace(body.find(from), from.size(), to));
  try {
    component->create<HandModel>("x");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua hand: fingers, joints, sizes and solids are as described, kinematics are the chain's") {
  const OneComponent component("hand", "x", hand_body());
  const auto hand = component->create<HandModel>("x");
  CHECK(hand->dimensions().unit_length_m == 0.03);
  REQUIRE(hand->fingers().size() == 2);
  CHECK(hand->fingers()[1].role == FingerRole::kIndex);
  CHECK(hand->fingers()[1].first_joint == 2);
  CHECK(hand->joints()[2].name == "i_1");
  CHECK(hand->joints()[0].torque_limit == 2.0);
  CHECK(std::isnan(hand->joints()[1].torque_limit));
  REQUIRE(hand->solids().size() == 2);
  CHECK(hand->solids()[0].finger == -1);
  CHECK(hand->solids()[1].finger == 1);
  CHECK(hand->solids()[1].solid.kind == Solid::Kind::kCapsule);
  const std::vector<double> q = {0.4, 0.7};
  std::vector<Pose> poses(4);
  hand->forward(0, q, poses);
  const Eigen::Vector3d tip(-(0.3 * std::cos(0.4) + 0.2 * std::cos(1.1)), 0.1 - 0.3 * std::sin(0.4) - 0.2 * std::sin(1.1), 0);
  CHECK_NEAR(poses[3].p, tip, 4 * kEps);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 2);
  hand->jacobian(1, q, J);
  CHECK_NEAR(J(0, 1), -0.2 * std::sin(1.1), 4 * kEps);
  CHECK(J(5, 0) == 1.0);
  CHECK_THROWS_SAYING(hand->forward(2, q, poses), InputError, "the hand has fingers 0 .. 1, got 2");
}

TEST_CASE("Lua hand: its own forward replaces the chain's, and the Jacobian follows it by differences") {
  const OneComponent chain("hand", "x", hand_body()), own("hand", "x", hand_body(
      "forward = function(finger, q)\n"
      "  local s = finger == 1 and -1 or 1\n"
      "  local function pose(angle, x, y) local c, z = s * math.cos(angle), s * math.sin(angle)\n"
      "    return { R = { c, -z, 0, z, c, 0, 0, 0, 1 }, p = { s * x, (finger == 1 and 0.1 or 0) + s * y, 0 } } end\n"
      "  local x, y = 0.3 * math.cos(q[1]), 0.3 * math.sin(q[1])\n"
      "  local a = q[1] + q[2]\n"
      "  return { pose(0, 0, 0), pose(q[1], 0, 0), pose(a, x, y), pose(a, x + 0.2 * math.cos(a), y + 0.2 * math.sin(a)) }\n"
      "end"));
  const auto a = chain->create<HandModel>("x"), b = own->create<HandModel>("x");
  const std::vector<double> q = {0.4, 0.7};
  for (int finger = 0; finger < 2; ++finger) {
    std::vector<Pose> x(4), y(4);
    a->forward(finger, q, x);
    b->forward(finger, q, y);
    for (int i = 0; i < 4; ++i) {
      CHECK_NEAR(x[static_cast<std::size_t>(i)].p, y[static_cast<std::size_t>(i)].p, 8 * kEps);
      CHECK_NEAR(x[static_cast<std::size_t>(i)].R, y[static_cast<std::size_t>(i)].R, 8 * kEps);
    }
    Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 2), K(6, 2);
    a->jacobian(finger, q, J);
    b->jacobian(finger, q, K);
    CHECK_NEAR(J, K, 1e-9);
  }
}

TEST_CASE("Lua hand: a joint follows another, of any finger, and postures are made so") {
  std::string body = hand_body();
  const std::string from = "upper = 1.5,";
  body.replace(body.find(from), from.size(),
               "upper = 1.5, follows = name == 't' and { joint = 'i_1', ratio = 0.5, offset = 0.4 } or nil,");
  const OneComponent component("hand", "x", body);
  const auto hand = component->create<HandModel>("x");
  CHECK(hand->joints()[0].leader == -1);
  CHECK(hand->joints()[1].leader == 2);  // leader stands after its follower in the description
  CHECK(hand->joints()[1].ratio == 0.5);
  CHECK(hand->joints()[1].offset == 0.4);
  CHECK(driven_joints(*hand) == std::vector<int>{0, 2, 3});
  Posture posture = {0.1, 9.0, 0.6, 0.2};
  apply_couplings(*hand, posture);
  CHECK_NEAR(posture[1], 0.7, 4 * kEps);
  CHECK_NEAR(drive_range(*hand, 2).lower, -0.8, 4 * kEps);  // where the follower is at its lower limit, 0
}

TEST_CASE("Lua hand: a coupling that cannot be is told with its joint and the mend") {
  const std::string body = hand_body();
  const auto with = [&](const std::string& follows) {
    return failing(body, "upper = 1.5,", "upper = 1.5, follows = " + follows + ",");
  };
  const std::string owner = "hand 'x', finger 1, joint 2, follows: ";
  CHECK(with("{ joint = 't_3', ratio = 1 }").ends_with(owner + "'joint' names no joint of the hand, got 't_3'; did you mean 't_1'?"));
  CHECK(with("{ joint = name .. '_2', ratio = 1 }").ends_with(owner + "'joint' is the joint itself; name another one"));
  CHECK(with("{ joint = name .. '_1', ratio = 0 }").ends_with(owner + "'ratio' must not be 0: such a joint would not move"));
  CHECK(with("{ joint = name .. '_1' }").ends_with(owner + "'ratio' is missing (of the leader's value)"));
  CHECK(with("{ joint = 'i_1', ratoi = 1 }").find("unknown key 'ratoi'; did you mean 'ratio'?") != std::string::npos);
  CHECK(with("{ joint = name == 't' and 'i_2' or 't_1', ratio = 1 }").ends_with(owner + "'i_2' itself follows 't_1'; follow that one"));
  CHECK(with("{ joint = name .. '_1', ratio = 1, offset = 3 }").ends_with(
      owner + "'t_1' has no room left: its limits and those of the joints that follow it exclude each other; mend limits, ratio or offset"));
}

TEST_CASE("Lua hand: what is wrong in a description is told with file, line and the way there") {
  const std::string body = hand_body();
  CHECK(failing(body, "'thumb'", "'thumbb'").find("x.plugin.lua:5: hand 'x', finger 1: 'role' cannot be 'thumbb'; did you mean 'thumb'?") != std::string::npos);
  CHECK(failing(body, "'index'", "'thumb'").ends_with("hand 'x', finger 2: its name or role is another finger's"));
  CHECK(failing(body, "lower = -1", "lower = 2").ends_with("hand 'x', finger 1, joint 1: 'lower' is above 'upper'"));
  CHECK(failing(body, "lower = 0, ", "").ends_with("hand 'x', finger 1, joint 2: 'lower' is missing (smallest value)"));
  CHECK(failing(body, "{ -1, 0, 0, 0, -1", "{ 1, 0, 0, 0, -1").ends_with("hand 'x', finger 1, base: R is no rotation (rows at right angles, of length 1)"));
  CHECK(failing(body, "{ 0.3, 0, 0 }", "{ 0.3, 0 }").ends_with("X_PJ, p: expected 3 finite numbers, got { 0.3, 0 }"));
  CHECK(failing(body, "finger = 'i'", "finger = 'j'").ends_with("hand 'x', solid 2: there is no finger 'j'"));
  CHECK(failing(body, "link = 2", "link = 3").ends_with("hand 'x', solid 2: 'link' must be at most 2, got 3"));
  CHECK(failing(body, "radius = 0.01", "radius = 0").ends_with("a capsule has a positive 'radius' and no 'half_extents'"));
  CHECK(failing(body, "unit_length", "unit_lenght").find("hand 'x', dimensions: unknown key 'unit_lenght'; did you mean 'unit_length'?") != std::string::npos);
  CHECK(failing(hand_body("forward = function() return {} end"), "'thumb'", "'thumb'").find("hand 'x', forward: it must return 4 poses, got list for finger 1 at (0, 0.75)") != std::string::npos);
}

TEST_SUITE_END();
