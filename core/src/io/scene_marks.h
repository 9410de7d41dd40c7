#pragma once

#include "preshape/io/grasp_scene.h"

namespace preshape {

/// A frame at a point whose z axis is the direction, which is of any length but zero.
Pose pose_along(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

/// A round bar from one point to another, in their frame.
TriangleMesh bar_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);

/// Bars from corner to corner and back to the first.
TriangleMesh outline_mesh(const std::vector<Eigen::Vector3d>& corners, double radius);

/// How far beside O, along the transverse axis, the thumb and the forefingers taken as one stand in the
/// middle [m].
/// @param scene with contacts
Eigen::Vector3d middle_beside_O(const GraspScene& scene);

/// "thumb link 2, palm": the links that were found in collision; of many the first three, and how many more.
std::string colliding_links(const GraspScene& scene);

}  // namespace preshape
