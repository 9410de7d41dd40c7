#include "preshape/io/grasp_scene.h"

#include <fmt/format.h>

#include "preshape/hand/posture.h"

namespace preshape {

namespace {

std::string link_name(const HandModel& hand, const LinkSolid& solid, int same) {
  const std::string of = solid.finger < 0 ? "palm" : fmt::format("{} link {}", hand.fingers()[static_cast<std::size_t>(solid.finger)].name, solid.link);
  return same == 0 ? of : fmt::format("{} ({})", of, same + 1);
}

std::vector<SceneLink> links_of(const HandModel& hand, const Simulation& simulation) {
  std::vector<SceneLink> links;
  for (const LinkSolid& solid : hand.solids()) {
    int same = 0;
    for (const auto& other : hand.solids()) {
      if (&other == &solid) break;
      same += other.finger == solid.finger && other.link == solid.link;
    }
    SceneLink link{link_name(hand, solid, same), solid.solid, {}};
    for (const Posture& posture : simulation.path) {
      const Pose X_HL = solid.finger < 0 ? Pose{} : finger_poses(hand, solid.finger, posture)[static_cast<std::size_t>(solid.link)];
      link.X_OS.push_back(simulation.X_OH * X_HL * solid.X_LS);
    }
    links.push_back(std::move(link));
  }
  return links;
}

/// " The hand carries it out." or why it does not.
std::string hand_verdict(const RunRecord& record) {
  if (record.simulation->status == Simulation::Status::kReached) return " The hand carries it out.";
  std::string words = fmt::format(" The hand does not: {}.", record.simulation->reason);
  if (record.second_try && record.second_try->grasp) words += " Another station that serves it can be carried out.";
  return words;
}

}  // namespace

GraspScene grasp_scene(const RunRecord& record) {
  GraspScene scene;
  const Report& report = record.report;
  scene.title = fmt::format("{}, {}", record.object->object.name, report.task.name.empty() ? "task as given" : report.task.name);
  scene.object_O = record.object->object.mesh_O;
  scene.length_m = record.object->length_m;
  scene.verdict = report.verdict;
  if (!report.result || !report.result->grasp.is_grasp()) return scene;
  const VirtualGrasp& grasp = report.result->grasp;
  const ApproachPlane& plane = record.planes[static_cast<std::size_t>(grasp.plane)];
  scene.contacts = grasp.contacts;
  scene.fingers = grasp.fingers;
  scene.F_C_O = grasp.F_C_O;
  scene.resultant_O = grasp.resultant;
  scene.approach_O = plane.a;
  scene.opposition_O = plane.n_f;
  scene.approach_m = grasp.approach_m;
  if (record.simulation && record.hand_model && !record.simulation->path.empty()) {
    scene.links = links_of(*record.hand_model, *record.simulation);
    scene.frames = static_cast<int>(record.simulation->path.size());
    scene.verdict += hand_verdict(record);
  }
  return scene;
}

}  // namespace preshape
