#pragma once

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// What welding and cleaning did.
struct WeldReport {
  int merged_vertices = 0;
  int collapsed_triangles = 0;  ///< two corners became one vertex: removed
  int flat_triangles = 0;       ///< three corners on a line: kept for the topology, see drop_flat_triangles
  int duplicate_triangles = 0;  ///< same three vertices as an earlier one: counted, kept
};

/// Joins vertices not farther apart than `tolerance` >= 0 [length of the mesh] and removes triangles that
/// lose a corner and vertices that no triangle uses. A cell grid with its neighbours is searched, so no pair
/// is missed at a cell boundary. The first vertex of a group, in index order, stays, and later ones within
/// the tolerance of it go: what is left is more than the tolerance apart, no chain of near vertices
/// collapses, and the result does not depend on hashing. Coordinates must be finite.
PRESHAPE_API WeldReport weld(TriangleMesh& mesh, double tolerance);

/// How many of the points are left when each goes that lies within `tolerance` of an earlier one that stays.
PRESHAPE_API std::int64_t count_distinct(const std::vector<Eigen::Vector3d>& points, double tolerance);

/// Removes triangles without area, which have no normal and cannot be touched.
/// @returns how many
PRESHAPE_API int drop_flat_triangles(TriangleMesh& mesh);

}  // namespace preshape
