#pragma once

#include <span>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/hand/posture.h"

namespace preshape {

/// Where a fingertip shall be, and perhaps how it shall point.
struct FingertipTarget {
  int finger = 0;
  Eigen::Vector3d p_HD = Eigen::Vector3d::Zero();       ///< [m]
  Eigen::Vector3d pointing_H = Eigen::Vector3d::Zero(); ///< unit: from the last joint's axis to the tip
  double pointing_weight_m = 0.0;                       ///< what a radian beside it counts as; 0: any direction does
};

/// The direction in H from a finger's last joint to its tip; zero where that joint slides or the tip lies on its axis.
PRESHAPE_API Eigen::Vector3d pointing_of(const HandModel& hand, int finger, std::span<const double> posture);

/// How far the hand itself may move while its fingers reach, to either side of where it starts: along the axes of H, and
/// by turns about its x, then its y, then its z axis. Zero: it stays.
struct HandFreedom {
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();  ///< >= 0
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();           ///< [rad], >= 0
};

struct InverseKinematicsSettings {
  double tolerance_m = 1e-7;  ///< distance of a fingertip from its target that counts as reached
  int iterations = 100;       ///< most steps from one start
  int starts = 12;            ///< the one given, then drawn ones
  HandFreedom freedom = {};   ///< of the hand's base
  bool closed_form = true;    ///< for fingers that have one (PlanarFinger), where the hand stays and no direction is wished
};

struct InverseKinematicsSolution {
  Posture posture;           ///< of the whole hand, within its limits; joints of no target are as they were
  double residual_m = 0.0;   ///< largest distance of a fingertip from its target
  bool reached = false;
  int starts = 0;            ///< that were needed, the most of any fingers; 0: all were solved in closed form
  std::vector<int> at_limit; ///< joints of the targets' fingers that are at a limit of theirs or of their drive
  Pose X_HM;                 ///< where the hand moved to: its frame then, in H; the identity unless it was free to
};

/// A posture whose fingertips are at their targets: in closed form where a finger has one, else by damped least squares
/// [Wampler1986] over the drives of all fingers that share one, so that joints that follow another, also across fingers,
/// move with it; the damping follows the progress [Marquardt1963]; a drive that a step would take beyond its range stops there and the others share what is left.
/// Several starts, the first one `start`; the best is returned when none arrives. A wished direction leads the way and
/// then gives way: the last steps are for the fingertips' places alone. A hand that is free to move goes along by the least
/// that does, where U counts as much as a radian of a joint.
/// @param start where to begin, of the whole hand; its drives are cut to their ranges
/// @param random of the starts that are drawn
/// @throws InputError on a finger that there is not, a finger named twice, a target that is not finite, or a freedom
/// that is negative or not finite
PRESHAPE_API InverseKinematicsSolution solve_fingertips(const HandModel& hand, std::span<const FingertipTarget> targets,
                                                        std::span<const double> start,
                                                        const InverseKinematicsSettings& settings, Random& random);

}  // namespace preshape
