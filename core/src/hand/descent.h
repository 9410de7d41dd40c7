#pragma once

#include "drives.h"

namespace preshape {

/// One descent of damped least squares from one start. Not owning.
class Descent {
 public:
  /// Most equations and drives of fingers that are solved together: sizes that need no heap.
  static constexpr int kMost = 60;

  /// @param start its drives are cut to their ranges
  Descent(const HandModel& hand, std::span<const FingertipTarget> targets, const Drives& drives, Configuration start);

  /// First with the wished directions, where there are any, then for the places alone.
  void run(const InverseKinematicsSettings& settings);

  /// Largest distance of a fingertip from its target [m].
  double residual() const;
  const Configuration& configuration() const { return at_; }

 private:
  using Equations = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
  using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;

  void descend(const InverseKinematicsSettings& settings, bool wishes);
  Equations errors(const Configuration& at, bool wishes) const;
  Sensitivity jacobian(bool wishes) const;
  void add_hand_columns(Eigen::Index row, const FingertipTarget& target, const Standing& standing, bool wishes, Sensitivity& J) const;
  Configuration stepped(Sensitivity J, Equations error, double damping) const;

  const HandModel& hand_;
  std::span<const FingertipTarget> targets_;
  const Drives& drives_;
  Configuration at_;
};

}  // namespace preshape
