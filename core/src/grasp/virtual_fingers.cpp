#include "preshape/grasp/virtual_fingers.h"

namespace preshape {

int ruled_virtual_fingers(double depth_m, double unit_length_m) {
  const double depth_U = depth_m / unit_length_m * (1.0 + kDepthTolerance);
  return depth_U < 2.0 ? 1 : depth_U < 4.0 ? 2 : 3;
}

std::vector<double> forefinger_places(int virtual_fingers, double finger_spacing_m) {
  switch (virtual_fingers) {
    case 1: return {0.0};
    case 2: return {-0.5 * finger_spacing_m, 0.5 * finger_spacing_m};
    case 3: return {-finger_spacing_m, 0.0, finger_spacing_m};
    default: return {};
  }
}

}  // namespace preshape
