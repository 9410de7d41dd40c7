#pragma once

#include "preshape/geometry/triangle_mesh.h"

namespace preshape::test {

/// A closed box centred on the origin, 12 triangles, wound outwards.
inline TriangleMesh centred_box(const Eigen::Vector3d& extents) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        0.5 * Eigen::Vector3d((i & 1 ? 1 : -1) * extents.x(), (i & 2 ? 1 : -1) * extents.y(), (i & 4 ? 1 : -1) * extents.z()));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// The mesh turned about the origin.
inline TriangleMesh turned(TriangleMesh mesh, const Eigen::Matrix3d& R) {
  for (auto& vertex : mesh.vertices) vertex = R * vertex;
  return mesh;
}

}  // namespace preshape::test
