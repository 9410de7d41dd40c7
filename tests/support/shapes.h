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

/// A wedge along +X, its edge along Z at +X: sides rise by `half_height` over `length`, so that their inward normals
/// are 2 atan(half_height / length) from exact opposition. 8 triangles, wound outwards, box centred on the origin.
inline TriangleMesh wedge(double length, double half_height, double depth) {
  TriangleMesh mesh;
  for (const double z : {-0.5 * depth, 0.5 * depth}) {
    mesh.vertices.emplace_back(-0.5 * length, -half_height, z);
    mesh.vertices.emplace_back(-0.5 * length, half_height, z);
    mesh.vertices.emplace_back(0.5 * length, 0.0, z);
  }
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 1}, {1, 3, 4}, {0, 2, 3}, {2, 5, 3}, {1, 4, 2}, {2, 4, 5}};
  return mesh;
}

/// A regular tetrahedron: no two of its faces oppose each other. Wound outwards.
inline TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0.2, 0.2, 0.2}, {0.2, -0.2, -0.2}, {-0.2, 0.2, -0.2}, {-0.2, -0.2, 0.2}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

/// A closed box from one corner to the opposite one.
inline TriangleMesh box_between(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  TriangleMesh mesh = centred_box(upper - lower);
  for (auto& vertex : mesh.vertices) vertex += 0.5 * (lower + upper);
  return mesh;
}

/// The meshes as one.
inline TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
  TriangleMesh mesh;
  for (const auto& part : parts) {
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& triangle : part.triangles) mesh.triangles.emplace_back(triangle.array() + first);
  }
  return mesh;
}

/// The mesh with every triangle wound the other way.
inline TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// The mesh turned about the origin.
inline TriangleMesh turned(TriangleMesh mesh, const Eigen::Matrix3d& R) {
  for (auto& vertex : mesh.vertices) vertex = R * vertex;
  return mesh;
}

}  // namespace preshape::test
