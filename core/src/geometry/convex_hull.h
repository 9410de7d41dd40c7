#pragma once

#include <array>
#include <vector>

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// Convex hull of points in space: the corners, and the facets with outward normals.
struct ConvexHull {
  std::vector<Eigen::Vector3d> points;  ///< the corners of the facets
  std::vector<Triangle> facets;         ///< anticlockwise from outside
};

/// Quickhull [Barber1996]. Points nearer than 1e-9 of the extent to a facet count as on it, so the result may
/// miss corners by that much: enough to look for directions and to measure, not to prove anything.
/// @returns no facets when the points lie in a plane, to the same tolerance
ConvexHull convex_hull(const std::vector<Eigen::Vector3d>& points);

/// Corners of the convex hull of points in the plane, anticlockwise, without points on the sides (monotone
/// chain [Andrew1979]).
std::vector<Eigen::Vector2d> convex_polygon(std::vector<Eigen::Vector2d> points);

}  // namespace preshape
