#pragma once

#include <array>

#include "preshape/geometry/object.h"
#include "preshape/grasp/task.h"

namespace preshape {

/// Inputs of the classifier (thesis fig. 3.21): Tx Ty Tz Rx Ry Rz, Sta/6, Manu/6, width/L, height/L, depth/L,
/// vertices/triangles, normals/triangles, faces/triangles, triangles/1000.
inline constexpr int kFeatures = 15;
using Features = std::array<double, kFeatures>;

/// @param screw the task wanted, or the resultant wrench when a grasp is taught
/// @param stability, manipulability 0..6
PRESHAPE_API Features make_features(const std::array<double, kComponents>& screw, double stability,
                                    double manipulability, const ObjectAttributes& object);

/// Column names, in order.
PRESHAPE_API const std::array<const char*, kFeatures>& feature_names();

}  // namespace preshape
