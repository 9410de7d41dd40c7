#pragma once

#include <limits>
#include <optional>
#include <string>

#include "assignment.h"
#include "preshape/base/random.h"
#include "preshape/hand/inverse_kinematics.h"

namespace preshape::kinematic {

/// The hand in one place, holding the object and opened before it.
struct Hold {
  Assignment assignment;
  Pose X_TH, X_OH;            ///< of the hand: among the task's axes, see Reach, and where that is
  Posture open, grasp;
  bool turned = false;        ///< the hand left its stance in all its ways, not only sideways
  double error_m = std::numeric_limits<double>::infinity();  ///< largest distance of a fingertip from its contact
  double open_error_m = 0.0;  ///< what an open fingertip lacks of the clearance before its contact
  double strain = 0.0;        ///< how uneasy the grasp's posture is, see strain_of
  std::vector<int> from_inside;  ///< fingers whose last links do not come to their contacts from the object's outside
  std::vector<int> at_limit;

  bool from_outside() const { return from_inside.empty(); }
  bool reached(double tolerance_m) const { return error_m <= tolerance_m; }
  bool reaches(double tolerance_m) const { return reached(tolerance_m) && open_error_m <= tolerance_m; }
};

/// Where the hand may stand: how far behind the contacts, and how much it leans.
struct Stance {
  double stand_off_m = 0.0;  ///< of H behind the middle of the contacts along the approach axis
  double lean = 0.0;         ///< about the transverse axis [rad]
  double slant = 0.0;        ///< of the last links from the contacts' normals towards the approach axis [rad]
};

/// Solves the hand's fingers for a task, one stance after another. Each solution starts where the one before ended.
/// Everything is done in the task's own frame T, of its axes (+Z the approach, +Y from the thumb to the forefingers) in the
/// middle of its contacts, and to a nanometre, so that the same scene in another place gives the same hold.
class Reach {
 public:
  /// @param tolerance_m of a fingertip's distance from its place
  /// @param turn most that the hand turns about each of its axes where its fingers alone do not reach [rad]
  Reach(const SimulationTask& task, Assignment assignment, double tolerance_m, double turn, std::uint64_t seed);

  /// The hold of one stance: the hand centred on its contacts, then shifted sideways and, where that does not do, moved
  /// and turned in all its ways until the fingertips reach.
  Hold hold(const Stance& stance);
  /// Starts of every inverse kinematics from now on: the first where the one before ended, the others drawn.
  void set_starts(int starts) { starts_ = starts; }
  /// How far a stretched finger of the assignment reaches at most [m].
  double length_m() const { return length_m_; }

  /// Orientation R_OT of the task's frame, and of a hand that neither leans nor turns.
  static Eigen::Matrix3d orientation(const SimulationTask& task);

 private:
  std::vector<FingertipTarget> targets(const Pose& X_TH, double slant, double apart_m) const;
  void close(Hold& hold, double slant);
  void open(Hold& hold, double slant);
  double lacking_clearance_m(const Hold& hold) const;
  Pose centred(const Stance& stance) const;
  double strain_of(const Hold& hold) const;
  std::vector<int> from_inside(const Hold& hold) const;

  const SimulationTask& task_;
  Assignment assignment_;
  double tolerance_m_, turn_;
  Random random_;
  Pose X_OT_;
  Eigen::Vector3d opposition_T_;
  std::vector<Eigen::Vector3d> p_TC_, n_T_;  ///< the contacts
  Posture last_;
  double length_m_ = 0.0;
  int starts_ = 1;
};

}  // namespace preshape::kinematic
