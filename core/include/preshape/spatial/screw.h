#pragma once

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/spatial/wrench.h"

namespace preshape {

/// Central axis of a force system [Ball1900]: a line, the pitch along it and the magnitude.
struct Screw {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< unit; zero for the zero wrench
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      ///< p_PQ: the axis' point nearest to P
  double pitch = 0.0;      ///< moment along the axis over the force; infinite for a pure couple
  double magnitude = 0.0;  ///< |f|, or |m| for a pure couple
};

/// Poinsot's reduction: F_P = magnitude * (direction; point x direction + pitch * direction).
/// @param couple_limit a force below this share of |m| counts as none
PRESHAPE_API Screw poinsot_reduce(const Wrench& F_P, double couple_limit = 1e-12);

}  // namespace preshape
