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
      : hand_(hand), targets_(targets), drives_(drives), posture_(std::move(posture)),
        error_(3 * static_cast<Eigen::Index>(targets.size())), J_(error_.size(), drives.count()) {
    cut();
    error_ = errors(posture_);
  }

  void run(const InverseKinematicsSettings& settings) {
    double damping = 1e-3;
    for (int i = 0; i < settings.iterations && residual() > 0.01 * settings.tolerance_m && damping < 1e8; ++i) {
      jacobian();
      const Posture next = stepped(damping);
      const Eigen::VectorXd after = errors(next);
      if (after.squaredNorm() < error_.squaredNorm()) {
        posture_ = next, error_ = after;
        damping = std::max(1e-12, damping / 10);
      } else {
        damping *= 10;
      }
    }
  }

  double residual() const {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < error_.size(); i += 3) largest = std::max(largest, error_.segment<3>(i).norm());
    return largest;
  }
  const Posture& posture() const { return posture_; }

 private:
  double& value(Posture& posture, int drive) const { return posture[static_cast<std::size_t>(drives_.joint(drive))]; }

  void cut() {
    for (int d = 0; d < drives_.count(); ++d) {
      const DriveRange& range = drives_.range(d);
      value(posture_, d) = std::clamp(value(posture_, d), range.lower, range.upper);
    }
    apply_couplings(hand_, posture_);
  }

  Eigen::VectorXd errors(const Posture& posture) const {
    Eigen::VectorXd error(3 * static_cast<Eigen::Index>(targets_.size()));
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      error.segment<3>(3 * static_cast<Eigen::Index>(i)) =
          targets_[i].p_HD - finger_poses(hand_, targets_[i].finger, posture).back().p;
    }
    return error;
  }

  /// Of all fingertips with respect to the drives.
  void jacobian() {
    J_.setZero();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const Finger& finger = hand_.fingers()[static_cast<std::size_t>(targets_[i].finger)];
      Eigen::Matrix<double, 6, Eigen::Dynamic> own(6, finger.joint_count);
      hand_.jacobian(targets_[i].finger, finger_values(hand_, targets_[i].finger, posture_), own);
      for (int k = 0; k < finger.joint_count; ++k) {
        const int joint = finger.first_joint + k;
        J_.block<3, 1>(3 * static_cast<Eigen::Index>(i), drives_.of(joint)) += drives_.gain(joint) * own.col(k).head<3>();
      }
    }
  }

  /// The posture after a damped step, drives that would leave their ranges stopped at the ends.
  Posture stepped(double damping) const {
    Posture next = posture_;
    Eigen::MatrixXd J = J_;
    Eigen::VectorXd error = error_;
    const double scale = std::max(1e-300, J_.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, J_.cols())));
    for (;;) {
      Eigen::MatrixXd normal = J * J.transpose();
      normal.diagonal().array() += damping * scale + 1e-18 * scale;
      const Eigen::VectorXd step = J.transpose() * normal.ldlt().solve(error);
      int worst = -1;
      double excess = 0.0;
      for (int d = 0; d < drives_.count(); ++d) {
        if (J.col(d).isZero(0.0)) continue;
        const double wanted = value(next, d) + step[d], kept = std::clamp(wanted, drives_.range(d).lower, drives_.range(d).upper);
        if (std::abs(wanted - kept) > excess) worst = d, excess = std::abs(wanted - kept);
      }
      if (worst < 0) {
        for (int d = 0; d < drives_.count(); ++d) value(next, d) += step[d];
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

  double value(const Posture& posture, int drive) const { return posture[static_cast<std::size_t>(drives_.joint(drive))]; }

  const HandModel& hand_;
  std::span<const FingertipTarget> targets_;
  const Drives& drives_;
  Posture posture_;
  Eigen::VectorXd error_;
  Eigen::MatrixXd J_;
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

}  // namespace

InverseKinematicsSolution solve_fingertips(const HandModel& hand, std::span<const FingertipTarget> targets,
                                           std::span<const double> start, const InverseKinematicsSettings& settings,
                                           Random& random) {
  require_size("posture", hand.joints().size(), start.size());
  check_targets(hand, targets);
  const Drives drives(hand, targets);
  InverseKinematicsSolution best;
  best.residual_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::max(1, settings.starts) && !best.reached; ++i) {
    Descent descent(hand, targets, drives, i == 0 ? Posture(start.begin(), start.end()) : drawn(drives, start, random));
    descent.run(settings);
    best.starts = i + 1;
    if (!(descent.residual() < best.residual_m)) continue;
    best.posture = descent.posture();
    best.residual_m = descent.residual();
    best.reached = best.residual_m <= settings.tolerance_m;
  }
  if (best.posture.empty()) best.posture.assign(start.begin(), start.end());
  best.at_limit = joints_at_limit(hand, targets, drives, best.posture);
  return best;
}

}  // namespace preshape
