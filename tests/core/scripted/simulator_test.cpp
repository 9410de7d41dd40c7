#include "components.h"
#include "preshape/base/error.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

/// A hand of one finger with one sliding joint, above a unit cube.
struct Scene {
  OneComponent hand_file{"hand", "slider",
                         "return { dimensions = { unit_length = 1, finger_spacing = 1, maximum_opening = 4, base_width = 5 },\n"
                         "fingers = { { name = 'i', role = 'index', joints = { { name = 'slide', prismatic = true, lower = 0, upper = 3 } } } },\n"
                         "solids = { { finger = 'i', link = 1, shape = 'sphere', radius = 0.25 } } }"};
  std::shared_ptr<HandModel> hand = hand_file->create<HandModel>("slider");
  std::shared_ptr<CollisionBackend> collision = registry().create<CollisionBackend>("brute");
  std::shared_ptr<const CollisionScene> cube = build_scene(collision, centred_box({1, 1, 1}));
  std::vector<ContactFrame> contacts = {ContactFrame::at({0, 0, 0.5}, {0, 0, -1}, {1, 0, 0})};
  std::vector<FingerRole> roles = {FingerRole::kIndex};

  SimulationTask task() const { return {*hand, *collision, *cube, contacts, roles, {1, 0, 0}, {0, 0, -1}, 0.1}; }
  Simulation run(const std::string& body, std::uint64_t seed = 1) const {
    const OneComponent component("simulator", "x", "return { simulate = function(task, seed)\n" + body + "\nend }");
    return component->create<GraspSimulator>("x")->simulate(task(), seed, nullptr);
  }
  std::string failing(const std::string& body) const {
    try {
      run(body);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

}  // namespace

TEST_CASE("Lua simulator: the script sees the task and brings back hand, path and error") {
  const Scene scene;
  const Simulation done = scene.run(
      "local C, joint = task.contacts[1], task.hand.joints[1]\n"
      "assert(task.fingers[1] == 'index' and task.hand.fingers[1].name == 'i' and task.hand.fingers[1].first_joint == 1)\n"
      "assert(joint.prismatic and joint.upper == 3 and task.clearance == 0.1 and task.approach[1] == 1 and task.opposition[3] == -1)\n"
      "local tip = task.forward(1, { 2 })[3]\n"
      "return { status = 'reached', X_OH = { R = { 1, 0, 0, 0, -1, 0, 0, 0, -1 }, p = { 0, 0, C.p[3] + tip.p[3] } },\n"
      "  path = { { 0 }, { 2 } }, contact_error_m = 0.001 }");
  CHECK(done.status == Simulation::Status::kReached);
  CHECK(done.X_OH.p == Eigen::Vector3d(0, 0, 2.5));
  CHECK(done.X_OH.R(2, 2) == -1.0);
  CHECK(done.path == std::vector<std::vector<double>>{{0}, {2}});
  CHECK(done.contact_error_m == 0.001);
  const Simulation failed = scene.run("return { status = 'too_few_fingers', reason = 'One finger is not enough.' }");
  CHECK(failed.status == Simulation::Status::kTooFewFingers);
  CHECK(failed.reason == "One finger is not enough.");
}

TEST_CASE("Lua simulator: distances to the object are those of its collision scene") {
  const Scene scene;
  const Simulation done = scene.run(
      "local solid = task.hand.solids[1]\n"
      "solid.X_OS = { p = { 0, 0, 2 } }\n"
      "local d = task.object_distance({ solid, { shape = 'box', half_extents = { 0.5, 0.5, 0.5 }, X_OS = { p = { 3, 0, 0 } } } })\n"
      "return { status = 'collision', reason = 'no', contact_error_m = 10 * d[1] + d[2] }");
  CHECK_NEAR(done.contact_error_m, 12.5 + 2.0, 1e-12);
}

TEST_CASE("Lua simulator: wrong tasks and results are told with file and line") {
  const Scene scene;
  CHECK(scene.failing("return { status = 'arrived' }").find("x.plugin.lua:4: simulator 'x', simulate: 'status' cannot be 'arrived'") != std::string::npos);
  CHECK(scene.failing("return { status = 'collision' }").find("status 'collision' needs a 'reason', one sentence") != std::string::npos);
  CHECK(scene.failing("return { status = 'reached', path = { { 1, 2 } } }").find("simulate, posture 1: expected 1 finite numbers, got { 1, 2 }") != std::string::npos);
  CHECK(scene.failing("return 7").find("simulator 'x', simulate: expected a table of parameters, got number 7") != std::string::npos);
  CHECK(scene.failing("task.forward(2, {})").find("x.plugin.lua:5: forward: expected a finger in 1 .. 1, got number 2") != std::string::npos);
  CHECK(scene.failing("task.forward(1, { 'a' })").find("x.plugin.lua:5: forward: expected a list of 1 finite numbers, got item 1 = text 'a'") != std::string::npos);
  CHECK(scene.failing("task.object_distance({ { shape = 'sphere', X_OS = {} } })").find("object_distance, solid 1: a sphere has a positive 'radius'") != std::string::npos);
  const OneComponent component("simulator", "x", "return { simulate = function() end }");
  const auto simulator = component->create<GraspSimulator>("x");
  SimulationTask task = scene.task();
  task.approach_O = {2, 0, 0};
  CHECK_THROWS_SAYING(simulator->simulate(task, 1, nullptr), InputError, "the approach axis must be of unit length, got (2, 0, 0)");
  const std::vector<FingerRole> none;
  const SimulationTask odd{*scene.hand, *scene.collision, *scene.cube, scene.contacts, none, {1, 0, 0}, {0, 0, -1}, 0.0};
  CHECK_THROWS_SAYING(simulator->simulate(odd, 1, nullptr), InputError, "1 contacts do not go with 0 fingers");
}

TEST_SUITE_END();
