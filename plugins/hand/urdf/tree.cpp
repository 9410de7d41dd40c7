#include "tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

namespace preshape::urdf_hand {

namespace {

template <typename Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : map) keys.push_back(key);
  return keys;
}

Pose moved(const urdf::Joint& joint, const Eigen::Vector3d& axis, double value) {
  if (joint.type == urdf::Joint::PRISMATIC) return {Eigen::Matrix3d::Identity(), value * axis};
  return {Eigen::AngleAxisd(value, axis).toRotationMatrix(), Eigen::Vector3d::Zero()};
}

bool turns_or_slides(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS ||
         joint.type == urdf::Joint::PRISMATIC;
}

}  // namespace

std::optional<std::vector<urdf::JointConstSharedPtr>> path_between(const Document& document,
                                                                   const std::string& from,
                                                                   const std::string& to) {
  std::vector<urdf::JointConstSharedPtr> path;
  std::string link = to;
  while (link != from) {
    const auto joint = document.model->getLink(link)->parent_joint;
    // A circle of links that hangs on nothing never comes to the base.
    if (!joint || path.size() > document.model->joints_.size()) return std::nullopt;
    path.push_back(joint);
    link = joint->parent_link_name;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<std::string> link_names(const urdf::ModelInterface& model) {
  return keys_of(model.links_);
}
std::vector<std::string> joint_names(const urdf::ModelInterface& model) {
  return keys_of(model.joints_);
}

Pose pose_of(const Document& document, const std::string& element, const urdf::Pose& pose) {
  double x = 0, y = 0, z = 0, w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  const Pose X{Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix(),
               {pose.position.x, pose.position.y, pose.position.z}};
  if (!X.R.allFinite() || !X.p.allFinite())
    refuse(document.file, fmt::format("{}: <origin> must have finite numbers", element));
  return X;
}

Pose origin_of(const Document& document, const urdf::Joint& joint) {
  return pose_of(document, fmt::format("joint '{}'", joint.name), joint.parent_to_joint_origin_transform);
}

Eigen::Vector3d axis_of(const Document& document, const urdf::Joint& joint) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (!axis.allFinite() || axis.norm() < 1e-9) {
    refuse(document.file, fmt::format("joint '{}': <axis> must have a direction, got '{} {} {}'", joint.name,
                                      axis.x(), axis.y(), axis.z()));
  }
  return axis.normalized();
}

std::optional<Motion> motion_of(const Document& document, const urdf::Joint& joint) {
  if (joint.type == urdf::Joint::FIXED || (joint.mimic && joint.mimic->multiplier == 0.0))
    return std::nullopt;
  if (!turns_or_slides(joint)) {
    refuse(document.file,
           fmt::format("joint '{}' is {}: a finger's joint turns about an axis or slides along it",
                       joint.name, joint.type == urdf::Joint::PLANAR ? "planar" : "floating"));
  }
  Motion motion{joint.type == urdf::Joint::PRISMATIC, -std::numbers::pi, std::numbers::pi,
                std::numeric_limits<double>::quiet_NaN()};
  if (joint.limits && joint.limits->effort > 0.0 && std::isfinite(joint.limits->effort))
    motion.torque = joint.limits->effort;
  if (joint.type == urdf::Joint::CONTINUOUS) return motion;
  if (!joint.limits || !std::isfinite(joint.limits->lower) || !std::isfinite(joint.limits->upper) ||
      joint.limits->lower > joint.limits->upper) {
    refuse(document.file,
           fmt::format(
               "joint '{}': <limit> must have finite lower <= upper{}", joint.name,
               joint.limits ? fmt::format(", got {} and {}", joint.limits->lower, joint.limits->upper) : ""));
  }
  motion.lower = joint.limits->lower;
  motion.upper = joint.limits->upper;
  if (motion.lower == motion.upper) return std::nullopt;
  return motion;
}

Pose pose_at_rest(const Document& document, const urdf::Joint& joint) {
  const Pose X_PJ = origin_of(document, joint);
  if (!turns_or_slides(joint)) return X_PJ;
  double value = joint.mimic && joint.mimic->multiplier == 0.0 ? joint.mimic->offset : 0.0;
  if (joint.limits && joint.type != urdf::Joint::CONTINUOUS && joint.limits->lower <= joint.limits->upper) {
    value = std::clamp(value, joint.limits->lower, joint.limits->upper);
  }
  return X_PJ * moved(joint, axis_of(document, joint), value);
}

}  // namespace preshape::urdf_hand
