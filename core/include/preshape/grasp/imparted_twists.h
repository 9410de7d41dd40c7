#pragma once

#include <span>
#include <vector>

#include "preshape/contact/contact_model.h"
#include "preshape/grasp/joint_action.h"
#include "preshape/grasp/task.h"

namespace preshape {

/// What motions a hand can give an object that it holds, all contacts kept [MurrayLiSastry1994, sec. 5.5]: with B_i the unit
/// wrenches of contact i, the object's twist V and the joints' rates agree in every direction that a contact transmits,
///   B_i' V_Ci = B_i' sum_k J_k qdot_k.
struct ImpartedTwists {
  std::vector<Twist> twists_O;  ///< basis of the object's twists about O [over L, and 1], orthonormal as six-vectors
  int internal_motions = 0;     ///< independent motions of the joints that leave the object where it is
};

/// @param joints as joint_actions gives them; joints that follow another are not free: give `groups`
/// @param groups for each joint action the drive that makes it, and how much of it: rates of one drive are one
/// @param length_m characteristic length that makes linear and angular parts alike
struct DriveShare {
  int drive = 0;
  double gain = 1.0;
};
PRESHAPE_API ImpartedTwists imparted_twists(const ContactModel& model, std::span<const ContactFrame> contacts,
                                            std::span<const JointAction> joints, std::span<const DriveShare> groups,
                                            double length_m);

/// How much of a task's motion is among them, 0 .. 1: the length of its screw's projection on their space over its own; 1 for
/// a task that asks for nothing.
PRESHAPE_API double share_of(const ImpartedTwists& imparted, const Task& task);

/// The drive of every joint action, in the order of joint_actions: @param fingers as there.
PRESHAPE_API std::vector<DriveShare> drive_shares(const HandModel& hand, std::span<const int> fingers);

}  // namespace preshape
