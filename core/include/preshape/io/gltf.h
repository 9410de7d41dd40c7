#pragma once

#include <string>

#include "preshape/io/grasp_scene.h"

namespace preshape {

/// A scene as glTF 2.0 binary (.glb), for viewers and renderers: metres, frame O with Y up, as both have it.
///
/// Nodes, below one that has the scene's title: "object"; "hand" with its links by their names; "contacts"
/// with "contact thumb", ..; "normals" with "normal thumb", ..; "wrenches" with "force thumb", "moment
/// thumb", .. and "resultant force", "resultant moment"; "plane" with "approach plane", "approach axis",
/// "opposition axis", beside O where the fingers stand; "approach" with "approach volume" of the open hand,
/// its "entrance" and the "entrance normal". Links that were found in collision have the material
/// "collision". What a scene has not is left out, a force or moment of zero too. An arrow (a moment's has two
/// heads) ends at its contact if it points into the object, else it begins there; those of the resultant
/// begin at O. A unit (the normal force, times L) is a fifth of the object's diagonal long.
///
/// The links rest in the grasp. The animation "motion" of 1.5 s brings the open hand along the approach axis,
/// then closes it; it is left out where the scene has no motion. The way is drawn a diagonal of the object
/// long at most. `asset.extras` has the scene's `verdict`, and which `try` of the run is `shown`.
PRESHAPE_API std::string gltf_binary(const GraspScene& scene);

}  // namespace preshape
