#pragma once

#include <span>
#include <vector>

#include "preshape/hand/hand_model.h"
#include "preshape/spatial/twist.h"

namespace preshape {

/// What one joint of a hand does at a contact. The torque that a contact wrench puts on the joint is the reciprocal
/// product of the two: tau = F_C . V_C, the hand Jacobian's transpose row by row [MurrayLiSastry1994, ch. 5].
struct JointAction {
  int contact = 0;     ///< index of the contact that the joint's finger makes
  Twist V_C_O;         ///< of the fingertip about the contact per unit of joint rate: [m/rad or 1], [1 or 0]
  double limit = 0.0;  ///< most torque [N m], or force [N] when prismatic; NaN when unknown
};

/// The actions of all joints whose fingers touch, finger by finger in the order of the contacts.
/// @param fingers index of the hand's finger at each contact
/// @param q a posture of all joints, in the order of HandModel::joints() [rad or m]; @param X_OH hand base
/// @throws InputError when the posture has another number of joints
PRESHAPE_API std::vector<JointAction> joint_actions(const HandModel& hand, std::span<const int> fingers,
                                                    std::span<const double> q, const Pose& X_OH);

}  // namespace preshape
