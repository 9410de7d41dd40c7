#pragma once

#include <string>
#include <vector>

#include "preshape/geometry/triangle_mesh.h"
#include "preshape/geometry/weld.h"

namespace preshape {

/// Distance, as a share of the box's diagonal, up to which vertices are taken for one. Files keep coordinates
/// in single precision, whose rounding is 6e-8 of the largest coordinate: ten times the diagonal from the
/// origin that is 6e-7 of it. Meshes of the field do not change their topology between 1e-7 and 3e-6 and
/// begin to lose detail at 1e-5.
inline constexpr double kDefaultWeld = 1e-6;

/// More triangles than this are refused: at about 100 bytes each through the whole analysis they stay in
/// memory.
inline constexpr std::size_t kMostTriangles = 5'000'000;

/// What was found in a mesh, and what was done about it.
struct MeshRepair {
  WeldReport weld;
  MeshTopology topology;              ///< after the weld, before flat triangles were dropped
  int flat_triangles = 0;             ///< dropped, see drop_flat_triangles
  bool turned = false;                ///< the faces pointed inwards and were turned
  std::vector<std::string> warnings;  ///< one sentence each, with the numbers
};

/// Makes a mesh fit for analysis: welds, drops triangles without area, turns a closed, consistently wound
/// mesh of negative volume inside out. Holes, edges of three triangles, inconsistent winding, several pieces
/// and duplicate triangles are left as they are and told.
/// @param weld_tolerance share of the box's diagonal, >= 0
/// @throws InputError when a coordinate is not finite, a triangle names a vertex that is not there, there are
/// more
///         than kMostTriangles, or no triangle with an area is left; the sentence begins in lower case, for
///         the caller to say of which object
PRESHAPE_API MeshRepair repair_mesh(TriangleMesh& mesh, double weld_tolerance = kDefaultWeld);

}  // namespace preshape
