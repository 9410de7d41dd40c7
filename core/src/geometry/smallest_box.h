#pragma once

#include <span>
#include <vector>

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// Axes of a box of small volume around the corners of a convex body, right-handed, in no particular order.
///
/// The smallest box has two neighbouring sides that each hold an edge of the hull [ORourke1985]. Tried are
/// the directions of the largest facets and the common perpendiculars of the longest edges, each with the
/// smallest rectangle about the shadow along it, then the best are improved by turning about their own axes
/// in turn until the volume stays. Exact for boxes and wherever a side lies on a tried facet; else a local
/// minimum. For points in a plane, the smallest rectangle.
///
/// @param facets  of the hull over `points`; none when the points lie in a plane
/// @param guesses right-handed axes to try as well, at least one
Eigen::Matrix3d smallest_box(const std::vector<Eigen::Vector3d>& points, const std::vector<Triangle>& facets,
                             std::span<const Eigen::Matrix3d> guesses);

}  // namespace preshape
