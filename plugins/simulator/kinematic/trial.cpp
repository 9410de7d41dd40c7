#include "trial.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace preshape::kinematic {

namespace {

constexpr double kLargestStep = 0.08;  // [rad or m] of a joint between two postures of the path

std::vector<Posture> path_between(const Posture& open, const Posture& grasp) {
  double farthest = 0.0;
  for (std::size_t j = 0; j < open.size(); ++j) farthest = std::max(farthest, std::abs(grasp[j] - open[j]));
  const int steps = std::max(1, static_cast<int>(std::ceil(farthest / kLargestStep)));
  std::vector<Posture> path;
  for (int step = 0; step <= steps; ++step) {
    path.push_back(open);
    for (std::size_t j = 0; j < open.size(); ++j) path.back()[j] = step == steps ? grasp[j] : std::lerp(open[j], grasp[j], static_cast<double>(step) / steps);
  }
  return path;
}

/// The way the hand comes: its own z axis, so that a leaning hand comes as it leans.
Eigen::Vector3d approach_of(const Hold& hold) { return hold.X_OH.R.col(2); }

}  // namespace

Simulation Trial::of(Hold& hold) const {
  Simulation simulation;
  idle_.open(hold);
  simulation.X_OH = hold.X_OH;
  simulation.path = path_between(hold.open, hold.grasp);
  simulation.contact_error_m = hold.error_m;
  simulation.fingers = outcomes(hold);
  simulation.status = Simulation::Status::kUnreachable;
  if (!hold.reached(settings_.tolerance_m)) {
    simulation.reason = unreached(simulation);
  } else if (!hold.from_outside()) {
    simulation.status = Simulation::Status::kCollision;
    simulation.reason = through_the_object(hold);
  } else if (!hold.reaches(settings_.tolerance_m)) {
    simulation.reason = fmt::format("the hand does not open wide enough: a fingertip lacks {:.1f} mm of the clearance before its contact",
                                    1e3 * hold.open_error_m);
  } else if (const auto collision = freed_way(hold, simulation)) {
    simulation.status = Simulation::Status::kCollision;
    simulation.collisions = {*collision};
    simulation.reason = met(*collision, simulation);
  } else {
    simulation.status = Simulation::Status::kReached;
  }
  return simulation;
}

/// The same as on_the_way, idle fingers put out of the way where it is theirs.
std::optional<Collision> Trial::freed_way(Hold& hold, Simulation& simulation) const {
  const auto found = on_the_way(hold, simulation);
  if (!found || !idle_.have(*found) || !idle_.put_aside(hold)) return found;
  simulation.path = path_between(hold.open, hold.grasp);
  return on_the_way(hold, simulation);
}

/// The first collision of the whole motion, from where the open hand begins to come. Notes the free part of the way.
std::optional<Collision> Trial::on_the_way(const Hold& hold, Simulation& simulation) const {
  LastSeen seen;
  for (std::size_t posture = simulation.path.size(); posture-- > 0;) {
    if (auto found = bodies_.first(hold.X_OH, simulation.path[posture], posture == 0 ? Assignment{} : hold.assignment, seen)) {
      found->posture = static_cast<int>(posture);
      simulation.way_m = settings_.way_m;
      return found;
    }
  }
  const int steps = static_cast<int>(std::ceil(settings_.way_m / settings_.way_step_m));
  for (int step = 1; step <= steps; ++step) {
    simulation.way_m = settings_.way_m * step / steps;
    const Pose behind{hold.X_OH.R, hold.X_OH.p - simulation.way_m * approach_of(hold)};
    if (auto found = bodies_.first(behind, hold.open, {}, seen)) {
      simulation.way_m = settings_.way_m * (step - 1) / steps;
      return found;
    }
  }
  simulation.way_m = settings_.way_m;
  return std::nullopt;
}

std::vector<FingerOutcome> Trial::outcomes(const Hold& hold) const {
  std::vector<FingerOutcome> all;
  for (std::size_t i = 0; i < hold.assignment.size(); ++i) {
    FingerOutcome outcome;
    outcome.finger = hold.assignment[i];
    outcome.error_m = (task_.contacts[i].p_OC - hold.X_OH * finger_poses(task_.hand, outcome.finger, hold.grasp).back().p).norm();
    outcome.reached = outcome.error_m <= settings_.tolerance_m;
    const Finger& finger = task_.hand.fingers()[static_cast<std::size_t>(outcome.finger)];
    for (const int joint : hold.at_limit) {
      if (joint >= finger.first_joint && joint < finger.first_joint + finger.joint_count) outcome.at_limit.push_back(joint);
    }
    all.push_back(std::move(outcome));
  }
  return all;
}

std::string Trial::unreached(const Simulation& simulation) const {
  std::string names;
  for (const auto& outcome : simulation.fingers) {
    if (outcome.reached) continue;
    names += fmt::format("{}{} by {:.1f} mm", names.empty() ? "" : ", ", task_.hand.fingers()[static_cast<std::size_t>(outcome.finger)].name, 1e3 * outcome.error_m);
  }
  return "not all fingertips reach their contacts: " + names;
}

std::string Trial::through_the_object(const Hold& hold) const {
  std::string names;
  for (const int finger : hold.from_inside) names += fmt::format("{}{}", names.empty() ? "" : ", ", task_.hand.fingers()[static_cast<std::size_t>(finger)].name);
  return "a fingertip could only come to its contact through the object: " + names;
}

std::string Trial::met(const Collision& collision, const Simulation& simulation) const {
  const double at_m = std::min(settings_.way_m, simulation.way_m + settings_.way_step_m);  // the first place that is not free
  const std::string when = simulation.way_m < settings_.way_m ? fmt::format("when the open hand is {:.0f} mm away", 1e3 * at_m)
                           : collision.posture == 0           ? std::string("when the hand is open around the object")
                                                              : fmt::format("as the fingers close, in posture {} of {}", collision.posture + 1, simulation.path.size());
  return fmt::format("{} touches {} {}", bodies_.name(collision.solid), bodies_.other_name(collision.other), when);
}

}  // namespace preshape::kinematic
