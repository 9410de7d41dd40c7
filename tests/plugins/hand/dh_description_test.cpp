#include <cmath>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

Value solid(Value::Table entries) { return Value::list({Value::table(std::move(entries))}); }

}  // namespace

TEST_CASE("DH description: fingers, joints and limits come out as they were written") {
  Value description = with_joint(planar_hand(), "limits", Value::numbers({-0.25, 1}));
  description = with_joint(description, "torque_limit", 2.5);
  const auto hand = make_hand(description);
  REQUIRE(hand->fingers().size() == 2);
  REQUIRE(hand->joints().size() == 4);
  CHECK(hand->fingers()[0].role == FingerRole::kThumb);
  CHECK(hand->fingers()[1].role == FingerRole::kIndex);
  CHECK(hand->fingers()[1].name == "index");
  CHECK(hand->fingers()[1].first_joint == 2);
  CHECK(hand->fingers()[1].joint_count == 2);
  CHECK(hand->joints()[0].name == "thumb_1");
  CHECK(hand->joints()[3].name == "index_2");
  CHECK(hand->joints()[0].lower == -0.25);
  CHECK(hand->joints()[0].upper == 1.0);
  CHECK(hand->joints()[0].torque_limit == 2.5);
  CHECK(std::isnan(hand->joints()[1].torque_limit));
  CHECK(hand->dimensions().base_width_m == 0.15);
}

TEST_CASE("DH description: the limits of a sliding joint are lengths, those of a turning one are not") {
  Value description = with(planar_hand(), "lengths", "U");
  description = with_joint(with_joint(description, "type", "prismatic"), "limits", Value::numbers({0, 2}));
  const auto hand = make_hand(description);
  CHECK(hand->joints()[0].prismatic);
  CHECK(hand->joints()[0].upper == 2 * 0.03);
  CHECK(hand->joints()[1].upper == 1.5);
}

TEST_CASE("DH description: a capsule runs between its two ends") {
  const auto capsule = solid({{"link", 2}, {"from", Value::numbers({1, 2, 3})}, {"to", Value::numbers({1, 5, 7})},
                              {"radius", 0.5}});
  const auto hand = make_hand(with_finger(planar_hand(), 1, "links", capsule));
  REQUIRE(hand->solids().size() == 1);
  const LinkSolid& link = hand->solids()[0];
  CHECK(link.finger == 1);
  CHECK(link.link == 2);
  CHECK(link.solid.kind == Solid::Kind::kCapsule);
  CHECK(link.solid.radius == 0.5);
  CHECK(link.solid.half_length == 2.5);
  CHECK_NEAR(link.X_LS * Eigen::Vector3d(0, 0, -2.5), Eigen::Vector3d(1, 2, 3), 16 * kEps);
  CHECK_NEAR(link.X_LS * Eigen::Vector3d(0, 0, 2.5), Eigen::Vector3d(1, 5, 7), 16 * kEps);
  CHECK_NEAR(link.X_LS.R * link.X_LS.R.transpose(), Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 8 * kEps);
  CHECK(link.X_LS.R.determinant() > 0);
}

TEST_CASE("DH description: a capsule against z and one without length are solids like any other") {
  Value::List capsules;
  capsules.push_back(Value::table({{"from", Value::numbers({0, 0, 1})}, {"to", Value::numbers({0, 0, -1})}, {"radius", 1}}));
  capsules.push_back(Value::table({{"from", Value::numbers({3, 0, 0})}, {"to", Value::numbers({3, 0, 0})}, {"radius", 1}}));
  const auto hand = make_hand(with(planar_hand(), "palm", Value::list(capsules)));
  CHECK_NEAR(hand->solids()[0].X_LS * Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1), 4 * kEps);
  CHECK(hand->solids()[1].solid.half_length == 0.0);
  CHECK_NEAR(hand->solids()[1].X_LS.R, Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 0);
}

TEST_CASE("DH description: the palm's boxes and spheres stand where they were put") {
  Value::List palm;
  palm.push_back(Value::table({{"shape", "box"}, {"centre", Value::numbers({1, 0, 0})},
                               {"rotation", Value::numbers({0, 0, 0.5})}, {"half_extents", Value::numbers({3, 2, 1})}}));
  palm.push_back(Value::table({{"shape", "sphere"}, {"centre", Value::numbers({0, 1, 0})}, {"radius", 2}}));
  Value description = with(with(planar_hand(), "palm", Value::list(palm)), "lengths", "U");
  const auto hand = make_hand(description);
  REQUIRE(hand->solids().size() == 2);
  const LinkSolid &box = hand->solids()[0], &sphere = hand->solids()[1];
  CHECK(box.finger == -1);
  CHECK(box.solid.kind == Solid::Kind::kBox);
  CHECK_NEAR(box.solid.half_extents, Eigen::Vector3d(0.09, 0.06, 0.03), kEps);
  CHECK_NEAR(box.X_LS.p, Eigen::Vector3d(0.03, 0, 0), 0);
  CHECK_NEAR(box.X_LS.R.col(0), Eigen::Vector3d(std::cos(0.5), std::sin(0.5), 0), kEps);
  CHECK(sphere.solid.kind == Solid::Kind::kSphere);
  CHECK(sphere.solid.radius == 0.06);
  CHECK_NEAR(sphere.X_LS.p, Eigen::Vector3d(0, 0.03, 0), 0);
}

TEST_CASE("DH description: a mistake is told with its place, its owner, its key and the nearest right one") {
  Value misspelt(0.1);
  misspelt.at({"hands/x/hand.lua", 12});
  CHECK_THROWS_SAYING(make_hand(with(planar_hand(), "unit_lenght", misspelt)), InputError,
                      "hands/x/hand.lua:12: hand description: unknown key 'unit_lenght'; did you mean 'unit_length'?");
  CHECK_THROWS_SAYING(make_hand(with_joint(planar_hand(), "alpa", misspelt)), InputError,
                      "hands/x/hand.lua:12: finger 1 'thumb', joint 1 'thumb_1': unknown key 'alpa'; did you mean "
                      "'alpha'?");
  CHECK_THROWS_SAYING(make_hand(with_finger(planar_hand(), 1, "jionts", misspelt)), InputError,
                      "finger 2 'index': unknown key 'jionts'; did you mean 'joints'?");
}

TEST_CASE("DH description: a mistake without a place of its own points at the table around it") {
  Value description = with_joint(planar_hand(), "limits", Value::numbers({1, -1}));
  description.find("fingers")->items()[0].at({"hand.lua", 7});
  CHECK_THROWS_SAYING(make_hand(description), InputError, "hand.lua:7: finger 1 'thumb', joint 1");
}

TEST_CASE("DH description: what is missing is named") {
  Value description = planar_hand();
  description.erase("maximum_opening");
  CHECK_THROWS_SAYING(make_hand(description), InputError, "hand description: 'maximum_opening' is missing");
  description = planar_hand();
  description.find("fingers")->items()[0].erase("role");
  CHECK_THROWS_SAYING(make_hand(description), InputError, "finger 1 'thumb': 'role' is missing");
  description.find("fingers")->items()[0].erase("name");
  CHECK_THROWS_SAYING(make_hand(description), InputError, "finger 1: ");
  CHECK_THROWS_SAYING(make_hand(with(planar_hand(), "fingers", Value::list({}))), InputError,
                      "'fingers' must have at least one finger");
  CHECK_THROWS_SAYING(make_hand(with_finger(planar_hand(), 0, "joints", Value::list({}))), InputError,
                      "finger 1 'thumb': 'joints' must have at least one joint");
  CHECK_THROWS_SAYING(registry().create<HandModel>("dh"), InputError, "'description' is missing");
}

TEST_CASE("DH description: values of the wrong kind or out of their bounds are refused with both") {
  const Value hand = planar_hand();
  CHECK_THROWS_SAYING(make_hand(with(hand, "unit_length", 0.0)), InputError, "'unit_length' must be in 1e-06 .. 1, got 0");
  CHECK_THROWS_SAYING(make_hand(with(hand, "unit_length", 30.0)), InputError, "'unit_length' must be in 1e-06 .. 1, got 30");
  CHECK_THROWS_SAYING(make_hand(with(hand, "lengths", "mm")), InputError, "hand description: 'lengths' cannot be 'mm'");
  CHECK_THROWS_SAYING(make_hand(with(hand, "model", "urdf")), InputError, "'model' cannot be 'urdf'");
  CHECK_THROWS_SAYING(make_hand(with(hand, "fingers", Value::table({{"index", 1}}))), InputError,
                      "'fingers' must be a list of tables");
  CHECK_THROWS_SAYING(make_hand(with(hand, "fingers", Value::list({Value(3)}))), InputError,
                      "finger 1: expected a table of parameters, got number 3");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "alpha", 90)), InputError, "'alpha' must be in -6.28");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "a", INFINITY)), InputError, "'a' must be in -1000 .. 1000, got inf");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "type", "revolut")), InputError, "did you mean 'revolute'?");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "limits", Value::numbers({0}))), InputError,
                      "'limits' must have 2 numbers, got 1");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "limits", Value::numbers({1, -1}))), InputError,
                      "'limits' must be { lower, upper } with lower <= upper, got { 1, -1 }");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "limits", Value::numbers({-30, 90}))), InputError,
                      "'limits' are in radians, got { -30, 90 }; write math.rad(90)");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "limits", Value::numbers({-30, 1}))), InputError,
                      "'limits' are in radians, got { -30, 1 }");
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 0, "tip", Value::numbers({1, 2}))), InputError,
                      "finger 1 'thumb': 'tip' must have 3 numbers, got 2");
}

TEST_CASE("DH description: names and roles are taken once") {
  const Value hand = planar_hand();
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 1, "name", "thumb")), InputError, "'thumb' is taken by another finger");
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 1, "role", "thumb")), InputError,
                      "finger 2 'index': 'role' 'thumb' is taken by finger 'thumb'");
  CHECK_THROWS_SAYING(make_hand(with_joint(hand, "name", "thumb_2")), InputError, "'thumb_2' is taken by another joint");
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 1, "role", "pinky")), InputError, "'role' cannot be 'pinky'");
}

TEST_CASE("DH description: solids that cannot be are refused") {
  const Value hand = planar_hand();
  const Value ends = Value::numbers({0, 0, 0});
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 0, "links", solid({{"link", 3}, {"from", ends}, {"to", ends}, {"radius", 1}}))),
                      InputError, "link solid 1: 'link' must be at most 2, the finger's number of joints, got 3");
  CHECK_THROWS_SAYING(make_hand(with_finger(hand, 0, "links", solid({{"from", ends}, {"to", ends}, {"radius", 1}}))),
                      InputError, "finger 1 'thumb', link solid 1: 'link' is missing");
  CHECK_THROWS_SAYING(make_hand(with(hand, "palm", solid({{"from", ends}, {"to", ends}, {"radius", -1}}))), InputError,
                      "palm, solid 1: 'radius' must be in 1e-06 .. 1000, got -1");
  CHECK_THROWS_SAYING(make_hand(with(hand, "palm", solid({{"shape", "box"}, {"half_extents", ends}}))), InputError,
                      "'half_extents' must be positive");
  CHECK_THROWS_SAYING(make_hand(with(hand, "palm", solid({{"shape", "bocks"}, {"half_extents", ends}}))), InputError,
                      "'shape' cannot be 'bocks'");
  CHECK_THROWS_SAYING(make_hand(with(hand, "palm", solid({{"shape", "sphere"}, {"radius", 1}, {"to", ends}}))), InputError,
                      "palm, solid 1: unknown key 'to'");
}

TEST_SUITE_END();
