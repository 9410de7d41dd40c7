#pragma once

#include "preshape/geometry/collision.h"

namespace preshape {

// Distances [length of the arguments] between closed convex bodies, 0 where they touch or cross. Exact up to
// rounding: closed forms for points, segments and triangles [Ericson2005, ch. 5]; boxes by separating axes
// for contact [Gottschalk1996], and by the least over all pairs of corners and faces and of edges else. No
// iteration.

PRESHAPE_API double distance_point_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                           const Eigen::Vector3d& b);
/// Either segment may be a point.
PRESHAPE_API double distance_segments(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      const Eigen::Vector3d& c, const Eigen::Vector3d& d);
/// The triangle must have an area.
PRESHAPE_API double distance_point_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                            const Eigen::Vector3d& b, const Eigen::Vector3d& c);
PRESHAPE_API double distance_segment_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                                              const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                              const Eigen::Vector3d& c);

/// Distance of a solid, filled, to a triangle with an area.
PRESHAPE_API double distance_solid_triangle(const PosedSolid& solid, const Eigen::Vector3d& a,
                                            const Eigen::Vector3d& b, const Eigen::Vector3d& c);
/// Distance of two filled solids.
PRESHAPE_API double distance_solids(const PosedSolid& first, const PosedSolid& second);

}  // namespace preshape
