#include <cmath>
#include <numbers>
#include <optional>

#include "preshape/base/error.h"
#include "preshape/hand/posture.h"
#include "support/hands.h"
#include "support/near.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;
using Eigen::Vector3d;

TEST_SUITE_BEGIN("plugins/simulator");

namespace {

/// A box before a hand, the Utah/MIT one unless another is named: the hand comes along +X, the forefingers push +Y, fingers stand side by side along Z.
struct Scene {
  explicit Scene(Vector3d extents = {0.05, 0.05, 0.12}, int forefingers = 2, const char* name = "utah_mit")
      : hand(*shipped_hands().at(name)), backend(registry().create<CollisionBackend>("brute")),
        object(build_scene(backend, centred_box(extents))) {
    const double half = 0.5 * extents.y(), u = hand.dimensions().finger_spacing_m;
    add({0, half, 0}, {0, -1, 0}, FingerRole::kThumb);
    const FingerRole roles[] = {FingerRole::kIndex, FingerRole::kMiddle, FingerRole::kRing};
    for (int i = 0; i < forefingers; ++i) add({0, -half, u * (i - 0.5 * (forefingers - 1))}, {0, 1, 0}, roles[i % 3]);
  }

  void add(const Vector3d& p_OC, const Vector3d& n, FingerRole role) {
    contacts.push_back(ContactFrame::at(p_OC, n, Vector3d::UnitX()));
    fingers.push_back(role);
  }

  Simulation run(const Value& parameters = {}) const {
    const SimulationTask task{hand, *backend, *object, contacts, fingers, Vector3d::UnitX(), Vector3d::UnitY(), 0.01, support ? &*support : nullptr};
    return registry().create<GraspSimulator>("kinematic", parameters)->simulate(task, 1, nullptr);
  }

  Vector3d tip(const Simulation& simulation, std::size_t contact, std::size_t posture) const {
    return simulation.X_OH * finger_poses(hand, simulation.fingers[contact].finger, simulation.path[posture]).back().p;
  }

  const HandModel& hand;
  std::shared_ptr<const CollisionBackend> backend;
  std::shared_ptr<const CollisionScene> object;
  std::vector<ContactFrame> contacts;
  std::vector<FingerRole> fingers;
  std::optional<SupportPlane> support;
};

using Status = Simulation::Status;

}  // namespace

TEST_CASE("Kinematic: a box in front of the hand is grasped with one, two and three forefingers, each tip at its contact") {
  for (const int forefingers : {1, 2, 3}) {
    const Scene scene({0.05, 0.05, 0.12}, forefingers);
    const Simulation simulation = scene.run();
    INFO(forefingers, " forefingers: ", simulation.reason);
    REQUIRE(simulation.status == Status::kReached);
    CHECK(simulation.reason.empty());
    CHECK(simulation.way_m == doctest::Approx(0.1));
    REQUIRE(simulation.fingers.size() == scene.contacts.size());
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      CHECK(simulation.fingers[i].reached);
      CHECK_NEAR(scene.tip(simulation, i, simulation.path.size() - 1), scene.contacts[i].p_OC, 1e-4);
      // Open, the tip stands the clearance away from the face, back along the way that it pushes.
      CHECK_NEAR(scene.tip(simulation, i, 0), (scene.contacts[i].p_OC - 0.01 * scene.contacts[i].n).eval(), 2e-4);
    }
    for (const auto& posture : simulation.path) CHECK(within_limits(scene.hand, posture, 1e-9));
  }
}

TEST_CASE("Kinematic: the hand comes along the approach axis with its thumb against its forefingers") {
  const Simulation simulation = Scene().run(Value::table({{"leans", Value::numbers({0.0})}}));
  REQUIRE(simulation.status == Status::kReached);
  CHECK_NEAR(simulation.X_OH.R.col(2), Vector3d::UnitX(), 1e-12);   // +Z of H: the approach
  CHECK_NEAR(simulation.X_OH.R.col(1), -Vector3d::UnitY(), 1e-12);  // +Y of H: from the thumb to the forefingers
}

TEST_CASE("Kinematic: a hand leans about its +X, comes along as it leans, and opens by the clearance as the object sees it") {
  for (const double lean : {-20.0, 20.0}) {
    for (const char* name : {"utah_mit", "barrett"}) {
      const Scene scene({0.05, 0.06, 0.12}, 1, name);
      const Simulation simulation = scene.run(Value::table({{"leans", Value::numbers({lean})}, {"slants", Value::numbers({20.0, 45.0, 70.0, 90.0})}}));
      INFO(name, " ", lean, ": ", simulation.reason);
      REQUIRE(simulation.status == Status::kReached);
      const double angle = lean * std::numbers::pi / 180.0;
      if (scene.hand.joints().size() == 16) CHECK_NEAR(simulation.X_OH.R.col(2), Vector3d(std::cos(angle), std::sin(angle), 0), 1e-8);
      for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
        CHECK(scene.contacts[i].n.dot(scene.contacts[i].p_OC - scene.tip(simulation, i, 0)) >= 0.01 - 1e-4);
      }
    }
  }
}

TEST_CASE("Kinematic: fingers do not cross, whatever names the contacts are given") {
  Scene scene({0.05, 0.05, 0.12}, 3);
  std::swap(scene.fingers[1], scene.fingers[3]);
  const Simulation simulation = scene.run();
  REQUIRE(simulation.status == Status::kReached);
  const auto across = [&](std::size_t i) { return finger_poses(scene.hand, simulation.fingers[i].finger, middle_posture(scene.hand)).front().p.x(); };
  const Vector3d X_H = simulation.X_OH.R.col(0);
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = 1; k < i; ++k) {
      const double contacts = X_H.dot(scene.contacts[i].p_OC - scene.contacts[k].p_OC);
      CHECK(contacts * (across(i) - across(k)) > 0.0);
    }
  }
}

TEST_CASE("Kinematic: a hand of one drive a finger holds a box too, opened by at least the clearance where it cannot meet the places before it") {
  for (const int forefingers : {1, 2}) {
    const Scene scene({0.05, 0.06, 0.12}, forefingers, "barrett");
    const Simulation simulation = scene.run();
    INFO(forefingers, " forefingers: ", simulation.reason);
    REQUIRE(simulation.status == Status::kReached);
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      const ContactFrame& C = scene.contacts[i];
      CHECK_NEAR(scene.tip(simulation, i, simulation.path.size() - 1), C.p_OC, 1e-4);
      CHECK(C.n.dot(C.p_OC - scene.tip(simulation, i, 0)) >= 0.01 - 1e-4);
    }
    for (const auto& posture : simulation.path) {
      CHECK(within_limits(scene.hand, posture, 1e-9));
      Posture coupled = posture;
      apply_couplings(scene.hand, coupled);
      for (std::size_t j = 0; j < posture.size(); ++j) CHECK(posture[j] == doctest::Approx(coupled[j]));
    }
  }
  // A hand that may not turn cannot: its fingers stand beside each other.
  CHECK(Scene({0.05, 0.06, 0.12}, 1, "barrett").run(Value::table({{"turn", 0.0}})).status != Status::kReached);
}

TEST_CASE("Kinematic: a finger without a contact is put where it touches nothing") {
  Scene scene({0.05, 0.05, 0.12}, 1);
  const Simulation alone = scene.run();
  REQUIRE(alone.status == Status::kReached);
  const int idle = [&] {
    for (int finger = 0; finger < 4; ++finger) {
      if (finger != alone.fingers[0].finger && finger != alone.fingers[1].finger) return finger;
    }
    return -1;
  }();
  // A small block where the idle finger's tip was: it is bent another way, nothing else changes.
  const Vector3d at = alone.X_OH * finger_poses(scene.hand, idle, alone.path.back()).back().p, half = Vector3d::Constant(0.004);
  scene.object = build_scene(scene.backend, joined({centred_box({0.05, 0.05, 0.12}), box_between(at - half, at + half)}));
  const Simulation avoiding = scene.run(Value::table({{"way", 0.0}}));
  INFO(avoiding.reason);
  REQUIRE(avoiding.status == Status::kReached);
  CHECK(avoiding.X_OH.p == alone.X_OH.p);
  CHECK((avoiding.X_OH * finger_poses(scene.hand, idle, avoiding.path.back()).back().p - at).norm() > 0.004);
}

TEST_CASE("Kinematic: fingertips that only the object's inside leads to are named") {
  Scene scene;
  for (auto& C : scene.contacts) C = ContactFrame::at(C.p_OC, -C.n, Vector3d::UnitX());
  const Simulation simulation = scene.run(Value::table({{"turn", 0.0}, {"leans", Value::numbers({0.0})}, {"slants", Value::numbers({90.0})}}));
  CHECK(simulation.status == Status::kCollision);
  INFO(simulation.reason);
  CHECK(simulation.reason.find("through the object: ") != std::string::npos);
}

TEST_CASE("Kinematic: what is too wide, too far or has too many contacts is told, with the finger") {
  Scene wide({0.05, 0.5, 0.12});
  const Simulation unreached = wide.run(Value::table({{"stand_offs", 3}, {"leans", Value::numbers({0.0})}}));
  CHECK(unreached.status == Status::kUnreachable);
  CHECK(unreached.reason.find("not all fingertips reach their contacts: ") == 0);
  CHECK(unreached.reason.find("thumb by ") != std::string::npos);
  Scene many({0.05, 0.05, 0.12}, 4);
  const Simulation few = many.run();
  CHECK(few.status == Status::kTooFewFingers);
  CHECK(few.reason.find("the grasp has 5 contacts") == 0);
  CHECK(few.reason.find("3 forefingers") != std::string::npos);
}

TEST_CASE("Kinematic: the hand stands aside of a support; one at the contacts makes it collide, one far below does nothing") {
  Scene scene;
  scene.support = SupportPlane{Vector3d::UnitZ(), -0.025};
  const Simulation aside = scene.run(Value::table({{"turn", 0.0}, {"leans", Value::numbers({0.0})}}));
  CHECK(aside.status == Status::kReached);
  CHECK(aside.X_OH.p.z() >= 0.05);  // the palm is 150 mm wide: it stands aside, off the support 25 mm below the box's middle
  scene.support->height_m = -0.3;
  const Simulation free = scene.run();
  CHECK(free.status == Status::kReached);
  scene.support->height_m = 0.05;
  const Simulation blocked = scene.run();
  REQUIRE(blocked.collisions.size() == 1);
  CHECK(blocked.collisions[0].other == Collision::kSupport);
  CHECK(blocked.reason.find("touches the support") != std::string::npos);
  scene.support->normal_O = {0, 0, 2};
  CHECK_THROWS_SAYING(scene.run(), InputError, "support: the normal must be of unit length");
}

TEST_CASE("Kinematic: a wall in the way of the open hand is met before the object is") {
  Scene scene;
  TriangleMesh meshes = centred_box({0.05, 0.05, 0.12});
  const TriangleMesh wall = box_between({-0.15, -0.4, -0.4}, {-0.14, 0.4, 0.4});
  scene.object = build_scene(scene.backend, joined({meshes, wall}));
  const Simulation simulation = scene.run();
  CHECK(simulation.status == Status::kCollision);
  INFO(simulation.reason);
  CHECK(simulation.reason.find("touches the object") != std::string::npos);
  CHECK(simulation.way_m < 0.1);
  CHECK(scene.run(Value::table({{"way", 0.0}})).status == Status::kReached);
}

TEST_CASE("Kinematic: the same task and seed give the same motion to the last bit") {
  const Scene scene;
  const Simulation a = scene.run(), b = scene.run();
  CHECK(a.path == b.path);
  CHECK(a.X_OH.p == b.X_OH.p);
}

TEST_SUITE_END();
