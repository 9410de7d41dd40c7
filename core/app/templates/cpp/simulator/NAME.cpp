#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/grasp/simulator.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

constexpr double kLargestStep = 0.1;  ///< [rad or m] of a joint, from one posture of the path to the next

/// A finger that shall reach a contact.
struct Reach {
  int finger;
  Eigen::Vector3d target_O;  ///< [m]
};

/// Moves the hand's fingertips to the contacts, by geometry alone. The hand comes along the approach axis with its
/// thumb against its forefingers; fingertips are brought to their contacts by damped least squares [Wampler1986] within
/// the joints' limits, for the open hand to points in front of the contacts, and the hand's base by the mean of what is
/// left, in turns. Between the two postures every joint moves evenly. No mass, no force, no friction.
class @CLASS@ final : public GraspSimulator {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("tolerance", 1e-4, 1e-6, 0.01, "m", "distance at which a fingertip has reached its contact"),
            ParameterDeclaration::integer("rounds", 100, 1, 10000, "rounds", "most turns of fingers and base"),
            ParameterDeclaration::number("damping", 0.005, 1e-6, 1.0, "m", "of the least squares, as a length")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "frame_covariant"}; }

  explicit @CLASS@(const Parameters& p)
      : tolerance_(p.number("tolerance")), rounds_(p.integer("rounds")), damping_(p.number("damping")) {}

  Simulation simulate(const SimulationTask& task, std::uint64_t, Progress* progress) const override {
    check(task);
    Simulation result;
    std::vector<Reach> reaches;
    if (!assign(task, reaches, result.reason)) {
      result.status = Simulation::Status::kTooFewFingers;
      return result;
    }
    std::vector<Reach> open_reaches = reaches;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      open_reaches[i].target_O -= task.clearance_m * task.contacts[i].n;  // n points into the object
    }
    std::vector<double> grasp = middle_posture(task.hand), open = grasp;
    result.X_OH = first_base(task, reaches, grasp);
    if (progress) progress->advance("reaching", 0.0, "");
    settle(task.hand, reaches, open_reaches, result.X_OH, grasp, open);
    result.contact_error_m = error_of(task.hand, reaches, result.X_OH, grasp);
    const double open_error_m = error_of(task.hand, open_reaches, result.X_OH, open);
    result.path = path_between(open, grasp);
    judge(task, open_error_m, result);
    if (progress) progress->advance("reaching", 1.0, "");
    return result;
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
      throw InputError("clearance_m: expected a finite length of at least 0, got " + std::to_string(task.clearance_m));
    }
  }

  /// Which finger of the hand goes to which contact.
  static bool assign(const SimulationTask& task, std::vector<Reach>& reaches, std::string& reason) {
    const auto fingers = task.hand.fingers();
    for (std::size_t i = 0; i < task.contacts.size(); ++i) {
      const auto role = task.fingers[i];
      const auto found = std::find_if(fingers.begin(), fingers.end(), [&](const Finger& f) { return f.role == role; });
      const int index = static_cast<int>(found - fingers.begin());
      const bool taken = std::any_of(reaches.begin(), reaches.end(), [&](const Reach& r) { return r.finger == index; });
      if (found == fingers.end() || taken) {
        reason = "the hand has no finger left for contact " + std::to_string(i) + "; it has " + std::to_string(fingers.size());
        return false;
      }
      reaches.push_back({index, task.contacts[i].p_OC});
    }
    if (reaches.size() < 2) reason = "a grasp has at least two contacts, got " + std::to_string(reaches.size());
    return reaches.size() >= 2;
  }

  static std::vector<double> middle_posture(const HandModel& hand) {
    std::vector<double> q;
    for (const Joint& joint : hand.joints()) q.push_back(0.5 * (joint.lower + joint.upper));
    return q;
  }

  static std::span<double> joints_of(const Finger& finger, std::vector<double>& q) {
    return std::span(q).subspan(static_cast<std::size_t>(finger.first_joint), static_cast<std::size_t>(finger.joint_count));
  }

  static std::vector<Pose> poses_of(const HandModel& hand, int index, std::vector<double>& q) {
    const Finger& finger = hand.fingers()[static_cast<std::size_t>(index)];
    std::vector<Pose> poses_H(static_cast<std::size_t>(finger.joint_count) + 2);
    hand.forward(index, joints_of(finger, q), poses_H);
    return poses_H;
  }

  /// Right-handed axes along a and, as nearly as can be, along o.
  static Eigen::Matrix3d axes(const Eigen::Vector3d& a, const Eigen::Vector3d& o) {
    Eigen::Matrix3d R;
    R.col(0) = a.normalized();
    R.col(1) = (o - o.dot(R.col(0)) * R.col(0)).normalized();
    R.col(2) = R.col(0).cross(R.col(1));
    return R;
  }

  /// The hand such that its fingertips surround the contacts: the way from the forefingers to the thumb along the
  /// opposition axis, the way from the finger bases to the tips along the approach axis.
  static Pose first_base(const SimulationTask& task, const std::vector<Reach>& reaches, std::vector<double>& q) {
    const auto count = static_cast<double>(reaches.size());
    Eigen::Vector3d tips = Eigen::Vector3d::Zero(), bases = tips, others = tips, targets_O = tips;
    Eigen::Vector3d thumb = tips;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
      const auto poses_H = poses_of(task.hand, reaches[i].finger, q);
      tips += poses_H.back().p / count;
      bases += poses_H.front().p / count;
      if (i == 0) thumb = poses_H.front().p;
      else others += poses_H.front().p / (count - 1.0);
      targets_O += reaches[i].target_O / count;
    }
    Pose X_OH;
    const Eigen::Vector3d push = (thumb - others).normalized();
    Eigen::Vector3d ahead = (tips - bases) - (tips - bases).dot(push) * push;
    if (ahead.norm() < 1e-9) ahead = push.unitOrthogonal();
    X_OH.R = axes(task.approach_O, task.opposition_O) * axes(ahead, push).transpose();
    X_OH.p = targets_O - X_OH.R * tips;
    return X_OH;
  }

  /// One step of damped least squares for every finger. The joint that would leave its limits most stops there, and
  /// the others share what is left.
  void bend(const HandModel& hand, const std::vector<Reach>& reaches, const Pose& X_OH, std::vector<double>& q) const {
    for (const Reach& reach : reaches) {
      const Finger& finger = hand.fingers()[static_cast<std::size_t>(reach.finger)];
      const auto joints = joints_of(finger, q);
      Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, finger.joint_count);
      hand.jacobian(reach.finger, joints, jacobian);
      Eigen::Matrix<double, 3, Eigen::Dynamic> J = jacobian.topRows<3>();
      Eigen::Vector3d e_H = X_OH.inverse() * reach.target_O - poses_of(hand, reach.finger, q).back().p;
      for (;;) {
        const Eigen::Matrix3d damped = J * J.transpose() + damping_ * damping_ * Eigen::Matrix3d::Identity();
        const Eigen::VectorXd dq = J.transpose() * damped.ldlt().solve(e_H);
        std::size_t worst = 0;
        double excess = 0.0, stop = 0.0;
        for (std::size_t j = 0; j < joints.size(); ++j) {
          const Joint& limits = hand.joints()[static_cast<std::size_t>(finger.first_joint) + j];
          const double wanted = joints[j] + dq[static_cast<Eigen::Index>(j)];
          const double kept = std::clamp(wanted, limits.lower, limits.upper);
          if (!J.col(static_cast<Eigen::Index>(j)).isZero(0.0) && std::abs(wanted - kept) > excess) {
            worst = j, excess = std::abs(wanted - kept), stop = kept;
          }
        }
        if (excess == 0.0) {
          for (std::size_t j = 0; j < joints.size(); ++j) joints[j] += dq[static_cast<Eigen::Index>(j)];
          break;
        }
        const auto column = static_cast<Eigen::Index>(worst);
        e_H -= J.col(column) * (stop - joints[worst]);
        J.col(column).setZero();
        joints[worst] = stop;
      }
    }
  }

  /// The mean of the ways that are left to the fingertips.
  static Eigen::Vector3d way_left(const HandModel& hand, const std::vector<Reach>& reaches, const Pose& X_OH, std::vector<double>& q) {
    Eigen::Vector3d left_O = Eigen::Vector3d::Zero();
    for (const Reach& r : reaches) left_O += r.target_O - X_OH * poses_of(hand, r.finger, q).back().p;
    return left_O / static_cast<double>(reaches.size());
  }

  /// Fingers of the grasp, of the open hand, and the base that both share, in turns, until the fingertips are there or
  /// nothing gets better.
  void settle(const HandModel& hand, const std::vector<Reach>& reaches, const std::vector<Reach>& open_reaches, Pose& X_OH,
              std::vector<double>& grasp, std::vector<double>& open) const {
    double before = std::numeric_limits<double>::infinity();
    for (std::int64_t round = 0; round < rounds_; ++round) {
      bend(hand, reaches, X_OH, grasp);
      bend(hand, open_reaches, X_OH, open);
      const double error = std::max(error_of(hand, reaches, X_OH, grasp), error_of(hand, open_reaches, X_OH, open));
      if (error < 1e-3 * tolerance_ || std::abs(before - error) < 1e-6 * error) return;
      before = error;
      X_OH.p += 0.5 * (way_left(hand, reaches, X_OH, grasp) + way_left(hand, open_reaches, X_OH, open));
    }
  }

  /// Postures from one to the other, all joints moving evenly.
  static std::vector<std::vector<double>> path_between(const std::vector<double>& open, const std::vector<double>& grasp) {
    double farthest = 0.0;
    for (std::size_t j = 0; j < open.size(); ++j) farthest = std::max(farthest, std::abs(grasp[j] - open[j]));
    const int steps = std::max(1, static_cast<int>(std::ceil(farthest / kLargestStep)));
    std::vector<std::vector<double>> path;
    for (int step = 0; step <= steps; ++step) {
      path.push_back(open);
      for (std::size_t j = 0; j < open.size(); ++j) path.back()[j] = std::lerp(open[j], grasp[j], static_cast<double>(step) / steps);
    }
    return path;
  }

  static double error_of(const HandModel& hand, const std::vector<Reach>& reaches, const Pose& X_OH, std::vector<double>& q) {
    double largest = 0.0;
    for (const Reach& r : reaches) {
      largest = std::max(largest, (r.target_O - X_OH * poses_of(hand, r.finger, q).back().p).norm());
    }
    return largest;
  }

  void judge(const SimulationTask& task, double open_error_m, Simulation& result) const {
    if (!(result.contact_error_m <= tolerance_)) {
      result.status = Simulation::Status::kUnreachable;
      result.reason = "a fingertip stays " + std::to_string(1e3 * result.contact_error_m) + " mm from its contact";
      return;
    }
    if (!(open_error_m <= tolerance_)) {
      result.status = Simulation::Status::kUnreachable;
      result.reason = "the hand does not open wide enough: a fingertip stays " + std::to_string(1e3 * open_error_m) +
                      " mm from its place in front of its contact";
      return;
    }
    for (std::size_t step = 0; step < result.path.size(); ++step) {
      if (!touches(task, result.X_OH, result.path[step])) continue;
      result.status = Simulation::Status::kCollision;
      result.reason = "the palm or a link touches the object in posture " + std::to_string(step) + " of the path";
      return;
    }
    result.status = Simulation::Status::kReached;
  }

  /// Whether anything of the hand but the last links touches the object's surface.
  static bool touches(const SimulationTask& task, const Pose& X_OH, std::vector<double> q) {
    std::vector<PosedSolid> solids_O;
    for (const LinkSolid& solid : task.hand.solids()) {
      Pose X_HL;
      if (solid.finger >= 0) {
        const Finger& finger = task.hand.fingers()[static_cast<std::size_t>(solid.finger)];
        if (solid.link == finger.joint_count) continue;
        X_HL = poses_of(task.hand, solid.finger, q)[static_cast<std::size_t>(solid.link)];
      }
      solids_O.push_back({solid.solid, X_OH * X_HL * solid.X_LS});
    }
    std::vector<double> distances(solids_O.size());
    task.object_O.distance(solids_O, distances);
    return std::any_of(distances.begin(), distances.end(), [](double d) { return d <= 0.0; });
  }

  double tolerance_;
  std::int64_t rounds_;
  double damping_;
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Fingertips to contacts by geometry"}),
                ({"simulator/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Reaches the contacts by damped least squares"))
