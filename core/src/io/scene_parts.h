#pragma once

#include <array>
#include <string>
#include <vector>

#include "preshape/io/grasp_scene.h"

namespace preshape {

struct SceneColour {
  const char* name;           ///< "object", "force"
  std::array<float, 4> rgba;  ///< sRGB and opacity, 0 .. 1
};

/// A thing in a drawn scene that can be pointed at.
struct ScenePart {
  std::string name, group;             ///< no name twice; no group: it stands alone
  TriangleMesh mesh_S;                 ///< [m]
  Pose X_OS;                           ///< at rest
  const SceneColour* colour;           ///< one of a few, for ever
  bool smooth = false;                 ///< a round solid, to be shaded as such
  std::vector<Pose> X_OS_motion = {};  ///< one a frame; empty: it rests
};

/// Everything that a scene shows, the object first.
std::vector<ScenePart> scene_parts(const GraspScene& scene);

/// Diagonal of the object's box [m]: what arrows and marks are measured by.
double scene_size(const GraspScene& scene);

}  // namespace preshape
