#pragma once

#include "preshape/contact/grasp_wrench_space.h"

namespace ferrari_canny {

/// The most points that a hull is asked of: with more, it takes seconds.
inline constexpr Eigen::Index kMostPoints = 1024;

/// The six-dimensional volume of a space that spans six dimensions, by Qhull [Barber1996], with joggled input
/// where rounding stops it otherwise.
/// @throws InputError when it has more than kMostPoints points, or Qhull finds no hull
double volume(const preshape::GraspWrenchSpace& space);

}  // namespace ferrari_canny
