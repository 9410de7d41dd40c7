#include <cmath>
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

/// A box before the Utah/MIT hand: the hand comes along +X, the forefingers push +Y, fingers stand side by side along Z.
struct Scene {
  explicit Scene(Vector3d extents = {0.05, 0.05, 0.12}, int forefingers = 2)
      : hand(*shipped_hands().at("utah_mit")), backend(registry().create<CollisionBackend>("brute")),
        object(build_scene(backend, centred_box(extents))) {
    const double half = 0.5 * extents.y(), u = hand.dimensions().unit_length_m;
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

TEST_CASE("Kinematic: what is too wide, too far or has too many contacts is told, with the finger") {
  Scene wide({0.05, 0.5, 0.12});
  const Simulation unreached = wide.run();
  CHECK(unreached.status == Status::kUnreachable);
  CHECK(unreached.reason.find("not all fingertips reach their contacts: ") == 0);
  CHECK(unreached.reason.find("thumb by ") != std::string::npos);
  Scene many({0.05, 0.05, 0.12}, 4);
  const Simulation few = many.run();
  CHECK(few.status == Status::kTooFewFingers);
  CHECK(few.reason.find("the grasp has 5 contacts") == 0);
  CHECK(few.reason.find("3 forefingers") != std::string::npos);
}

TEST_CASE("Kinematic: a support in the hand's way makes it collide, one below the hand does not") {
  Scene scene;
  scene.support = SupportPlane{Vector3d::UnitZ(), -0.06};
  CHECK(scene.run().status == Status::kCollision);  // the palm is 150 mm wide, the box stands 60 mm below its middle
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
