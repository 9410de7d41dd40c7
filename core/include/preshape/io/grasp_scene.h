#pragma once

#include <string>
#include <vector>

#include "preshape/grasp/approach_volume.h"
#include "preshape/io/run_record.h"

namespace preshape {

/// A solid of the hand as it is drawn, with where it is in each posture of the motion.
struct SceneLink {
  std::string name;              ///< "palm", "index link 2"; no name twice
  Solid solid;
  std::vector<Pose> X_OS;        ///< one a frame of the motion
  bool collides = false;         ///< the simulation failed because of it
};

/// What a picture of a run shows: plain data, everything in O [m]. Drawn as PNG, written as glTF, shown on the page.
struct GraspScene {
  std::string title;
  TriangleMesh object_O;
  std::vector<SceneLink> links;            ///< empty when there was no simulation
  int frames = 0;                          ///< of the motion: the open hand first, the grasp last; 0: no motion
  std::vector<ContactFrame> contacts;      ///< thumb first; empty when there is no grasp
  std::vector<std::string> fingers;        ///< names, one a contact
  std::vector<Wrench> F_C_O;               ///< pattern wrenches about the contacts, moments over length_m
  Wrench resultant_O;                      ///< about O, moments over length_m
  Eigen::Vector3d approach_O = Eigen::Vector3d::UnitX();    ///< unit: the way the hand comes
  Eigen::Vector3d opposition_O = Eigen::Vector3d::UnitY();  ///< unit: the way the forefingers push
  double approach_m = 0.0;                 ///< of the fingertips along the approach axis, from O
  double length_m = 1.0;                   ///< L
  std::optional<ApproachVolume> approach_volume;  ///< of the open hand
  Eigen::Vector3d way_O = Eigen::Vector3d::Zero();  ///< that the open hand comes to where it closes
  std::string verdict;                     ///< of the run, and of the simulation where there was one
  int shown_try = 1;  ///< 1: the report's result, 2: what the hand carries out in its place
  std::string shown;  ///< which that is, in words; empty where there is but one to show
};

/// What a solid of a hand is called in scenes and reports: "palm", "thumb link 2", "thumb link 2 (2)" where a link has two.
PRESHAPE_API std::string solid_name(const HandModel& hand, int solid);

/// Which grasp of a run is shown, where the hand could not carry out the first but did another.
enum class ShownTry { kCarriedOut, kFirst };

/// The scene of a run's result, with the hand where it was simulated.
PRESHAPE_API GraspScene grasp_scene(const RunRecord& record, ShownTry shown = ShownTry::kCarriedOut);

}  // namespace preshape
