#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "preshape/base/parameters.h"

namespace preshape {

/// One way to come to an object: the hand moves along a, the forefingers push along n_f from the side -n_f, the
/// thumb along -n_f from the side +n_f; the forefingers stand side by side along t = n_f x a. Unit axes in O.
struct ApproachPlane {
  Eigen::Vector3d a, n_f;
  /// Along which the forefingers are spread and the dynamic depth is measured: the positive coordinate axis where
  /// the plane lies along coordinate axes (spec section 2), n_f x a elsewhere.
  Eigen::Vector3d transverse;

  /// @throws InputError unless both are finite, not zero and at right angles (1e-6)
  PRESHAPE_API static ApproachPlane along(const Eigen::Vector3d& a, const Eigen::Vector3d& n_f);
  /// "a +X, forefingers push -Y".
  PRESHAPE_API std::string text() const;
};

using ApproachPlanes = std::vector<ApproachPlane>;

/// The twelve planes of thesis fig. 3.12, in their order; plane k of the thesis has index k - 1.
PRESHAPE_API ApproachPlanes thesis_planes();

/// Directions spread evenly over the sphere, each with `rolls` planes turned evenly about it: a spherical Fibonacci
/// lattice [SwinbankPurser2006] in an order whose every beginning is spread as well, so that a search that ends early
/// has looked everywhere.
/// @throws InputError when a number is below 1
PRESHAPE_API ApproachPlanes sampled_planes(int directions, int rolls);

/// From a script: a list of { approach = "+X", push = "-Y" } with axes or {x, y, z} vectors; or { directions = 60,
/// rolls = 8, thesis = true }: the thesis's twelve, unless told not to, and sampled ones.
/// @throws InputError with file and line
PRESHAPE_API ApproachPlanes planes_from_value(const Value& planes);
PRESHAPE_API std::vector<Mistake> check_planes(const Value& planes);

}  // namespace preshape
