#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "bodies.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;
using namespace preshape::kinematic;

constexpr double kLargestStep = 0.08;  // [rad or m] of a joint between two postures of the path

/// Carries a virtual grasp out by geometry alone (thesis sec. 4.4): no mass, no force, no friction. The hand comes along the
/// approach axis, its thumb against its forefingers. How far behind the contacts it stands and how much it leans is chosen:
/// of the stances in which every fingertip reaches its contact, and opened its place before it, the least strained one
/// whose whole motion is free, that is the open hand's coming and the closing of the fingers, of collisions with the
/// object, the support and the hand itself. The last links of the grasp's fingers may touch the object.
class Kinematic final : public GraspSimulator {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("tolerance", 1e-4, 1e-6, 0.01, "m", "distance at which a fingertip has reached its place"),
            D::integer("stand_offs", 10, 1, 200, "-", "distances behind the contacts that are tried, up to a finger's length"),
            D::list("slants", {20.0, 45.0, 70.0}, 0.0, 90.0, "deg", "of the last links, from the contact's normal towards the approach axis, that are tried"),
            D::list("leans", {0.0, 15.0, -15.0, 30.0, -30.0}, -90.0, 90.0, "deg", "leans about the transverse axis that are tried, one after another"),
            D::number("way", 0.1, 0.0, 1.0, "m", "way along the approach axis that the open hand must be free to come"),
            D::number("way_step", 0.005, 1e-4, 0.1, "m", "distance of the places in which it is looked at there"),
            D::integer("candidates", 30, 1, 1000, "-", "stances of a lean whose whole motion is looked at, the least strained first")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant", "collision_free"}; }

  explicit Kinematic(const Parameters& p)
      : tolerance_m_(p.number("tolerance")), stand_offs_(static_cast<int>(p.integer("stand_offs"))), slants_deg_(p.numbers("slants")),
        leans_deg_(p.numbers("leans")),
        way_m_(p.number("way")), way_step_m_(p.number("way_step")), candidates_(static_cast<std::size_t>(p.integer("candidates"))) {}

  Simulation simulate(const SimulationTask& task, std::uint64_t seed, Progress* progress) const override {
    check(task);
    const auto ways = assignments(task, Reach::orientation(task, 0.0));
    if (ways.empty()) return too_few_fingers(task);
    const Bodies bodies(task);
    std::optional<Simulation> failed;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (progress) progress->advance("hand", static_cast<double>(i) / static_cast<double>(ways.size()), "");
      Simulation simulation = with(task, bodies, ways[i], seed);
      const bool reached = simulation.status == Simulation::Status::kReached;
      if (!failed || reached || nearer(simulation, *failed)) failed = std::move(simulation);
      if (reached) break;
    }
    if (progress) progress->advance("hand", 1.0, "");
    return std::move(*failed);
  }

 private:
  static void check(const SimulationTask& task) {
    require_size("fingers", task.contacts.size(), task.fingers.size());
    for (const ContactFrame& C : task.contacts) {
      if (!(C.p_OC + C.n + C.a + C.t).allFinite()) throw InputError("contacts: points and axes must be finite numbers");
    }
    for (const auto& axis : {task.approach_O, task.opposition_O}) {
      if (!(std::abs(axis.norm() - 1.0) <= 1e-6)) throw InputError("approach and opposition must be of unit length");
    }
    if (task.approach_O.cross(task.opposition_O).norm() < 1e-6) throw InputError("approach and opposition must not be parallel");
    if (!(task.clearance_m >= 0.0 && std::isfinite(task.clearance_m))) {
      throw InputError(fmt::format("clearance_m: expected a finite length of at least 0, got {}", task.clearance_m));
    }
    if (task.support && !(std::abs(task.support->normal_O.norm() - 1.0) <= 1e-6 && std::isfinite(task.support->height_m))) {
      throw InputError("support: the normal must be of unit length and the height finite");
    }
  }

  static Simulation too_few_fingers(const SimulationTask& task) {
    const auto fingers = task.hand.fingers();
    const auto thumbs = std::count_if(fingers.begin(), fingers.end(), [](const Finger& f) { return f.role == FingerRole::kThumb; });
    Simulation simulation;
    simulation.status = Simulation::Status::kTooFewFingers;
    simulation.reason = thumbs == 0 ? std::string("the hand has no thumb: name one of its fingers so")
                                    : fmt::format("the grasp has {} contacts, a thumb's and at least one forefinger's, and the hand has {} forefinger{}",
                                                  task.contacts.size(), std::ssize(fingers) - thumbs, std::ssize(fingers) - thumbs == 1 ? "" : "s");
    return simulation;
  }

  /// Whether a failure came nearer to success than another: something in the open hand's way is less than something where
  /// it closes, and that less than contacts out of reach.
  bool nearer(const Simulation& a, const Simulation& b) const {
    const auto rank = [this](const Simulation& s) { return s.status != Simulation::Status::kCollision ? 2 : s.way_m < way_m_ ? 0 : 1; };
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.contact_error_m < b.contact_error_m;
  }

  /// One assignment of fingers, lean after lean: a lean is taken only where less of it does not do.
  Simulation with(const SimulationTask& task, const Bodies& bodies, const Assignment& assignment, std::uint64_t seed) const {
    Reach reach(task, assignment, tolerance_m_, seed);
    std::optional<Simulation> best;
    for (const int starts : {1, 6}) {  // most is found where the stance before ended; drawn starts are for what is not
      reach.set_starts(starts);
      for (const double lean : leans_deg_) {
        Simulation simulation = leaning(task, bodies, reach, lean * std::numbers::pi / 180.0);
        const bool reached = simulation.status == Simulation::Status::kReached;
        if (!best || reached || nearer(simulation, *best)) best = std::move(simulation);
        if (reached) return std::move(*best);
      }
      if (best->status == Simulation::Status::kCollision) break;
    }
    return std::move(*best);
  }

  Simulation leaning(const SimulationTask& task, const Bodies& bodies, Reach& reach, double lean) const {
    std::vector<Hold> all;
    for (const double slant : slants_deg_) {
      for (int i = 0; i < stand_offs_; ++i) {
        const double share = stand_offs_ == 1 ? 0.6 : 0.15 + 0.85 * i / (stand_offs_ - 1.0);
        all.push_back(reach.hold({share * reach.length_m(), lean, slant * std::numbers::pi / 180.0}));
      }
    }
    const auto misses = [&](const Hold& hold) { return hold.reaches(tolerance_m_) ? 0.0 : std::max(hold.error_m, hold.open_error_m); };
    std::stable_sort(all.begin(), all.end(), [&](const Hold& a, const Hold& b) {
      if (misses(a) != misses(b)) return misses(a) < misses(b);
      return a.from_outside != b.from_outside ? a.from_outside : a.strain < b.strain;
    });
    Simulation best = judged(task, bodies, all.front());
    for (std::size_t i = 1; i < std::min(all.size(), candidates_) && best.status != Simulation::Status::kReached; ++i) {
      if (misses(all[i]) > 0.0) break;
      Simulation next = judged(task, bodies, all[i]);
      if (next.status == Simulation::Status::kReached || nearer(next, best)) best = std::move(next);
    }
    return best;
  }

  /// The motion of a hold, and what stands in its way.
  Simulation judged(const SimulationTask& task, const Bodies& bodies, const Hold& hold) const {
    Simulation simulation;
    simulation.X_OH = hold.X_OH;
    simulation.path = path_between(hold.open, hold.grasp);
    simulation.contact_error_m = hold.error_m;
    simulation.fingers = outcomes(task, hold);
    simulation.status = Simulation::Status::kUnreachable;
    if (hold.error_m > tolerance_m_) {
      simulation.reason = unreached(task, simulation);
    } else if (hold.open_error_m > tolerance_m_) {
      simulation.reason = fmt::format("the hand does not open wide enough: a fingertip stays {:.1f} mm from its place before its contact",
                                      1e3 * hold.open_error_m);
    } else if (!hold.from_outside) {
      simulation.status = Simulation::Status::kCollision;
      simulation.reason = "a finger could only come to its contact through the object";
    } else if (const auto collision = on_the_way(bodies, hold, simulation)) {
      simulation.status = Simulation::Status::kCollision;
      simulation.collisions = {*collision};
      simulation.reason = fmt::format("{} touches {} {}", bodies.name(collision->solid), bodies.other_name(collision->other),
                                      simulation.way_m < way_m_ ? fmt::format("when the open hand is {:.0f} mm away", 1e3 * simulation.way_m)
                                      : collision->posture == 0 ? std::string("when the hand is open around the object")
                                                                : fmt::format("as the fingers close, in posture {} of {}", collision->posture + 1, simulation.path.size()));
    } else {
      simulation.status = Simulation::Status::kReached;
    }
    return simulation;
  }

  /// The first collision of the whole motion, from where the open hand begins to come. Notes the free part of the way.
  std::optional<Collision> on_the_way(const Bodies& bodies, const Hold& hold, Simulation& simulation) const {
    const std::vector<int>& touching = hold.assignment;
    for (std::size_t posture = simulation.path.size(); posture-- > 0;) {
      if (auto found = bodies.first(hold.X_OH, simulation.path[posture], posture == 0 ? std::vector<int>{} : touching)) {
        found->posture = static_cast<int>(posture);
        simulation.way_m = way_m_;
        return found;
      }
    }
    const int steps = static_cast<int>(std::ceil(way_m_ / way_step_m_));
    for (int step = 1; step <= steps; ++step) {
      simulation.way_m = way_m_ * step / steps;
      const Pose behind{hold.X_OH.R, hold.X_OH.p - simulation.way_m * approach_of(hold)};
      if (auto found = bodies.first(behind, hold.open, {})) {
        simulation.way_m = way_m_ * (step - 1) / steps;
        return found;
      }
    }
    simulation.way_m = way_m_;
    return std::nullopt;
  }

  /// The way the hand comes: its own z axis, so that a leaning hand comes as it leans.
  static Eigen::Vector3d approach_of(const Hold& hold) { return hold.X_OH.R.col(2); }

  std::vector<FingerOutcome> outcomes(const SimulationTask& task, const Hold& hold) const {
    std::vector<FingerOutcome> all;
    for (std::size_t i = 0; i < hold.assignment.size(); ++i) {
      FingerOutcome outcome;
      outcome.finger = hold.assignment[i];
      outcome.error_m = (task.contacts[i].p_OC - hold.X_OH * finger_poses(task.hand, outcome.finger, hold.grasp).back().p).norm();
      outcome.reached = outcome.error_m <= tolerance_m_;
      const Finger& finger = task.hand.fingers()[static_cast<std::size_t>(outcome.finger)];
      for (const int joint : hold.at_limit) {
        if (joint >= finger.first_joint && joint < finger.first_joint + finger.joint_count) outcome.at_limit.push_back(joint);
      }
      all.push_back(std::move(outcome));
    }
    return all;
  }

  static std::string unreached(const SimulationTask& task, const Simulation& simulation) {
    std::string names;
    for (const auto& outcome : simulation.fingers) {
      if (outcome.reached) continue;
      names += fmt::format("{}{} by {:.1f} mm", names.empty() ? "" : ", ", task.hand.fingers()[static_cast<std::size_t>(outcome.finger)].name, 1e3 * outcome.error_m);
    }
    return "not all fingertips reach their contacts: " + names;
  }

  static std::vector<Posture> path_between(const Posture& open, const Posture& grasp) {
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

  double tolerance_m_;
  int stand_offs_;
  std::vector<double> slants_deg_, leans_deg_;
  double way_m_, way_step_m_;
  std::size_t candidates_;
};

}  // namespace

PRESHAPE_PLUGIN(({"kinematic", "1.0.0", "BSD-3-Clause", "the preshape developers", "Grasps carried out by kinematics"}),
                ({"simulator/kinematic"}),
                preshape::component<Kinematic>("kinematic", "Carries a grasp out joint by joint, by kinematics and collisions (thesis sec. 4.4)"))
