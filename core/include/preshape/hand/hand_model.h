#pragma once

#include <span>
#include <string>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/geometry/collision.h"
#include "preshape/spatial/pose.h"

namespace preshape {

/// What the analysis needs to know of a hand's size. All [m].
struct HandDimensions {
  double unit_length_m = 0.0;     ///< U: middle phalanx of the middle finger
  double finger_spacing_m = 0.0;  ///< between neighbouring forefingers, U for the thesis's hand
  double maximum_opening_m = 0.0; ///< fingertip to the middle of the grasp, 4U for the thesis's hand
  double base_width_m = 0.0;      ///< 5U for the thesis's hand
};

enum class FingerRole : std::int32_t { kThumb, kIndex, kMiddle, kRing, kLittle };

struct Finger {
  std::string name;
  FingerRole role = FingerRole::kIndex;
  int first_joint = 0;  ///< its joints are first_joint .. first_joint + joint_count - 1, from base to tip
  int joint_count = 0;
};

struct Joint {
  std::string name;
  bool prismatic = false;
  double lower = 0.0, upper = 0.0;  ///< [rad], or [m] when prismatic
  double torque_limit = 0.0;        ///< [N m] or [N]; NaN when unknown
  /// The joint of the hand that moves it by a tendon, a gear or a linkage, so that q = ratio * q[leader] + offset in
  /// every posture that the hand can take; -1: it has a drive of its own. A leader has one.
  int leader = -1;
  double ratio = 0.0;   ///< of the leader's value
  double offset = 0.0;  ///< [rad or m]
};

/// A link's collision geometry: a solid fixed to the frame after `joint` joints of its finger (0 = hand base).
struct LinkSolid {
  int finger = -1;  ///< -1: the palm
  int link = 0;     ///< 0 = base of the finger, k = moved by the finger's first k joints
  Solid solid;
  Pose X_LS;        ///< of the solid in its link frame
};

/// Kind `hand`: kinematic chains from the hand base H to the fingertips Dk. [every call: any thread, const]
class PRESHAPE_API HandModel {
 public:
  virtual ~HandModel();

  virtual const HandDimensions& dimensions() const noexcept = 0;
  virtual std::span<const Finger> fingers() const noexcept = 0;
  virtual std::span<const Joint> joints() const noexcept = 0;
  virtual std::span<const LinkSolid> solids() const noexcept = 0;

  /// Forward kinematics of one finger: X_HL of its base and of each of its links, then X_HD of its tip.
  /// @param q the finger's joint_count joint values [rad or m], base to tip; not checked against limits, and a joint
  /// that follows another is taken as it stands
  /// @param poses_H joint_count + 2 poses: base, after joint 1 .. joint_count, tip
  virtual void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const = 0;

  /// Geometric Jacobian of one fingertip: V_D_H = J qdot, linear rows first.
  /// @param jacobian 6 x joint_count, overwritten
  virtual void jacobian(int finger, std::span<const double> q,
                        Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const = 0;

  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
