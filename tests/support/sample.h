#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "preshape/base/random.h"
#include "preshape/spatial/wrench.h"

namespace preshape::test {

/// Each component uniform in [-1, 1).
inline Eigen::Vector3d random_vector(Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  return {x, y, z};
}

inline Eigen::Vector3d random_unit(Random& random) {
  Eigen::Vector3d v = random_vector(random);
  while (v.norm() < 0.1 || v.norm() > 1.0) v = random_vector(random);
  return v.normalized();
}

/// Uniform over all rotations.
inline Eigen::Matrix3d random_rotation(Random& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

inline Wrench random_wrench(Random& random) {
  const Eigen::Vector3d f = random_vector(random);
  return {f, random_vector(random)};
}

}  // namespace preshape::test
