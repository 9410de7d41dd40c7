#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/base/progress.h"
#include "preshape/contact/contact_frame.h"
#include "preshape/hand/hand_model.h"

namespace preshape {

/// What the object stands on: the half space normal . p <= height, of which nothing of the hand may be in.
struct SupportPlane {
  Eigen::Vector3d normal_O = Eigen::Vector3d::UnitZ();  ///< unit, out of the support
  double height_m = 0.0;                                ///< of its surface along the normal, from O
};

/// A virtual grasp that a hand shall carry out; not owning, everything in O.
struct SimulationTask {
  const HandModel& hand;
  const CollisionBackend& collision;        ///< for the hand's solids against one another
  const CollisionScene& object_O;           ///< the object's surface
  std::span<const ContactFrame> contacts;   ///< where the fingertips shall be, thumb first
  std::span<const FingerRole> fingers;      ///< which finger goes to which contact; size of `contacts`
  Eigen::Vector3d approach_O;               ///< unit: the way the hand comes
  Eigen::Vector3d opposition_O;             ///< unit: the way the forefingers push
  double clearance_m = 0.0;                 ///< of the open fingertips from the object, >= 0
  const SupportPlane* support = nullptr;    ///< none: the object hangs in the air
};

/// How one finger of a simulation fared.
struct FingerOutcome {
  int finger = -1;            ///< of the hand; -1: none was free for the contact
  bool reached = false;
  double error_m = 0.0;       ///< of the fingertip from its contact, at the end
  std::vector<int> at_limit;  ///< its joints that end at a limit, as indices into HandModel::joints()
};

/// Two bodies that a simulation found in one place.
struct Collision {
  static constexpr int kObject = -1, kSupport = -2;
  int solid = 0;        ///< of the hand, index into HandModel::solids()
  int other = kObject;  ///< the object, the support, or another solid of the hand
  int posture = 0;      ///< index into Simulation::path
};

/// How carrying it out ended: an outcome, also when it failed.
struct Simulation {
  enum class Status : std::int32_t { kReached, kUnreachable, kCollision, kTooFewFingers };
  Status status = Status::kUnreachable;
  std::string reason;                     ///< unless reached: one sentence
  Pose X_OH;                              ///< hand base
  /// Postures from the open preshape to the grasp; each has all joints in the order of HandModel::joints()
  /// [rad or m]. Empty when there is nothing to show.
  std::vector<std::vector<double>> path;
  double contact_error_m = 0.0;           ///< largest distance of a fingertip from its contact at the end
  std::vector<FingerOutcome> fingers;     ///< one a contact, or none where the simulator does not tell
  std::vector<Collision> collisions;      ///< those that made it fail
  double way_m = 0.0;                     ///< that the open hand was found free to come along its own +Z, X_OH.R.col(2)
};

/// Kind `simulator`: carries a virtual grasp out with a hand (thesis sec. 4.4). [any thread, const]
class PRESHAPE_API GraspSimulator {
 public:
  virtual ~GraspSimulator();
  /// @param seed of whatever randomness it uses; @param progress may be null
  /// @throws InputError when contacts and fingers differ in number or an axis is not of unit length (1e-6)
  virtual Simulation simulate(const SimulationTask& task, std::uint64_t seed, Progress* progress) const = 0;
  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
