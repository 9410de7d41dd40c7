#include "preshape/hand/inverse_kinematics.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "descent.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/hand/planar_finger.h"

namespace preshape {

namespace {

constexpr double kAtLimit = 1e-9;  // share of a drive's range

void check_targets(const HandModel& hand, std::span<const FingertipTarget> targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const int finger = targets[i].finger, count = static_cast<int>(hand.fingers().size());
    if (finger < 0 || finger >= count) throw InputError(fmt::format("the hand has fingers 0 .. {}, got {}", count - 1, finger));
    if (!targets[i].p_HD.allFinite()) {
      throw InputError(fmt::format("the target of finger '{}' must be three finite numbers", hand.fingers()[static_cast<std::size_t>(finger)].name));
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (targets[k].finger == finger) {
        throw InputError(fmt::format("finger '{}' has two targets", hand.fingers()[static_cast<std::size_t>(finger)].name));
      }
    }
  }
}

void check_freedom(const HandFreedom& freedom) {
  for (const auto& ways : {freedom.translation_m, freedom.turn}) {
    if (!ways.allFinite() || ways.minCoeff() < 0.0) throw InputError("the hand's freedom to move must be finite and not negative");
  }
}

/// A start of its own for every try: the joints' drives anywhere in their ranges, the hand where it is.
Configuration drawn(const Drives& drives, const Posture& start, Random& random) {
  Configuration configuration{start};
  for (int d = 0; d < drives.joint_drives(); ++d) {
    drives.value(configuration, d) = random.uniform(drives.range(d).lower, drives.range(d).upper);
  }
  return configuration;
}

std::vector<int> joints_at_limit(const HandModel& hand, std::span<const FingertipTarget> targets, const Drives& drives,
                                 const Posture& posture) {
  std::vector<int> stopped;
  for (const auto& target : targets) {
    const Finger& finger = hand.fingers()[static_cast<std::size_t>(target.finger)];
    for (int joint = finger.first_joint; joint < finger.first_joint + finger.joint_count; ++joint) {
      const int drive = drives.of(joint);
      const DriveRange& range = drives.range(drive);
      const double q = posture[static_cast<std::size_t>(drives.joint(drive))], slack = kAtLimit * (range.upper - range.lower);
      if (q <= range.lower + slack || q >= range.upper - slack) stopped.push_back(joint);
    }
  }
  return stopped;
}

/// The targets in groups that share no drive: each can be solved alone. A hand that moves takes all fingers along.
std::vector<std::vector<FingertipTarget>> independent(const HandModel& hand, std::span<const FingertipTarget> targets, bool moves) {
  std::vector<std::vector<FingertipTarget>> groups;
  if (moves) return {{targets.begin(), targets.end()}};
  for (const auto& target : targets) {
    std::vector<FingertipTarget> merged = {target};
    std::vector<std::vector<FingertipTarget>> others;
    for (auto& group : groups) {
      const Drives mine(hand, {&target, 1});
      bool shared = false;
      for (const auto& member : group) {
        const Drives theirs(hand, {&member, 1});
        for (int d = 0; d < mine.count(); ++d) {
          for (int e = 0; e < theirs.count(); ++e) shared = shared || mine.joint(d) == theirs.joint(e);
        }
      }
      if (shared) merged.insert(merged.begin(), group.begin(), group.end());
      else others.push_back(std::move(group));
    }
    others.push_back(std::move(merged));
    groups = std::move(others);
  }
  return groups;
}

/// The posture nearest to the solution's, of a finger that has a closed form; nothing where it has none within the limits.
std::optional<Posture> in_closed_form(const HandModel& hand, std::span<const FingertipTarget> targets, const InverseKinematicsSettings& settings,
                                      const Posture& start) {
  const FingertipTarget& target = targets.front();
  if (!settings.closed_form || targets.size() > 1 || target.pointing_weight_m > 0.0) return std::nullopt;
  if (Drives(hand, {}, settings.freedom).move_the_hand()) return std::nullopt;
  const auto planar = PlanarFinger::recognise(hand, target.finger);
  if (!planar) return std::nullopt;
  const auto from = start.begin() + hand.fingers()[static_cast<std::size_t>(target.finger)].first_joint;
  PlanarFinger::Values preferred;
  std::copy_n(from, preferred.size(), preferred.begin());
  const auto values = planar->solve_within_limits(target.p_HD, preferred);
  if (!values) return std::nullopt;
  Posture posture = start;
  std::copy(values->begin(), values->end(), posture.begin() + (from - start.begin()));
  apply_couplings(hand, posture);
  if (!within_limits(hand, posture)) return std::nullopt;  // of a joint that follows
  return posture;
}

/// Solves one group and leaves its drives in the solution's posture.
void solve_group(const HandModel& hand, std::span<const FingertipTarget> targets, const InverseKinematicsSettings& settings,
                 Random& random, InverseKinematicsSolution& solution) {
  const Drives drives(hand, targets, settings.freedom);
  const Posture start = solution.posture;
  double least = std::numeric_limits<double>::infinity();
  if (auto closed = in_closed_form(hand, targets, settings, start)) {
    solution.posture = std::move(*closed);
    least = (targets.front().p_HD - finger_poses(hand, targets.front().finger, solution.posture).back().p).norm();
  }
  for (int i = 0; i < std::max(1, settings.starts) && !(least <= settings.tolerance_m); ++i) {
    Descent descent(hand, targets, drives, i == 0 ? Configuration{start} : drawn(drives, start, random));
    descent.run(settings);
    solution.starts = std::max(solution.starts, i + 1);
    if (!(descent.residual() < least)) continue;
    least = descent.residual();
    solution.posture = descent.configuration().posture;
    solution.X_HM = Standing(hand, descent.configuration().moved).X_HM;
  }
  solution.residual_m = std::max(solution.residual_m, least);
  const auto stopped = joints_at_limit(hand, targets, drives, solution.posture);
  solution.at_limit.insert(solution.at_limit.end(), stopped.begin(), stopped.end());
}

}  // namespace

Eigen::Vector3d pointing_of(const HandModel& hand, int finger, std::span<const double> posture) {
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  if (about.joint_count == 0) return Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, about.joint_count);
  hand.jacobian(finger, finger_values(hand, finger, posture), J);
  const Eigen::Matrix<double, 6, 1> last = J.rightCols<1>();
  const Eigen::Vector3d from_axis = last.head<3>().cross(last.tail<3>());  // column (z x r; z), r at right angles to z
  return from_axis.norm() > 1e-9 ? Eigen::Vector3d(from_axis.normalized()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

InverseKinematicsSolution solve_fingertips(const HandModel& hand, std::span<const FingertipTarget> targets,
                                           std::span<const double> start, const InverseKinematicsSettings& settings,
                                           Random& random) {
  require_size("posture", hand.joints().size(), start.size());
  check_targets(hand, targets);
  check_freedom(settings.freedom);
  InverseKinematicsSolution solution;
  solution.posture.assign(start.begin(), start.end());
  const bool moves = Drives(hand, {}, settings.freedom).move_the_hand();
  for (const auto& group : independent(hand, targets, moves)) {
    if (6 * std::ssize(group) > Descent::kMost || Drives(hand, group, settings.freedom).count() > Descent::kMost) {
      throw InputError(fmt::format("{} fingers share their drives; at most {} equations and drives are solved together", group.size(), Descent::kMost));
    }
    solve_group(hand, group, settings, random, solution);
  }
  solution.reached = solution.residual_m <= settings.tolerance_m;
  std::sort(solution.at_limit.begin(), solution.at_limit.end());
  return solution;
}

}  // namespace preshape
