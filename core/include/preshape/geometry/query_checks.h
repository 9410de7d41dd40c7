#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "preshape/geometry/collision.h"

namespace preshape {

// What every collision backend has to look at before it answers.

/// The triangles of a mesh that can be met: those with an area (see is_flat).
/// @throws InputError when a triangle names a vertex that is not there or one whose coordinates are not
/// finite
PRESHAPE_API std::vector<std::int32_t> touchable_triangles(TriangleMeshView mesh);

/// Diagonal of the box around all vertices; 0 without any.
PRESHAPE_API double extent_of(TriangleMeshView mesh);

/// @throws InputError when the sizes differ, an origin is not finite, or a direction is not of unit length to
/// 1e-6;
///         names the ray
PRESHAPE_API void check_rays(std::span<const Ray> rays, std::size_t hits);

/// @throws InputError when the sizes differ, or a solid has a negative size or a number that is not finite;
/// names the
///         solid
PRESHAPE_API void check_solids(std::span<const PosedSolid> solids, std::size_t distances);

}  // namespace preshape
