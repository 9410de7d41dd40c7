#pragma once

#include "preshape/contact/grasp_wrench_space.h"

namespace preshape {

/// Wrenches centre + half_axes .* y with |y| <= 1, axes along those of the wrench (about O, in O).
struct WrenchEllipsoid {
  WrenchVector centre = WrenchVector::Zero();
  WrenchVector half_axes = WrenchVector::Ones();  ///< >= 0
  /// How far it reaches along u.
  double reach(const WrenchVector& u) const { return centre.dot(u) + half_axes.cwiseProduct(u).norm(); }
};

/// How much of an ellipsoid fits into a grasp wrench space.
struct EllipsoidFit {
  double factor = 0.0;  ///< >= 0
  bool spans = false;   ///< the space has six dimensions; else the factor is 0 by definition
};

/// The largest factor by which the ellipsoid, its centre with it, can be multiplied and still lies in the
/// space; that of the unit ball is Ferrari and Canny's epsilon.
///
/// It grows a simplicial polytope inside the space, always at the facet that the ellipsoid would meet first
/// (van den Bergen's expanding polytope, in six dimensions). Where the space has no vertex beyond that facet,
/// this is a facet of the space itself, so the factor is exact up to rounding, and most of the hull is never
/// built. Where rounding makes the polytope inconsistent, it starts again with wrenches joggled by 1e-10 of
/// the space's radius.
/// @param ellipsoid finite, not just the point 0
/// @throws InputError when even joggled wrenches give no hull
/// @see [FerrariCanny1992; LiSastry1988; VanDenBergen2001]
PRESHAPE_API EllipsoidFit largest_ellipsoid(const GraspWrenchSpace& space,
                                            const WrenchEllipsoid& ellipsoid = {});

}  // namespace preshape
