#pragma once

#include "preshape/geometry/triangle_mesh.h"

struct aiScene;

namespace preshape {

/// Polygons of the scene, each as often as its mesh is placed. Points and lines do not count.
/// @throws InputError when a polygon names a vertex that is not there or has too many corners to be cut up,
/// or
///         when there are too many
std::int64_t count_polygons(const aiScene& scene);

/// Distinct vertex normals of the scene, exactly as they are there; 0 when it has none of any length.
std::int64_t count_vertex_normals(const aiScene& scene);

/// All triangles of a triangulated scene with their placements applied.
TriangleMesh scene_mesh(const aiScene& scene);

}  // namespace preshape
