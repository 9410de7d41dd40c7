#include "grasp_execution.h"

#include <algorithm>
#include <limits>

#include "preshape/agent/station_search.h"
#include "preshape/grasp/joint_action.h"

namespace preshape {

namespace {

/// Which of a hand's fingers makes each contact of a grasp.
std::vector<FingerRole> roles_of(const VirtualGrasp& grasp) {
  static constexpr std::pair<std::string_view, FingerRole> kRoles[] = {
      {"thumb", FingerRole::kThumb}, {"index", FingerRole::kIndex}, {"middle", FingerRole::kMiddle},
      {"ring", FingerRole::kRing},   {"little", FingerRole::kLittle}};
  std::vector<FingerRole> fingers;
  for (const auto& name : grasp.fingers) {
    for (const auto& [known, role] : kRoles) {
      if (name == known) fingers.push_back(role);
    }
  }
  return fingers;
}

/// The fingers that hold, as the simulator tells them, else by their roles; none when the hand lacks a role.
std::vector<int> holding_fingers(const HandModel& hand, const VirtualGrasp& grasp, const Simulation& simulation) {
  std::vector<int> fingers;
  for (const auto& outcome : simulation.fingers) fingers.push_back(outcome.finger);
  if (!fingers.empty()) return fingers;
  for (const FingerRole role : roles_of(grasp)) {
    const auto all = hand.fingers();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Finger& f) { return f.role == role; });
    if (found == all.end()) return {};
    fingers.push_back(static_cast<int>(found - all.begin()));
  }
  return fingers;
}

/// The plane on which the object stands with that side.
SupportPlane support_of(const SensedObject& object, const ExecutionSettings& settings) {
  SupportPlane support;
  support.normal_O = -settings.support_sign * Eigen::Vector3d::Unit(settings.support_axis);
  const Box& box = object.object.box_O;
  support.height_m = std::min(support.normal_O.dot(box.lower), support.normal_O.dot(box.upper));
  return support;
}

}  // namespace

Simulation GraspExecution::simulate(const SensedObject& object, const VirtualGrasp& grasp) const {
  const std::vector<FingerRole> fingers = roles_of(grasp);
  const PreshapeAnalyser& analyser = *parts_.analyser;
  const ApproachPlane& plane = analyser.planes()[static_cast<std::size_t>(grasp.plane)];
  const double clearance_m = analyser.settings().ray_margin_U * analyser.hand().unit_length_m;
  const bool stands = parts_.settings.support_axis >= 0;
  const SupportPlane support = stands ? support_of(object, parts_.settings) : SupportPlane{};
  return parts_.simulator->simulate({*parts_.hand, *parts_.collision, *object.scene, grasp.contacts, fingers, plane.a, plane.n_f,
                                     clearance_m, stands ? &support : nullptr},
                                    parts_.seed, parts_.progress);
}

Simulation GraspExecution::carry_out(const SensedObject& object, VirtualGrasp& grasp) const {
  Simulation simulation = simulate(object, grasp);
  if (simulation.status != Simulation::Status::kReached || simulation.path.empty()) return simulation;
  const std::vector<int> fingers = holding_fingers(*parts_.hand, grasp, simulation);
  if (fingers.empty()) return simulation;
  parts_.analyser->measure(object.length_m, grasp, joint_actions(*parts_.hand, fingers, simulation.path.back(), simulation.X_OH));
  return simulation;
}

std::optional<ImpartedTwists> GraspExecution::imparted(const SensedObject& object, const VirtualGrasp& grasp, const Simulation& simulation) const {
  if (simulation.status != Simulation::Status::kReached || simulation.path.empty()) return std::nullopt;
  const std::vector<int> fingers = holding_fingers(*parts_.hand, grasp, simulation);
  if (fingers.size() != grasp.contacts.size()) return std::nullopt;
  const auto actions = joint_actions(*parts_.hand, fingers, simulation.path.back(), simulation.X_OH);
  return imparted_twists(*parts_.contact, grasp.contacts, actions, drive_shares(*parts_.hand, fingers), object.length_m);
}

std::vector<JudgedGrasp> GraspExecution::serving(const SensedObject& object, const InternalCritic& critic, const Task& task) const {
  const PreshapeAnalyser& analyser = *parts_.analyser;
  std::vector<Station> stations;
  for (int plane = 0; plane < static_cast<int>(analyser.planes().size()); ++plane) {
    for (const double x : station_grid(analyser.settings().station_step)) stations.push_back({plane, x, 0});
  }
  std::vector<VirtualGrasp> grasps(stations.size());
  analyser.analyse(object, stations, grasps);
  std::vector<JudgedGrasp> all;
  for (auto& grasp : grasps) {
    if (!grasp.is_grasp()) continue;
    JudgedGrasp judged;
    judged.confidence = std::numeric_limits<double>::quiet_NaN();
    judged.preshape = analyser.preshape(object, grasp);
    judged.criticism = critic.judge(task.screw, components(grasp.resultant));
    judged.grasp = std::move(grasp);
    if (critic.serves(judged.criticism.first)) all.push_back(std::move(judged));
  }
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return critic.nearer(a.criticism, b.criticism); });
  return all;
}

SecondTry GraspExecution::try_others(const SensedObject& object, const InternalCritic& critic, const Task& task,
                                     const JudgedGrasp& first) const {
  SecondTry other;
  if (parts_.settings.attempts == 0) return other;
  std::vector<Preshape> tried = {first.preshape};
  for (auto& judged : serving(object, critic, task)) {
    if (other.attempts == parts_.settings.attempts) break;
    if (std::find(tried.begin(), tried.end(), judged.preshape) != tried.end()) continue;
    tried.push_back(judged.preshape);
    ++other.attempts;
    other.simulation = carry_out(object, judged.grasp);
    if (other.simulation.status != Simulation::Status::kReached) continue;
    other.imparted = imparted(object, judged.grasp, other.simulation);
    other.grasp = std::move(judged);
    break;
  }
  return other;
}

}  // namespace preshape
