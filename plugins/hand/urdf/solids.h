#pragma once

#include <string>
#include <vector>

#include "fingers.h"

namespace preshape::urdf_hand {

/// The collision geometry of the URDF, and one sentence on each piece that was left out.
struct Solids {
  std::vector<LinkSolid> solids;
  std::vector<std::string> notes;
};

/// Boxes and spheres as they are, cylinders as capsules of their length (flat ones as boxes), meshes by what
/// bounds them. A mesh that is missing or cannot be read is left out, as are links that move by a joint that
/// no finger has.
/// @throws InputError on sizes that are not positive numbers
Solids build_solids(const Description& description, const Document& document, const Fingers& fingers);

}  // namespace preshape::urdf_hand
