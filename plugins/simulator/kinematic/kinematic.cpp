#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/plugin/entry.h"
#include "trial.h"

namespace {

using namespace preshape;
using namespace preshape::kinematic;
using Status = Simulation::Status;

/// Carries a virtual grasp out by geometry alone (thesis sec. 4.4): no mass, no force, no friction. The hand comes along the
/// approach axis, its thumb against its forefingers. How far behind the contacts it stands, how much it leans and, where it
/// must, how it turns is chosen: of the stances in which every fingertip reaches its contact, and opened the clearance
/// before it, the least strained one whose whole motion is free, that is the open hand's coming and the closing of the
/// fingers, of collisions with the object, the support and the hand itself. The last links of the grasp's fingers may touch
/// the object.
class Kinematic final : public GraspSimulator {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {D::number("tolerance", 1e-4, 1e-6, 0.01, "m", "distance at which a fingertip has reached its place"),
            D::integer("stand_offs", 10, 1, 200, "-", "distances behind the contacts that are tried, up to a finger's length"),
            D::list("slants", {20.0, 45.0, 70.0}, 0.0, 90.0, "deg", "of the last links, from the contact's normal towards the approach axis, that are tried"),
            D::list("leans", {0.0, 15.0, -15.0, 30.0, -30.0}, -90.0, 90.0, "deg", "leans about the transverse axis that are tried, one after another"),
            D::number("turn", 30.0, 0.0, 90.0, "deg", "most that the hand turns about each of its axes where its fingers alone do not reach"),
            D::number("way", 0.1, 0.0, 1.0, "m", "way along its own axis that the open hand must be free to come"),
            D::number("way_step", 0.005, 1e-4, 0.1, "m", "distance of the places in which it is looked at there"),
            D::integer("candidates", 30, 1, 1000, "-", "stances of a lean whose whole motion is looked at, the least strained first")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant", "collision_free"}; }

  explicit Kinematic(const Parameters& p)
      : settings_{p.number("tolerance"), p.number("way"), p.number("way_step")}, stand_offs_(static_cast<int>(p.integer("stand_offs"))),
        slants_(radians(p.numbers("slants"))), leans_(radians(p.numbers("leans"))), turn_(p.number("turn") * std::numbers::pi / 180.0),
        candidates_(static_cast<std::size_t>(p.integer("candidates"))) {}

  Simulation simulate(const SimulationTask& task, std::uint64_t seed, Progress* progress) const override {
    check(task);
    const auto ways = assignments(task, Reach::orientation(task));
    if (ways.empty()) return too_few_fingers(task);
    const Bodies bodies(task);
    std::optional<Simulation> failed;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (progress) progress->advance("hand", static_cast<double>(i) / static_cast<double>(ways.size()), "");
      Simulation simulation = with(task, bodies, ways[i], seed);
      const bool reached = simulation.status == Status::kReached;
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
    simulation.status = Status::kTooFewFingers;
    simulation.reason = thumbs == 0 ? std::string("the hand has no thumb: name one of its fingers so")
                                    : fmt::format("the grasp has {} contacts, a thumb's and at least one forefinger's, and the hand has {} forefinger{}",
                                                  task.contacts.size(), std::ssize(fingers) - thumbs, std::ssize(fingers) - thumbs == 1 ? "" : "s");
    return simulation;
  }

  /// Whether a failure came nearer to success than another: something in the open hand's way is less than something where
  /// it closes, that less than contacts that only the object's inside leads to, and that less than contacts out of reach.
  bool nearer(const Simulation& a, const Simulation& b) const {
    const auto rank = [this](const Simulation& s) {
      return s.status != Status::kCollision ? 3 : s.collisions.empty() ? 2 : s.way_m < settings_.way_m ? 0 : 1;
    };
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.contact_error_m < b.contact_error_m;
  }

  /// One assignment of fingers, lean after lean: a lean is taken only where less of it does not do.
  Simulation with(const SimulationTask& task, const Bodies& bodies, const Assignment& assignment, std::uint64_t seed) const {
    Reach reach(task, assignment, settings_.tolerance_m, turn_, seed);
    const IdleFingers idle(task, bodies, assignment, seed);
    const Trial trial(task, bodies, idle, settings_);
    std::optional<Simulation> best;
    for (const int starts : {1, 6}) {  // most is found where the stance before ended; drawn starts are for what is not
      reach.set_starts(starts);
      for (const double lean : leans_) {
        Simulation simulation = leaning(trial, reach, lean);
        const bool reached = simulation.status == Status::kReached;
        if (!best || reached || nearer(simulation, *best)) best = std::move(simulation);
        if (reached) return std::move(*best);
      }
      if (best->status == Status::kCollision) break;
    }
    return std::move(*best);
  }

  Simulation leaning(const Trial& trial, Reach& reach, double lean) const {
    std::vector<Hold> all = holds(reach, lean);
    Simulation best = trial.of(all.front());
    for (std::size_t i = 1; i < std::min(all.size(), candidates_) && best.status != Status::kReached; ++i) {
      if (!all[i].reaches(settings_.tolerance_m)) break;
      Simulation next = trial.of(all[i]);
      if (next.status == Status::kReached || nearer(next, best)) best = std::move(next);
    }
    return best;
  }

  /// The holds of a lean: those that reach before those that do not, from the outside first, not turned before turned,
  /// the least strained first.
  std::vector<Hold> holds(Reach& reach, double lean) const {
    std::vector<Hold> all;
    for (const double slant : slants_) {
      for (int i = 0; i < stand_offs_; ++i) {
        const double share = stand_offs_ == 1 ? 0.6 : 0.15 + 0.85 * i / (stand_offs_ - 1.0);
        all.push_back(reach.hold({share * reach.length_m(), lean, slant}));
      }
    }
    const auto misses = [&](const Hold& hold) { return hold.reaches(settings_.tolerance_m) ? 0.0 : std::max(hold.error_m, hold.open_error_m); };
    std::stable_sort(all.begin(), all.end(), [&](const Hold& a, const Hold& b) {
      if (misses(a) != misses(b)) return misses(a) < misses(b);
      if (a.from_outside() != b.from_outside()) return a.from_outside();
      return a.turned != b.turned ? b.turned : a.strain < b.strain;
    });
    return all;
  }

  static std::vector<double> radians(std::vector<double> degrees) {
    for (double& angle : degrees) angle *= std::numbers::pi / 180.0;
    return degrees;
  }

  TrialSettings settings_;
  int stand_offs_;
  std::vector<double> slants_, leans_;  ///< [rad]
  double turn_;                         ///< [rad]
  std::size_t candidates_;
};

}  // namespace

PRESHAPE_PLUGIN(({"kinematic", "1.0.0", "BSD-3-Clause", "the preshape developers", "Grasps carried out by kinematics"}),
                ({"simulator/kinematic"}),
                preshape::component<Kinematic>("kinematic", "Carries a grasp out joint by joint, by kinematics and collisions (thesis sec. 4.4)"))
