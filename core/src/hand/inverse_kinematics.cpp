#include "preshape/hand/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/require.h"

namespace preshape {

namespace {

constexpr double kAtLimit = 1e-9;  // share of a drive's range

/// Most equations and drives of fingers that are solved together: sizes that need no heap.
constexpr int kMost = 60;
using Equations = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
using Steps = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;

/// The drives that move some fingers, and how far each may go.
class Drives {
 public:
  Drives(const HandModel& hand, std::span<const FingertipTarget> targets) : hand_(hand), place_(hand.joints().size(), -1) {
    for (const auto& target : targets) {
      const Finger& finger = hand.fingers()[static_cast<std::size_t>(target.finger)];
      for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j) add(j);
    }
  }

  int count() const { return static_cast<int>(joints_.size()); }
  int joint(int drive) const { return joints_[static_cast<std::size_t>(drive)]; }
  const DriveRange& range(int drive) const { return ranges_[static_cast<std::size_t>(drive)]; }
  /// The drive that moves a joint, and how much it does.
  int of(int joint) const { return place_[static_cast<std::size_t>(leader(joint))]; }
  double gain(int joint) const {
    const Joint& about = hand_.joints()[static_cast<std::size_t>(joint)];
    return about.leader < 0 ? 1.0 : about.ratio;
  }

 private:
  int leader(int joint) const {
    const int leader = hand_.joints()[static_cast<std::size_t>(joint)].leader;
    return leader < 0 ? joint : leader;
  }
  void add(int joint) {
    auto& place = place_[static_cast<std::size_t>(leader(joint))];
    if (place >= 0) return;
    place = count();
    joints_.push_back(leader(joint));
    ranges_.push_back(drive_range(hand_, leader(joint)));
  }

  const HandModel& hand_;
  std::vector<int> place_, joints_;  ///< drive of each leader; leader of each drive
  std::vector<DriveRange> ranges_;
};

/// One descent from one start.
class Descent {
 public:
  Descent(const HandModel& hand, std::span<const FingertipTarget> targets, const Drives& drives, Posture posture)
      : hand_(hand), targets_(targets), drives_(drives), posture_(std::move(posture)) {
    for (int d = 0; d < drives_.count(); ++d) {
      const DriveRange& range = drives_.range(d);
      value(posture_, d) = std::clamp(value(posture_, d), range.lower, range.upper);
    }
    apply_couplings(hand_, posture_);
  }

  /// First with the wished directions, where there are any, then for the places alone.
  void run(const InverseKinematicsSettings& settings) {
    const bool wishes = std::any_of(targets_.begin(), targets_.end(), [](const auto& t) { return t.pointing_weight_m > 0.0; });
    if (wishes) descend(settings, true);
    descend(settings, false);
  }

  double residual() const {
    double largest = 0.0;
    for (const auto& target : targets_) {
      largest = std::max(largest, (target.p_HD - finger_poses(hand_, target.finger, posture_).back().p).norm());
    }
    return largest;
  }
  const Posture& posture() const { return posture_; }

 private:
  void descend(const InverseKinematicsSettings& settings, bool wishes) {
    constexpr double kStalled = 1e-6;  // least share of the squared error that a step must take away
    const double enough = std::pow(0.01 * settings.tolerance_m, 2);
    double damping = 1e-3;
    Equations error = errors(posture_, wishes);
    int stalls = 0;
    for (int i = 0; i < settings.iterations && error.squaredNorm() > enough && damping < 1e8 && stalls < 3; ++i) {
      const Posture next = stepped(jacobian(wishes), error, damping);
      const Equations after = errors(next, wishes);
      const double gain = error.squaredNorm() - after.squaredNorm();
      if (gain > 0.0) {
        stalls = gain < kStalled * error.squaredNorm() ? stalls + 1 : 0;
        posture_ = next, error = after;
        damping = std::max(1e-12, damping / 10);
      } else {
        damping *= 10;
      }
    }
  }

  double& value(Posture& posture, int drive) const { return posture[static_cast<std::size_t>(drives_.joint(drive))]; }
  double value(const Posture& posture, int drive) const { return posture[static_cast<std::size_t>(drives_.joint(drive))]; }

  Equations errors(const Posture& posture, bool wishes) const {
    const Eigen::Index each = wishes ? 6 : 3;
    Equations error(each * std::ssize(targets_));
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const FingertipTarget& target = targets_[i];
      const auto row = each * static_cast<Eigen::Index>(i);
      error.segment<3>(row) = target.p_HD - finger_poses(hand_, target.finger, posture).back().p;
      if (wishes) error.segment<3>(row + 3) = target.pointing_weight_m * (target.pointing_H - pointing_of(hand_, target.finger, posture));
    }
    return error;
  }

  /// Of all fingertips, and of their directions, with respect to the drives.
  Sensitivity jacobian(bool wishes) const {
    const Eigen::Index each = wishes ? 6 : 3;
    Sensitivity J = Sensitivity::Zero(each * std::ssize(targets_), drives_.count());
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const FingertipTarget& target = targets_[i];
      const Finger& finger = hand_.fingers()[static_cast<std::size_t>(target.finger)];
      Eigen::Matrix<double, 6, Eigen::Dynamic> own(6, finger.joint_count);
      hand_.jacobian(target.finger, finger_values(hand_, target.finger, posture_), own);
      const Eigen::Vector3d direction = wishes ? pointing_of(hand_, target.finger, posture_) : Eigen::Vector3d::Zero();
      const auto row = each * static_cast<Eigen::Index>(i);
      for (int k = 0; k < finger.joint_count; ++k) {
        const int joint = finger.first_joint + k;
        auto column = J.col(drives_.of(joint));
        column.segment<3>(row) += drives_.gain(joint) * own.col(k).head<3>();
        if (wishes) column.segment<3>(row + 3) += target.pointing_weight_m * drives_.gain(joint) * Eigen::Vector3d(own.col(k).tail<3>()).cross(direction);
      }
    }
    return J;
  }

  /// The posture after a damped step, drives that would leave their ranges stopped at the ends.
  Posture stepped(Sensitivity J, Equations error, double damping) const {
    Posture next = posture_;
    const double scale = std::max(1e-300, J.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, J.cols())));
    for (;;) {
      Sensitivity normal = J.lazyProduct(J.transpose());
      normal.diagonal().array() += damping * scale + 1e-18 * scale;
      const Equations weights = normal.llt().solve(error);
      const Steps step = J.transpose().lazyProduct(weights);
      int worst = -1;
      double excess = 0.0;
      for (int d = 0; d < drives_.count(); ++d) {
        if (J.col(d).isZero(0.0)) continue;
        const double wanted = value(next, d) + step[d], kept = std::clamp(wanted, drives_.range(d).lower, drives_.range(d).upper);
        if (std::abs(wanted - kept) > excess) worst = d, excess = std::abs(wanted - kept);
      }
      if (worst < 0) {
        for (int d = 0; d < drives_.count(); ++d) {
          if (!J.col(d).isZero(0.0)) value(next, d) += step[d];
        }
        break;
      }
      const DriveRange& range = drives_.range(worst);
      const double stop = step[worst] > 0.0 ? range.upper : range.lower;
      error -= J.col(worst) * (stop - value(next, worst));
      value(next, worst) = stop;
      J.col(worst).setZero();
    }
    apply_couplings(hand_, next);
    return next;
  }

  const HandModel& hand_;
  std::span<const FingertipTarget> targets_;
  const Drives& drives_;
  Posture posture_;
};

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

/// A start of its own for every try: the drives anywhere in their ranges.
Posture drawn(const Drives& drives, std::span<const double> start, Random& random) {
  Posture posture(start.begin(), start.end());
  for (int d = 0; d < drives.count(); ++d) {
    posture[static_cast<std::size_t>(drives.joint(d))] = random.uniform(drives.range(d).lower, drives.range(d).upper);
  }
  return posture;
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

/// The targets in groups that share no drive: each can be solved alone.
std::vector<std::vector<FingertipTarget>> independent(const HandModel& hand, std::span<const FingertipTarget> targets) {
  std::vector<std::vector<FingertipTarget>> groups;
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

/// Solves one group and leaves its drives in the solution's posture.
void solve_group(const HandModel& hand, std::span<const FingertipTarget> targets, const InverseKinematicsSettings& settings,
                 Random& random, InverseKinematicsSolution& solution) {
  const Drives drives(hand, targets);
  const Posture start = solution.posture;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::max(1, settings.starts) && !(least <= settings.tolerance_m); ++i) {
    Descent descent(hand, targets, drives, i == 0 ? start : drawn(drives, start, random));
    descent.run(settings);
    solution.starts = std::max(solution.starts, i + 1);
    if (!(descent.residual() < least)) continue;
    least = descent.residual();
    solution.posture = descent.posture();
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
  InverseKinematicsSolution solution;
  solution.posture.assign(start.begin(), start.end());
  for (const auto& group : independent(hand, targets)) {
    if (6 * std::ssize(group) > kMost || Drives(hand, group).count() > kMost) {
      throw InputError(fmt::format("{} fingers share their drives; at most {} equations and drives are solved together", group.size(), kMost));
    }
    solve_group(hand, group, settings, random, solution);
  }
  solution.reached = solution.residual_m <= settings.tolerance_m;
  std::sort(solution.at_limit.begin(), solution.at_limit.end());
  return solution;
}

}  // namespace preshape
