#pragma once

#include <array>
#include <vector>

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// Unit normals of each triangle's corners: of the triangles around the corner, by area, those that stand to
/// this one by less than `crease` [rad]; so that round surfaces look round and edges stay sharp. A flat
/// triangle has any.
std::vector<std::array<Eigen::Vector3f, 3>> smooth_normals(const TriangleMesh& mesh, double crease);

}  // namespace preshape
