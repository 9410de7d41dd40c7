#pragma once

#include "preshape/geometry/collision.h"

namespace preshape {

// Distances to a filled box that is centred on its frame, with all points given in it.

double distance_box_segment(const Eigen::Vector3d& half_extents, const Eigen::Vector3d& p,
                            const Eigen::Vector3d& q);
double distance_box_triangle(const Eigen::Vector3d& half_extents, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b, const Eigen::Vector3d& c);
/// @param X_AB pose of the second box in the frame of the first
double distance_boxes(const Eigen::Vector3d& half_a, const Eigen::Vector3d& half_b, const Pose& X_AB);

}  // namespace preshape
