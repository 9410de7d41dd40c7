#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "preshape/geometry/mesh_repair.h"
#include "preshape/geometry/object.h"

namespace preshape {

/// Endings of the object files that can be read, lower case, sorted: dae, glb, gltf, obj, off, ply, stl, x.
PRESHAPE_API std::span<const std::string> object_file_endings();

/// Reads a mesh file and makes it fit for analysis (see repair_mesh).
///
/// Placements of the file's scene are applied (each use of a mesh counts), a mirrored one with its faces
/// turned back, and polygons are cut into triangles after they were counted. Axes are those of the file's
/// numbers, also where a format names an up direction. glTF states metres, and COLLADA its unit, which is
/// converted to metres; the other formats state none. Materials, textures, bones and animations are not
/// looked at.
///
/// `file_normals` counts exactly distinct vertex normals where the file has any, else distinct facet normals,
/// to 1e-4.
///
/// @param weld_tolerance share of the box's diagonal, in [0, 0.01]
/// @throws InputError in one sentence that names the file and the mend: missing, not a file, unreadable,
/// empty,
///         of an unknown ending, in UTF-16, too large, damaged, without triangles or with coordinates that
///         are not finite
PRESHAPE_API RawObject read_object(const std::filesystem::path& file, double weld_tolerance = kDefaultWeld);

}  // namespace preshape
