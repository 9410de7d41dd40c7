#include "../check.h"
#include "queries.h"

namespace preshape::conformance {

namespace {

constexpr Check kChecks[] = {
    {"B01", "collision", "the nearest hit of a ray is the one found by looking at every triangle",
     b01_nearest_hit},
    {"B02", "collision",
     "declared watertight: rays from inside a closed mesh at corners and edges never miss", b02_watertight,
     "watertight"},
    {"B03", "collision", "triangles without area are never met, and change nothing", b03_flat_triangles},
    {"B04", "collision", "a ray meets nothing behind its beginning, however near", b04_rays_from_the_surface},
    {"B05", "collision", "a ray in the plane of a face gets a number, the same to and fro",
     b05_rays_in_a_face},
    {"B06", "collision",
     "rays along an axis meet the same with zeros of either sign, also a plate without thickness",
     b06_signed_zeros},
    {"B07", "collision", "a direction that is not of unit length to 1e-6 is refused", b07_unit_directions},
    {"B08", "collision", "a direction that is zero or not finite is refused", b08_no_direction},
    {"B09", "collision",
     "the distance of a solid to the surface is right, and changes no faster than the solid moves",
     b09_distances_to_the_surface},
    {"B10", "collision", "the distance of two solids is right, the same both ways, and shrinks as one grows",
     b10_distances_of_pairs},
    {"B12", "collision", "moving the mesh with the rays and solids changes no answer",
     b12_moves_with_the_body},
    {"B13", "collision", "the order and winding of the triangles do not matter", b13_order_and_winding},
    {"B14", "collision", "a triangle with a corner that is not there or not finite is refused by its number",
     b14_refuses_broken_meshes},
    {"B17", "collision", "on 100000 triangles rays meet the right ones, no slower than by looking at each",
     b17_large_meshes, "", Tier::kFull, 120.0},
    {"B19", "collision", "of triangles met at the same distance the lowest is named", b19_lowest_of_equals},
    {"B20", "collision", "a mesh without triangles is met by nothing and infinitely far", b20_empty_mesh},
    {"B21", "collision", "a scene does not need the mesh that it was built from", b21_keeps_its_own_mesh},
};

}  // namespace

std::span<const Check> collision_checks() {
  return kChecks;
}

}  // namespace preshape::conformance
