#include "preshape/io/grasp_scene.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/run_approach.h"
#include "preshape/hand/posture.h"

namespace preshape {

namespace {

std::vector<SceneLink> links_of(const HandModel& hand, const Simulation& simulation) {
  std::vector<SceneLink> links;
  for (int i = 0; i < static_cast<int>(hand.solids().size()); ++i) {
    const LinkSolid& solid = hand.solids()[static_cast<std::size_t>(i)];
    SceneLink link{solid_name(hand, i), solid.solid, {}};
    for (const Posture& posture : simulation.path) {
      const Pose X_HL = solid.finger < 0 ? Pose{} : finger_poses(hand, solid.finger, posture)[static_cast<std::size_t>(solid.link)];
      link.X_OS.push_back(simulation.X_OH * X_HL * solid.X_LS);
    }
    links.push_back(std::move(link));
  }
  return links;
}

void mark_collisions(std::vector<SceneLink>& links, const Simulation& simulation) {
  for (const Collision& collision : simulation.collisions) {
    for (const int solid : {collision.solid, collision.other}) {
      if (solid >= 0 && solid < static_cast<int>(links.size()))
        links[static_cast<std::size_t>(solid)].collides = true;
    }
  }
}

/// The grasp that is shown and what became of it in the hand.
struct Shown {
  const VirtualGrasp* grasp = nullptr;
  const Simulation* simulation = nullptr;
  int number = 1;  ///< of the try
};

Shown shown_of(const RunRecord& record, ShownTry shown) {
  if (!record.report.result || !record.report.result->grasp.is_grasp()) return {};
  if (shown == ShownTry::kCarriedOut && record.second_try && record.second_try->grasp)
    return {&record.second_try->grasp->grasp, &record.second_try->simulation, 2};
  return {&record.report.result->grasp, record.simulation ? &*record.simulation : nullptr, 1};
}

/// "second try: plane 9, x = +0.50 of the half extent".
std::string words_of(const Shown& shown) {
  return fmt::format("{} try: plane {}, x = {:+.2f} of the half extent",
                     shown.number == 2 ? "second" : "first", shown.grasp->plane + 1,
                     shown.grasp->approach_fraction);
}

/// What became of the grasp that is shown, and of the other one where there is one.
std::string hand_verdict(const RunRecord& record, const Shown& shown) {
  const Simulation& first = *record.simulation;
  if (first.status == Simulation::Status::kReached) return " The hand carries it out.";
  if (shown.number == 2)
    return fmt::format(" Shown is the {}, which the hand carries out; the first it does not: {}.",
                       words_of(shown), first.reason);
  std::string words = fmt::format(" The hand does not: {}.", first.reason);
  if (record.second_try && record.second_try->grasp) words += " Another station that serves it can be carried out.";
  return words;
}

void add_grasp(GraspScene& scene, const RunRecord& record, const VirtualGrasp& grasp) {
  const ApproachPlane& plane = record.planes[static_cast<std::size_t>(grasp.plane)];
  scene.contacts = grasp.contacts;
  scene.fingers = grasp.fingers;
  scene.F_C_O = grasp.F_C_O;
  scene.resultant_O = grasp.resultant;
  scene.approach_O = plane.a;
  scene.opposition_O = plane.n_f;
  scene.approach_m = grasp.approach_m;
}

void add_hand(GraspScene& scene, const RunRecord& record, const Shown& shown) {
  scene.links = links_of(*record.hand_model, *shown.simulation);
  mark_collisions(scene.links, *shown.simulation);
  scene.frames = static_cast<int>(shown.simulation->path.size());
  scene.way_O = shown.simulation->way_m * shown.simulation->X_OH.R.col(2);
  scene.approach_volume = approach_volume_of(record, *shown.grasp, *shown.simulation);
  scene.verdict += hand_verdict(record, shown);
  scene.shown_try = shown.number;
  if (record.second_try && record.second_try->grasp) scene.shown = words_of(shown);
}

}  // namespace

std::string solid_name(const HandModel& hand, int index) {
  const LinkSolid& solid = hand.solids()[static_cast<std::size_t>(index)];
  const auto before = hand.solids().first(static_cast<std::size_t>(index));
  const auto same = std::count_if(before.begin(), before.end(), [&](const LinkSolid& s) { return s.finger == solid.finger && s.link == solid.link; });
  const std::string of = solid.finger < 0 ? "palm" : fmt::format("{} link {}", hand.fingers()[static_cast<std::size_t>(solid.finger)].name, solid.link);
  return same == 0 ? of : fmt::format("{} ({})", of, same + 1);
}

GraspScene grasp_scene(const RunRecord& record, ShownTry which) {
  GraspScene scene;
  const Report& report = record.report;
  scene.title = fmt::format("{}, {}", record.object->object.name,
                            report.task.name.empty() ? "task as given" : report.task.name);
  scene.object_O = record.object->object.mesh_O;
  scene.length_m = record.object->length_m;
  scene.verdict = report.verdict;
  const Shown shown = shown_of(record, which);
  if (shown.grasp) add_grasp(scene, record, *shown.grasp);
  if (shown.simulation && record.hand_model && !shown.simulation->path.empty())
    add_hand(scene, record, shown);
  return scene;
}

}  // namespace preshape
