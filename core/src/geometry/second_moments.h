#pragma once

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

/// Second moments about the centroid: of the volume where the mesh bounds one, else of the surface. Scaled to
/// an arbitrary mass, as only directions and ratios are read from them.
Eigen::Matrix3d second_moments(const TriangleMesh& mesh);

}  // namespace preshape
