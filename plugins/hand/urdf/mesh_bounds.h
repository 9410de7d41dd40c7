#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "preshape/geometry/collision.h"

namespace preshape::urdf_hand {

/// A solid and its pose in the frame of what it bounds.
struct Bounds {
  Solid solid;
  Pose X;
};

/// The vertices of a mesh file, its scene's placements applied.
/// @returns nothing when it cannot be read or has none
std::optional<std::vector<Eigen::Vector3d>> read_vertices(const std::filesystem::path& file);

/// The smallest in volume of a box and three capsules along the axes, centred alike, that hold all points.
/// @param points not empty, finite
Bounds bounds_of(const std::vector<Eigen::Vector3d>& points);

}  // namespace preshape::urdf_hand
