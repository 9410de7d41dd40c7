// Simulators that are broken on purpose: each fails the check that its name begins with, and nothing else.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/grasp/simulator.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;
using Vector = Eigen::Vector3d;
using Status = Simulation::Status;

enum class Fault {
  kNone,
  kOverstretches,
  kTellsZero,
  kMisnames,
  kOptimist,
  kSilent,
  kStretches,
  kTwoPostures,
  kHalfOpen,
  kKnowsNorth,
  kAnyAxis,
  kGoesThrough,
  kNeverReaches,
  kTellsPercent,
};

constexpr double kNear = 1e-4;  // [m] as near as a fingertip shall come
constexpr int kPostures = 30;

/// A hand's base and joints, and which finger goes where.
struct Reaching {
  const HandModel& hand;
  std::vector<int> fingers;
  Pose X_OH;
  std::vector<double> q;  ///< of all joints

  std::span<const double> joints_of(int finger) const {
    const Finger& f = hand.fingers()[static_cast<std::size_t>(finger)];
    return std::span(q).subspan(static_cast<std::size_t>(f.first_joint),
                                static_cast<std::size_t>(f.joint_count));
  }

  Vector tip_H(int finger) const {
    const auto own = joints_of(finger);
    std::vector<Pose> poses(own.size() + 2);
    hand.forward(finger, own, poses);
    return poses.back().p;
  }

  double error(const std::vector<Vector>& goals) const {
    double farthest = 0.0;
    for (std::size_t i = 0; i < goals.size(); ++i)
      farthest = std::max(farthest, (X_OH * tip_H(fingers[i]) - goals[i]).norm());
    return farthest;
  }

  /// Damped least squares over the joints, and over the base when it may move; joints stay in their limits.
  void solve(const std::vector<Vector>& goals, bool base_moves) {
    constexpr int kSteps = 60;
    constexpr double kDamping = 1e-5;  // [m^2] of the square of a centimetre's step
    for (int step = 0; step < kSteps && error(goals) > 1e-9; ++step) {
      const auto rows = static_cast<Eigen::Index>(3 * goals.size()),
                 columns = static_cast<Eigen::Index>(6 + q.size());
      Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, columns);
      Eigen::VectorXd off(rows);
      for (std::size_t i = 0; i < goals.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        const Vector arm = X_OH.R * tip_H(fingers[i]);
        off.segment<3>(row) = goals[i] - X_OH.p - arm;
        if (base_moves) J.block<3, 3>(row, 0).setIdentity(), J.block<3, 3>(row, 3) = across(-arm);
        const auto own = joints_of(fingers[i]);
        Eigen::Matrix<double, 6, Eigen::Dynamic> finger(6, static_cast<Eigen::Index>(own.size()));
        hand.jacobian(fingers[i], own, finger);
        const int first = hand.fingers()[static_cast<std::size_t>(fingers[i])].first_joint;
        J.block(row, 6 + first, 3, finger.cols()) = X_OH.R * finger.topRows<3>();
      }
      const Eigen::MatrixXd damped = J * J.transpose() + kDamping * Eigen::MatrixXd::Identity(rows, rows);
      take(J.transpose() * damped.ldlt().solve(off));
    }
  }

 private:
  static Eigen::Matrix3d across(const Vector& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
  }

  void take(const Eigen::VectorXd& step) {
    X_OH.p += step.head<3>();
    const Vector turn = step.segment<3>(3);
    if (turn.norm() > 0.0)
      X_OH.R =
          Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized()) * Eigen::Quaterniond(X_OH.R))
              .normalized()
              .toRotationMatrix();
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] = std::clamp(q[i] + step[static_cast<Eigen::Index>(6 + i)], hand.joints()[i].lower,
                        hand.joints()[i].upper);
    }
  }
};

/// Places the hand before the object, reaches for the contacts, opens by the clearance, and closes again in
/// small steps; and breaks one rule.
template <Fault fault>
class Kinematic final : public GraspSimulator {
 public:
  static std::vector<std::string> capabilities() {
    if constexpr (fault == Fault::kNone) return {"frame_covariant", "collision_free"};
    if constexpr (fault == Fault::kKnowsNorth) return {"frame_covariant"};
    if constexpr (fault == Fault::kGoesThrough) return {"collision_free"};
    return {};
  }
  explicit Kinematic(const Parameters&) {}

  Simulation simulate(const SimulationTask& task, std::uint64_t, Progress* progress) const override {
    require_size("fingers", task.contacts.size(), task.fingers.size());
    check_axis("approach", task.approach_O), check_axis("opposition", task.opposition_O);
    Reaching reaching{task.hand, {}, {}, middle(task.hand)};
    for (const FingerRole role : task.fingers) reaching.fingers.push_back(finger_with(task.hand, role));
    if (std::count(reaching.fingers.begin(), reaching.fingers.end(), -1) > 0) {
      return failed(fault == Fault::kMisnames ? Status::kUnreachable : Status::kTooFewFingers,
                    "the hand lacks a finger");
    }
    place(reaching, task);
    if (progress) progress->advance("reaching", fault == Fault::kTellsPercent ? 50.0 : 0.5, "");
    return carried_out(reaching, task);
  }

 private:
  static Simulation failed(Status status, std::string reason) {
    Simulation simulation;
    simulation.status = status;
    if (fault != Fault::kSilent) simulation.reason = std::move(reason);
    return simulation;
  }

  static void check_axis(const char* name, const Vector& axis) {
    const bool unit = std::abs(axis.norm() - 1.0) <= 1e-6;
    if (!unit && fault != Fault::kAnyAxis)
      throw InputError(fmt::format("the {} axis has the length {}; give a unit vector", name, axis.norm()));
  }

  static std::vector<double> middle(const HandModel& hand) {
    std::vector<double> q;
    for (const Joint& joint : hand.joints()) q.push_back(0.5 * (joint.lower + joint.upper));
    return q;
  }

  static int finger_with(const HandModel& hand, FingerRole role) {
    for (int f = 0; f < std::ssize(hand.fingers()); ++f) {
      if (hand.fingers()[static_cast<std::size_t>(f)].role == role) return f;
    }
    return -1;
  }

  /// z of the hand along the approach, its forefingers on the side that they push from, tips about the
  /// contacts.
  static void place(Reaching& reaching, const SimulationTask& task) {
    const Vector z = task.approach_O.normalized(),
                 y = (-task.opposition_O + z * z.dot(task.opposition_O)).normalized();
    reaching.X_OH.R << y.cross(z), y, z;
    Vector contacts = Vector::Zero(), tips = Vector::Zero();
    for (const ContactFrame& contact : task.contacts) contacts += contact.p_OC;
    for (const int finger : reaching.fingers) tips += reaching.tip_H(finger);
    const double count = static_cast<double>(task.contacts.size());
    reaching.X_OH.p = contacts / count - reaching.X_OH.R * tips / count;
    if (fault == Fault::kKnowsNorth) reaching.X_OH.p.x() += 0.01;
  }

  static Simulation carried_out(Reaching& reaching, const SimulationTask& task) {
    std::vector<Vector> goals, open_goals;
    for (const ContactFrame& contact : task.contacts) {
      goals.push_back(contact.p_OC);
      open_goals.push_back(contact.p_OC -
                           (fault == Fault::kHalfOpen ? 0.5 : 1.0) * task.clearance_m * contact.n);
    }
    reaching.solve(goals, true);
    Simulation simulation;
    simulation.X_OH = reaching.X_OH;
    simulation.contact_error_m = reaching.error(goals);
    const std::vector<double> closed = reaching.q;
    reaching.solve(open_goals, false);
    const bool opens = reaching.error(open_goals) <= kNear;
    if (fault == Fault::kNeverReaches) return failed(Status::kUnreachable, "it does not try");
    if ((!opens || simulation.contact_error_m > kNear) && fault != Fault::kOptimist) {
      return failed(Status::kUnreachable,
                    fmt::format("the fingertips stay {} m away", simulation.contact_error_m));
    }
    simulation.status = Status::kReached;
    simulation.path = path(reaching.q, closed);
    if (fault == Fault::kTellsZero) simulation.contact_error_m = -0.001;
    if (fault == Fault::kStretches) simulation.X_OH.R *= 1.0000001;
    if (fault == Fault::kOverstretches &&
        task.fingers.size() < task.hand.fingers().size()) {  // in an idle finger
      for (auto& posture : simulation.path) posture.back() = task.hand.joints().back().upper + 0.1;
    }
    const bool crosses = fault != Fault::kGoesThrough && crosses_object(reaching, simulation, task);
    return crosses ? failed(Status::kCollision, "a link meets the object") : simulation;
  }

  static std::vector<std::vector<double>> path(const std::vector<double>& open,
                                               const std::vector<double>& closed) {
    std::vector<std::vector<double>> postures;
    const int steps = fault == Fault::kTwoPostures ? 1 : kPostures;
    for (int k = 0; k <= steps; ++k) {
      postures.push_back(open);
      const double share = static_cast<double>(k) / steps;
      for (std::size_t i = 0; i < open.size(); ++i) postures.back()[i] += share * (closed[i] - open[i]);
    }
    return postures;
  }

  /// Whether a link other than a finger's last meets the object's surface in any posture.
  static bool crosses_object(Reaching& reaching, const Simulation& simulation, const SimulationTask& task) {
    for (const auto& posture : simulation.path) {
      reaching.q = posture;
      for (const LinkSolid& solid : task.hand.solids()) {
        Pose X_HL;
        if (solid.finger >= 0) {
          const auto own = reaching.joints_of(solid.finger);
          if (solid.link == std::ssize(own)) continue;
          std::vector<Pose> poses(own.size() + 2);
          task.hand.forward(solid.finger, own, poses);
          X_HL = poses[static_cast<std::size_t>(solid.link)];
        }
        const PosedSolid posed{solid.solid, simulation.X_OH * X_HL * solid.X_LS};
        double distance = 0.0;
        task.object_O.distance({&posed, 1}, {&distance, 1});
        if (distance <= 0.0) return true;
      }
    }
    return false;
  }
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"zoo_simulator", "1.0.0", "BSD-3-Clause", "the preshape developers", "Broken simulators"}),
    ({"simulator/good", "simulator/m01_overstretches", "simulator/m02_tells_zero", "simulator/m03_misnames",
      "simulator/m04_optimist", "simulator/m05_silent", "simulator/m06_stretches",
      "simulator/m07_two_postures", "simulator/m08_half_open", "simulator/m09_knows_north",
      "simulator/m10_any_axis", "simulator/m11_goes_through", "simulator/m12_never_reaches",
      "simulator/m13_tells_percent"}),
    component<Kinematic<Fault::kNone>>("good", "Reaches by damped least squares"),
    component<Kinematic<Fault::kOverstretches>>("m01_overstretches", "Has a joint beyond its limit"),
    component<Kinematic<Fault::kTellsZero>>("m02_tells_zero", "Tells an error that is none"),
    component<Kinematic<Fault::kMisnames>>("m03_misnames", "Calls a missing finger unreachable"),
    component<Kinematic<Fault::kOptimist>>("m04_optimist", "Always says reached"),
    component<Kinematic<Fault::kSilent>>("m05_silent", "Gives no reasons"),
    component<Kinematic<Fault::kStretches>>("m06_stretches", "Has a base that stretches"),
    component<Kinematic<Fault::kTwoPostures>>("m07_two_postures", "Jumps from open to closed"),
    component<Kinematic<Fault::kHalfOpen>>("m08_half_open", "Opens by half of the clearance"),
    component<Kinematic<Fault::kKnowsNorth>>("m09_knows_north", "Places the hand by the axes of O"),
    component<Kinematic<Fault::kAnyAxis>>("m10_any_axis", "Takes axes of any length"),
    component<Kinematic<Fault::kGoesThrough>>("m11_goes_through", "Does not look where its links are"),
    component<Kinematic<Fault::kNeverReaches>>("m12_never_reaches", "Does not try"),
    component<Kinematic<Fault::kTellsPercent>>("m13_tells_percent", "Tells its progress in percent"))
