#pragma once

#include <vector>

#include "preshape/io/picture.h"

namespace preshape {

/// How a part looks.
struct PictureMaterial {
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();  ///< sRGB, 0 .. 255
  float opacity = 1.0F;                              ///< where nothing hides it
  float hidden_opacity = 0.0F;                       ///< where the object is before it
  bool shaded = true;
};

/// Triangles that are drawn together, of which only the nearest is seen.
struct PicturePart {
  TriangleMesh mesh_O;
  std::vector<std::size_t> material_of;  ///< per triangle
  std::vector<PictureMaterial> materials;

  /// Appends a mesh in O.
  void add(const TriangleMesh& mesh, const PictureMaterial& material);
};

/// The object alone, then the palm, the fingers, the marks, the approach plane and
/// the approach volume, as far as they are there.
/// @throws InputError on a posture that the motion has not
std::vector<PicturePart> picture_parts(const GraspScene& scene, const PictureOptions& options);

}  // namespace preshape
