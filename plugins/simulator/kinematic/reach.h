#pragma once

#include <optional>
#include <string>

#include "assignment.h"
#include "preshape/base/random.h"
#include "preshape/hand/inverse_kinematics.h"

namespace preshape::kinematic {

/// The hand in one place, holding the object and opened before it.
struct Hold {
  Assignment assignment;
  Pose X_OH;
  Posture open, grasp;
  double error_m = 0.0;       ///< largest distance of a fingertip from its contact
  double open_error_m = 0.0;  ///< of an open fingertip from its place before the contact
  double strain = 0.0;        ///< how uneasy the grasp's posture is, see strain_of
  bool from_outside = true;   ///< every last link comes to its contact from the object's outside
  std::vector<int> at_limit;

  bool reaches(double tolerance_m) const { return error_m <= tolerance_m && open_error_m <= tolerance_m; }
};

/// Where the hand may stand: how far behind the contacts, and how much it leans.
struct Stance {
  double stand_off_m = 0.0;  ///< of H behind the middle of the contacts along the approach axis
  double lean = 0.0;         ///< about the transverse axis [rad]
  double slant = 0.0;        ///< of the last links from the contacts' normals towards the approach axis [rad]
};

/// Solves the hand's fingers for a task, one stance after another. Each solution starts where the one before ended.
class Reach {
 public:
  /// @param tolerance_m of a fingertip's distance from its place
  Reach(const SimulationTask& task, Assignment assignment, double tolerance_m, std::uint64_t seed);

  /// The hold of one stance: the hand centred on its contacts, then shifted by what the fingertips lack.
  Hold hold(const Stance& stance);
  /// Starts of every inverse kinematics from now on: the first where the one before ended, the others drawn.
  void set_starts(int starts) { starts_ = starts; }
  /// How far a stretched finger of the assignment reaches at most [m].
  double length_m() const { return length_m_; }

  /// Orientation of H whose axes are those of the task, leaning: +Z along the approach, +Y from the thumb to the
  /// forefingers.
  static Eigen::Matrix3d orientation(const SimulationTask& task, double lean);

 private:
  std::vector<FingertipTarget> targets(const Pose& X_OH, double slant, double apart_m) const;
  Posture posture(const std::vector<FingertipTarget>& targets, const Posture& start, int starts, double& error_m,
                  std::vector<int>* at_limit);
  void put_aside(int finger);
  Pose centred(const Stance& stance) const;
  double strain_of(const Hold& hold) const;
  bool comes_from_outside(const Hold& hold) const;

  const SimulationTask& task_;
  Assignment assignment_;
  double tolerance_m_;
  Random random_;
  Posture last_;
  double length_m_ = 0.0;
  int starts_ = 1;
};

}  // namespace preshape::kinematic
