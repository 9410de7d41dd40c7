// What a simulated grasp keeps to: M01 and on.
#include <algorithm>
#include <cmath>

#include "../collision/oracle.h"
#include "preshape/base/error.h"
#include "workshop.h"

namespace preshape::conformance {

namespace {

using Status = Simulation::Status;

constexpr std::uint64_t kSeed = 12345;
constexpr double kTold = 1e-6;       // [m] of lengths that the simulator tells of its own arithmetic
constexpr double kFingertip = 5e-3;  // [m] a tip farther than this from its contact does not touch it

/// The law for jobs of which the suite's hand can do most.
void for_jobs(Context& context, const std::function<std::string(const Bench&, const Simulation&)>& law) {
  const auto simulator = context.create<GraspSimulator>();
  context.for_all(job_blocks(), context.cases(12), [&](Case c) -> std::string {
    const Bench bench(job_of(c));
    return law(bench, simulator->simulate(bench.task(), kSeed, nullptr));
  });
}

void m01_joints(Context& context) {
  for_jobs(context, [](const Bench& bench, const Simulation& s) -> std::string {
    const auto joints = bench.hand().joints();
    for (const auto& posture : s.path) {
      if (posture.size() != joints.size())
        return fmt::format("a posture has {} joints, the hand {}", posture.size(), joints.size());
      for (std::size_t i = 0; i < joints.size(); ++i) {
        if (posture[i] >= joints[i].lower - 1e-9 && posture[i] <= joints[i].upper + 1e-9) continue;
        return fmt::format("joint '{}' is at {}, its limits are {} .. {}", joints[i].name, posture[i],
                           joints[i].lower, joints[i].upper);
      }
    }
    return "";
  });
}

void m02_reaches_truly(Context& context) {
  for_jobs(context, [](const Bench& bench, const Simulation& s) -> std::string {
    if (s.status != Status::kReached) return "";
    if (s.path.empty()) return "it reached the contacts on a path without postures";
    const auto places = tips(bench.task(), s.X_OH, s.path.back());
    double farthest = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i)
      farthest = std::max(farthest, (places[i] - bench.contacts[i].p_OC).norm());
    if (!(std::abs(farthest - s.contact_error_m) <= kTold)) {
      return fmt::format("it tells an error of {} m, by the hand's kinematics it is {} m", s.contact_error_m,
                         farthest);
    }
    return farthest <= kFingertip
               ? ""
               : fmt::format("it says reached with a fingertip {} m off its contact", farthest);
  });
}

Simulation simulated(Context& context, const Bench& bench) {
  return context.create<GraspSimulator>()->simulate(bench.task(), kSeed, nullptr);
}

/// A fourth contact, for a little finger.
void ask_for_one_more(Bench& bench) {
  bench.contacts.push_back(bench.contacts.back());
  bench.contacts.back().p_OC += 0.01 * bench.approach_O;
  bench.fingers.push_back(FingerRole::kLittle);
}

void m03_too_few_fingers(Context& context) {
  Bench bench(Job{});
  ask_for_one_more(bench);
  const Simulation s = simulated(context, bench);
  context.require(s.status == Status::kTooFewFingers,
                  "a hand of three fingers shall make four contacts, and the status is {}, not too few fingers",
                  static_cast<int>(s.status));
}

/// Contacts ten metres apart.
void pull_apart(Bench& bench) {
  bench.contacts[0].p_OC += 10.0 * bench.opposition_O;
}

void m04_unreachable(Context& context) {
  Bench bench(Job{});
  pull_apart(bench);
  const Simulation s = simulated(context, bench);
  context.require(s.status != Status::kReached, "it says reached of contacts ten metres apart");
}

void m05_reasons(Context& context) {
  const auto told = [&](const Simulation& s) {
    context.require(s.status == Status::kReached || !s.reason.empty(),
                    "the status is {}, and no reason is given", static_cast<int>(s.status));
  };
  Bench apart(Job{}), few(Job{});
  pull_apart(apart);
  ask_for_one_more(few);
  told(simulated(context, apart));
  told(simulated(context, few));
  for_jobs(context, [&](const Bench&, const Simulation& s) -> std::string { return told(s), ""; });
}

void m06_rigid_base(Context& context) {
  for_jobs(context, [](const Bench&, const Simulation& s) -> std::string {
    const double off = (s.X_OH.R.transpose() * s.X_OH.R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    const bool rigid = off <= 1e-9 && s.X_OH.R.determinant() > 0.0 && s.X_OH.p.allFinite();
    return rigid ? "" : fmt::format("the hand's base is no rigid pose: R'R is {} off the identity", off);
  });
}

void m07_continuous_path(Context& context) {
  for_jobs(context, [](const Bench& bench, const Simulation& s) -> std::string {
    constexpr double kStep = 0.2;  // [rad] twelve degrees: the next posture is seen to come from this one
    const auto joints = bench.hand().joints();
    for (std::size_t k = 1; k < s.path.size(); ++k) {
      for (std::size_t i = 0; i < std::min({joints.size(), s.path[k].size(), s.path[k - 1].size()}); ++i) {
        const double step = std::abs(s.path[k][i] - s.path[k - 1][i]);
        if (!(step <= kStep))
          return fmt::format("joint '{}' goes by {} rad from posture {} to the next", joints[i].name, step,
                             k - 1);
      }
    }
    return "";
  });
}

void m08_opens_first(Context& context) {
  for_jobs(context, [](const Bench& bench, const Simulation& s) -> std::string {
    if (s.status != Status::kReached || s.path.empty()) return "";
    for (const auto& place : tips(bench.task(), s.X_OH, s.path.front())) {
      const Bounds apart = solid_distance(
          {{Solid::Kind::kSphere, 0, 0, Eigen::Vector3d::Zero()}, {Eigen::Matrix3d::Identity(), place}},
          bench.object());
      if (apart.upper >= bench.job().clearance - 1e-3) continue;
      return fmt::format("the open hand has a fingertip {} m from the object, it was to be {} m", apart.upper,
                         bench.job().clearance);
    }
    return "";
  });
}

void m09_frame_covariant(Context& context) {
  const auto simulator = context.create<GraspSimulator>();
  auto blocks = job_blocks();
  blocks.push_back({"moved by", 3, -2, 2});
  blocks.push_back({"turned by", 1, -3, 3});
  context.for_all(blocks, context.cases(10), [&](Case c) -> std::string {
    const Job here = job_of(c);
    Job there = here;
    const auto n = c.size() - 4;
    const Pose X{Eigen::AngleAxisd(c[n + 3], Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                 {c[n], c[n + 1], c[n + 2]}};
    there.X_OB = X * here.X_OB;
    const Bench first(here), second(there);
    const Simulation a = simulator->simulate(first.task(), kSeed, nullptr),
                     b = simulator->simulate(second.task(), kSeed, nullptr);
    if (a.status != b.status)
      return fmt::format("the status is {}, with everything moved {}", static_cast<int>(a.status),
                         static_cast<int>(b.status));
    if (a.status != Status::kReached) return "";
    const Pose expected = X * a.X_OH;
    const double off =
        std::max((expected.R - b.X_OH.R).cwiseAbs().maxCoeff(), (expected.p - b.X_OH.p).norm());
    if (!(off <= 1e-5))
      return fmt::format("with everything moved the hand's base is {} off where it moved to", off);
    return "";
  });
}

void m10_unit_axes(Context& context) {
  for (const double length : {0.0, 0.9, 1.1, 2.0}) {
    for (const bool approach : {true, false}) {
      Bench bench(Job{});
      (approach ? bench.approach_O : bench.opposition_O) *= length;
      bool refused = false;
      try {
        simulated(context, bench);
      } catch (const InputError&) {
        refused = true;
      }
      context.require(refused, "an {} axis of length {} is taken", approach ? "approach" : "opposition",
                      length);
    }
  }
}

void m11_collision_free(Context& context) {
  for_jobs(context, [](const Bench& bench, const Simulation& s) -> std::string {
    if (s.status != Status::kReached) return "";
    for (std::size_t k = 0; k < s.path.size(); ++k) {
      for (const LinkSolid& solid : bench.hand().solids()) {
        if (solid.finger >= 0 &&
            solid.link == bench.hand().fingers()[static_cast<std::size_t>(solid.finger)].joint_count)
          continue;
        const Pose X_OL = solid.finger < 0 ? s.X_OH
                                           : finger_poses(bench.hand(), solid.finger, s.X_OH,
                                                          s.path[k])[static_cast<std::size_t>(solid.link)];
        if (solid_distance({solid.solid, X_OL * solid.X_LS}, bench.object()).upper > 0.0) continue;
        return fmt::format("in posture {} of {} link {} of finger {} is in the object", k, s.path.size(),
                           solid.link, solid.finger);
      }
    }
    return "";
  });
}

void m12_reaches_an_easy_grasp(Context& context) {
  const Bench bench(Job{});
  const Simulation s = simulated(context, bench);
  context.require(s.status == Status::kReached,
                  "a box of 6 x 4 x 6 cm in front of three fingers of 10 cm is not reached: {}", s.reason);
}

/// Notes what is wrong with what it is told.
class Listener final : public Progress {
 public:
  void advance(std::string_view stage, double fraction, std::string_view) override {
    if (stage.empty()) wrong = "a stage without a name";
    if (!(fraction <= 1.0)) wrong = fmt::format("the fraction {}", fraction);
  }
  std::string wrong;
};

void m13_tells_its_progress(Context& context) {
  const Bench bench(Job{});
  Listener listener;
  context.create<GraspSimulator>()->simulate(bench.task(), kSeed, &listener);
  context.require(listener.wrong.empty(), "it told its progress {}", listener.wrong);
}

constexpr Check kChecks[] = {
    {"M01", "simulator", "every posture of the path has all joints, within their limits", m01_joints},
    {"M02", "simulator",
     "reached: the last posture brings the fingertips to the contacts, as near as is told",
     m02_reaches_truly},
    {"M03", "simulator", "more contacts than the hand has fingers are too few fingers", m03_too_few_fingers},
    {"M04", "simulator", "contacts ten metres apart are not reached", m04_unreachable},
    {"M05", "simulator", "unless it reached it gives a reason", m05_reasons},
    {"M06", "simulator", "the hand's base is a rigid pose", m06_rigid_base},
    {"M07", "simulator", "no joint goes by more than twelve degrees from one posture to the next",
     m07_continuous_path},
    {"M08", "simulator", "the path begins with the fingertips the clearance away from the object",
     m08_opens_first},
    {"M09", "simulator", "declared frame_covariant: moving object and contacts moves the hand with them",
     m09_frame_covariant, "frame_covariant"},
    {"M10", "simulator", "an axis that is not of unit length is refused", m10_unit_axes},
    {"M11", "simulator",
     "declared collision_free: on a path that reached no link but the last is in the object",
     m11_collision_free, "collision_free"},
    {"M12", "simulator", "an easy grasp is reached", m12_reaches_an_easy_grasp},
    {"M13", "simulator", "the progress that it tells is a named stage and a share of one",
     m13_tells_its_progress},
};

}  // namespace

std::span<const Check> simulator_checks() {
  return kChecks;
}

}  // namespace preshape::conformance
