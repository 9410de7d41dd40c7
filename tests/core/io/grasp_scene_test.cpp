#include "preshape/io/grasp_scene.h"

#include "preshape/hand/posture.h"
#include "reports.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/io");

namespace {

/// A run that the hand carries out.
RunRecord carried_out() {
  const RunRecord& record = records_of_every_status()[0];
  REQUIRE(record.simulation);
  REQUIRE(record.simulation->status == Simulation::Status::kReached);
  REQUIRE(record.simulation->path.size() > 1);
  return record;
}

/// The same, but its hand runs into something; another station, whose contacts are moved, is carried out as
/// it was.
RunRecord with_second_try() {
  RunRecord record = carried_out();
  SecondTry other{1, *record.report.result, *record.simulation};
  other.grasp->grasp.approach_fraction = 0.5;
  for (auto& contact : other.grasp->grasp.contacts) contact.p_OC.x() += 0.01;
  other.simulation.way_m = 0.07;
  record.second_try = other;
  record.simulation->status = Simulation::Status::kCollision;
  record.simulation->reason = "link 2 of the thumb touches the object";
  record.simulation->collisions = {{0, Collision::kObject, 0}, {3, 5, 1}, {2, Collision::kSupport, 1}};
  record.simulation->path.pop_back();
  return record;
}

std::vector<int> colliding(const GraspScene& scene) {
  std::vector<int> solids;
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    if (scene.links[i].collides) solids.push_back(static_cast<int>(i));
  }
  return solids;
}

}  // namespace

TEST_CASE("Scene: what the hand carries out is shown, with its contacts, its motion and words that say so") {
  const RunRecord record = with_second_try();
  const GraspScene scene = grasp_scene(record);
  const VirtualGrasp& grasp = record.second_try->grasp->grasp;
  CHECK(scene.shown_try == 2);
  CHECK(scene.shown == fmt::format("second try: plane {}, x = +0.50 of the half extent", grasp.plane + 1));
  CHECK(scene.contacts[0].p_OC == grasp.contacts[0].p_OC);
  CHECK(scene.frames == static_cast<int>(record.second_try->simulation.path.size()));
  CHECK_NEAR(scene.way_O, (0.07 * record.second_try->simulation.X_OH.R.col(2)).eval(), 1e-15);
  CHECK(colliding(scene).empty());
  CHECK(scene.verdict == fmt::format("{} Shown is the {}, which the hand carries out; the first it does not: "
                                     "link 2 of the thumb touches the object.",
                                     record.report.verdict, scene.shown));
}

TEST_CASE(
    "Scene: the first try is shown when it is asked for, or when there is no other; only two tries are told "
    "apart") {
  RunRecord record = with_second_try();
  const GraspScene first = grasp_scene(record, ShownTry::kFirst);
  CHECK(first.shown_try == 1);
  CHECK(first.shown.starts_with("first try: plane "));
  CHECK(first.contacts[0].p_OC == record.report.result->grasp.contacts[0].p_OC);
  CHECK(first.frames == static_cast<int>(record.simulation->path.size()));
  CHECK(
      first.verdict.ends_with("The hand does not: link 2 of the thumb touches the object. Another station "
                              "that serves it can be carried out."));
  record.second_try->grasp.reset();
  const GraspScene alone = grasp_scene(record);
  CHECK(alone.shown_try == 1);
  CHECK(alone.shown == "");
  CHECK(alone.contacts[0].p_OC == first.contacts[0].p_OC);
  CHECK(alone.verdict.ends_with("The hand does not: link 2 of the thumb touches the object."));
  CHECK(grasp_scene(carried_out()).shown == "");
}

TEST_CASE("Scene: both links of a collision are marked, and none for the object or the support") {
  CHECK(colliding(grasp_scene(with_second_try(), ShownTry::kFirst)) == std::vector<int>{0, 2, 3, 5});
  CHECK(colliding(grasp_scene(carried_out())).empty());
}

TEST_CASE("Scene: the approach volume is that of the open fingertips, wherever the motion ends") {
  RunRecord record = carried_out();
  const Simulation& simulation = *record.simulation;
  const GraspScene scene = grasp_scene(record);
  REQUIRE(scene.approach_volume);
  Eigen::Vector3d tips = Eigen::Vector3d::Zero(), corners = tips;
  for (const auto& outcome : simulation.fingers)
    tips +=
        simulation.X_OH * finger_poses(*record.hand_model, outcome.finger, simulation.path.front()).back().p;
  for (const auto& corner : scene.approach_volume->entrance_O) corners += corner;
  CHECK_NEAR(corners / static_cast<double>(scene.approach_volume->entrance_O.size()),
             tips / static_cast<double>(simulation.fingers.size()), 1e-12);
  record.simulation->path.resize(1);
  CHECK_NEAR(grasp_scene(record).approach_volume->centroid_O, scene.approach_volume->centroid_O, 0.0);
  record.simulation->fingers.clear();  // a simulator that does not tell
  CHECK_FALSE(grasp_scene(record).approach_volume);
}

TEST_SUITE_END();
