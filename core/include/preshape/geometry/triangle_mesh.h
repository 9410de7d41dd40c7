#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "preshape/base/export.h"

namespace preshape {

using Triangle = Eigen::Matrix<std::int32_t, 3, 1>;

/// Indexed triangles. Corners run anticlockwise seen from outside. The frame and unit are those of the name
/// that holds the mesh (`mesh_O` in metres).
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;

  const Eigen::Vector3d& corner(std::size_t triangle, int k) const {
    return vertices[static_cast<std::size_t>(triangles[triangle][k])];
  }
  /// (B - A) x (C - A): outward when the winding is right; its length is twice the area.
  Eigen::Vector3d area_vector(std::size_t t) const {
    return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
  }
};

/// A mesh as it crosses into a plugin: not owning, valid during the call only unless the callee says more.
struct TriangleMeshView {
  std::span<const Eigen::Vector3d> vertices;
  std::span<const Triangle> triangles;

  TriangleMeshView() = default;
  TriangleMeshView(const TriangleMesh& mesh) : vertices(mesh.vertices), triangles(mesh.triangles) {}
};

/// Below this share of its longest side squared, twice a triangle's area counts as none: rounding of the
/// corners alone makes that much.
inline constexpr double kFlatTriangle = 1e-12;

/// Whether three corners lie on a line, to kFlatTriangle: such a triangle has no normal.
PRESHAPE_API bool is_flat(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Axis-aligned box.
struct Box {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();

  Eigen::Vector3d extents() const { return upper - lower; }
  Eigen::Vector3d centre() const { return 0.5 * (lower + upper); }
};

/// The box around the vertices that a triangle uses. The mesh must not be empty.
PRESHAPE_API Box bounding_box(const TriangleMesh& mesh);

/// Volume and volume centroid of a closed mesh by the divergence theorem (signed: negative when faces point
/// inwards). The centroid is NaN or infinite when the volume is zero.
struct VolumeProperties {
  double volume = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};
PRESHAPE_API VolumeProperties volume_properties(const TriangleMesh& mesh);

/// What the edges say about a mesh.
struct MeshTopology {
  int open_edges = 0;          ///< edges of one triangle only
  int non_manifold_edges = 0;  ///< edges of three or more triangles
  int inconsistent_edges = 0;  ///< edges that their two triangles run through in the same direction
  int unbalanced_edges = 0;    ///< edges not run through as often one way as the other
  int pieces = 0;              ///< parts connected through edges
  bool watertight() const { return open_edges == 0 && non_manifold_edges == 0; }
  /// The faces' sides cancel, so that the divergence theorem holds. Not the same as watertight: solids that
  /// share an edge bound a volume, and one with a reversed face does not.
  bool bounds_volume() const { return unbalanced_edges == 0; }
};
PRESHAPE_API MeshTopology mesh_topology(const TriangleMesh& mesh);

}  // namespace preshape
