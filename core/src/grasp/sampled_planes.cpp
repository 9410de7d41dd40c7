#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/grasp/approach_plane.h"

namespace preshape {

namespace {

/// The i-th of `count` points of the spherical Fibonacci lattice: equal steps in height, golden angles round it.
Eigen::Vector3d fibonacci_direction(int i, int count) {
  const double z = 1.0 - (2.0 * i + 1.0) / count, radius = std::sqrt(std::max(0.0, 1.0 - z * z));
  const double angle = 2.0 * std::numbers::pi * i / std::numbers::phi;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// The binary digits of i mirrored at the point (van der Corput): sorting by it spreads every beginning.
double radical_inverse(int i) {
  double inverse = 0.0;
  for (double digit = 0.5; i > 0; i /= 2, digit /= 2) inverse += digit * (i % 2);
  return inverse;
}

std::vector<int> spread_order(int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [](int a, int b) { return radical_inverse(a) < radical_inverse(b); });
  return order;
}

}  // namespace

ApproachPlanes sampled_planes(int directions, int rolls) {
  if (directions < 1 || rolls < 1) {
    throw InputError(fmt::format("planes are sampled with at least one direction and one roll, got {} and {}", directions, rolls));
  }
  ApproachPlanes planes;
  for (const int i : spread_order(directions)) {
    const Eigen::Vector3d a = fibonacci_direction(i, directions), across = a.unitOrthogonal();
    for (const int roll : spread_order(rolls)) {
      const Eigen::AngleAxisd turn(2.0 * std::numbers::pi * roll / rolls, a);
      planes.push_back(ApproachPlane::along(a, turn * across));
    }
  }
  return planes;
}

}  // namespace preshape
