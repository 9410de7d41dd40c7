#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document.h"
#include "preshape/spatial/pose.h"

namespace preshape::urdf_hand {

/// The joints from a link down to another one.
/// @returns nothing when the second is not beyond the first
std::optional<std::vector<urdf::JointConstSharedPtr>> path_between(const Document& document,
                                                                   const std::string& from,
                                                                   const std::string& to);

std::vector<std::string> link_names(const urdf::ModelInterface& model);
std::vector<std::string> joint_names(const urdf::ModelInterface& model);

/// @throws InputError when a number of it is not finite; `element` is what it belongs to: "joint 'x'"
Pose pose_of(const Document& document, const std::string& element, const urdf::Pose& pose);

/// Of the joint's frame in its parent link.
Pose origin_of(const Document& document, const urdf::Joint& joint);
/// Unit vector in the joint's frame.
Eigen::Vector3d axis_of(const Document& document, const urdf::Joint& joint);

/// Whether a joint moves, and what it may do.
struct Motion {
  bool prismatic = false;
  double lower = 0.0, upper = 0.0;  ///< [rad or m]
  double torque = 0.0;              ///< [N m or N]; NaN when the URDF says 0 or nothing
};
/// Nothing for one that is fixed, may do a single value only, or follows another by a multiplier of 0.
/// @throws InputError on a joint that is planar or floating, or whose limits are upside down
std::optional<Motion> motion_of(const Document& document, const urdf::Joint& joint);

/// The pose of a joint's child in its parent where the joint has no motion, or stands at its value next to 0.
Pose pose_at_rest(const Document& document, const urdf::Joint& joint);

}  // namespace preshape::urdf_hand
