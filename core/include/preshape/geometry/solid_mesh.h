#pragma once

#include "preshape/geometry/collision.h"

namespace preshape {

/// The surface of a solid as triangles wound outwards, in the solid's own frame S [m]; closed.
/// @param segments round a circle, >= 3; a sphere and the ends of a capsule have half as many from pole to pole
PRESHAPE_API TriangleMesh solid_mesh(const Solid& solid, int segments = 24);

/// The mesh with its vertices taken from frame B to A.
PRESHAPE_API TriangleMesh transformed(TriangleMesh mesh_B, const Pose& X_AB);

/// Appends the triangles of another mesh in the same frame.
PRESHAPE_API void append(TriangleMesh& mesh, const TriangleMesh& other);

}  // namespace preshape
