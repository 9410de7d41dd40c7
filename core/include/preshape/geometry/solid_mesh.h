#pragma once

#include "preshape/geometry/collision.h"

namespace preshape {

/// The surface of a solid as triangles wound outwards, in the solid's own frame S [m]; closed.
/// @param segments round a circle, >= 3; a sphere and the ends of a capsule have half as many from pole to pole
PRESHAPE_API TriangleMesh solid_mesh(const Solid& solid, int segments = 24);

/// An arrow from the origin along z as triangles wound outwards [m]; closed. It ends in a cone of 2.4 times the shaft's
/// radius, or in two behind one another, as couples are drawn; where it is too short for that, all of it is cone.
/// @param length > 0; @param radius of the shaft, > 0; @param heads 1 or 2; @param segments round it, >= 3
PRESHAPE_API TriangleMesh arrow_mesh(double length, double radius, int heads = 1, int segments = 24);

/// The mesh with its vertices taken from frame B to A.
PRESHAPE_API TriangleMesh transformed(TriangleMesh mesh_B, const Pose& X_AB);

/// Appends the triangles of another mesh in the same frame.
PRESHAPE_API void append(TriangleMesh& mesh, const TriangleMesh& other);

}  // namespace preshape
