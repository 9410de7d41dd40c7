#include "io/simulation_json.h"

#include <numbers>

#include "io/run_approach.h"
#include "preshape/io/grasp_scene.h"

namespace preshape {

namespace {

Json finger_outcomes(const Simulation& simulation) {
  Json fingers = Json::array();
  for (const auto& outcome : simulation.fingers) {
    fingers.push_back({{"finger", outcome.finger + 1}, {"reached", outcome.reached}, {"error_m", number(outcome.error_m)},
                       {"joints_at_limit", outcome.at_limit}});
  }
  return fingers;
}

Json collisions_json(const RunRecord& record, const Simulation& simulation) {
  Json list = Json::array();
  const int count = record.hand_model ? static_cast<int>(record.hand_model->solids().size()) : 0;
  for (const Collision& collision : simulation.collisions) {
    if (collision.solid < 0 || collision.solid >= count || collision.other >= count) continue;
    const std::string other = collision.other == Collision::kObject    ? "object"
                              : collision.other == Collision::kSupport ? "support"
                                                                       : solid_name(*record.hand_model, collision.other);
    list.push_back({{"link", solid_name(*record.hand_model, collision.solid)}, {"with", other}, {"posture", collision.posture}});
  }
  return list;
}

Json vectors(const std::vector<Eigen::Vector3d>& points) {
  Json list = Json::array();
  for (const auto& p : points) list.push_back(vector(p));
  return list;
}

Json approach_volume_json(const RunRecord& record, const JudgedGrasp& judged, const Simulation& simulation) {
  const auto volume = approach_volume_of(record, judged.grasp, simulation);
  if (!volume) return nullptr;
  const Eigen::Vector3d& a = record.planes[static_cast<std::size_t>(judged.grasp.plane)].a;
  return {{"volume_m3", volume->volume_m3},
          {"entrance_O_m", vectors(volume->entrance_O)},
          {"entrance_centroid_O_m", vector(volume->centroid_O)},
          {"entrance_normal_O", vector(volume->normal_O)},
          {"angle_to_approach_deg", volume->angle_to(a) * 180.0 / std::numbers::pi}};
}

Json imparted_json(const RunRecord& record, const std::optional<ImpartedTwists>& imparted) {
  if (!imparted) return nullptr;
  Json twists = Json::array();
  for (const Twist& twist : imparted->twists_O) {
    const Eigen::Matrix<double, 6, 1> v = twist.vector();
    twists.push_back(std::vector<double>(v.data(), v.data() + 6));
  }
  return {{"twists_O", twists}, {"internal_motions", imparted->internal_motions}, {"task_share", number(share_of(*imparted, record.report.task))}};
}

}  // namespace

std::string_view simulation_status_name(Simulation::Status status) {
  static constexpr std::string_view kNames[] = {"reached", "unreachable", "collision", "too_few_fingers"};
  return kNames[static_cast<int>(status)];
}

Json simulation_json(const RunRecord& record, const std::optional<JudgedGrasp>& judged, const Simulation& simulation,
                     const std::optional<ImpartedTwists>& imparted) {
  const Eigen::Matrix3d R = simulation.X_OH.R.transpose();  // row by row
  return {{"status", simulation_status_name(simulation.status)},
          {"reason", simulation.reason},
          {"contact_error_m", number(simulation.contact_error_m)},
          {"hand_pose_O",
           {{"R", std::vector<double>(R.data(), R.data() + 9)}, {"p_m", vector(simulation.X_OH.p)}}},
          {"way_m", number(simulation.way_m)},
          {"approach_volume", judged ? approach_volume_json(record, *judged, simulation) : Json(nullptr)},
          {"fingers", finger_outcomes(simulation)},
          {"collisions", collisions_json(record, simulation)},
          {"imparted", imparted_json(record, imparted)},
          {"path", simulation.path}};
}

}  // namespace preshape
