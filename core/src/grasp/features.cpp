#include "preshape/grasp/features.h"

#include <algorithm>

namespace preshape {

Features make_features(const std::array<double, kComponents>& screw, double stability, double manipulability,
                       const ObjectAttributes& object) {
  Features f{};
  std::copy(screw.begin(), screw.end(), f.begin());
  f[6] = stability / 6.0;
  f[7] = manipulability / 6.0;
  f[8] = object.width_normalised;
  f[9] = object.height_normalised;
  f[10] = object.depth_normalised;
  f[11] = object.vertices_per_triangle;
  f[12] = object.normals_per_triangle;
  f[13] = object.faces_per_triangle;
  f[14] = object.kilotriangles;
  return f;
}

const std::array<const char*, kFeatures>& feature_names() {
  static constexpr std::array<const char*, kFeatures> kNames = {
      "tx", "ty", "tz", "rx", "ry", "rz", "stability", "manipulability", "width", "height", "depth",
      "vertices_per_triangle", "normals_per_triangle", "faces_per_triangle", "kilotriangles"};
  return kNames;
}

}  // namespace preshape
