#pragma once

#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// Most forefingers that oppose the thumb.
inline constexpr int kMostVirtualFingers = 3;

/// Lengths of meshes come as floats, so a 2U cube may be a rounding short of 2U: depths within this share of a
/// limit count as having reached it.
inline constexpr double kDepthTolerance = 1e-5;

/// Rules R1 to R3 of thesis sec. 3.4: below 2U one forefinger, below 4U two, else three.
/// @param depth_m extent of the section along the transverse axis [m]; @param unit_length_m U [m]
PRESHAPE_API int ruled_virtual_fingers(double depth_m, double unit_length_m);

/// Places of the forefingers along the transverse axis, from the middle of the section [m]: 0; or half a spacing to
/// either side; or a spacing to either side and the middle. Index finger first. The thumb is at 0.
PRESHAPE_API std::vector<double> forefinger_places(int virtual_fingers, double finger_spacing_m);

}  // namespace preshape
