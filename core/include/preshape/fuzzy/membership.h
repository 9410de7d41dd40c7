#pragma once

#include <string>
#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// One fuzzy set of the real line.
struct PRESHAPE_API Membership {
  enum class Shape { kTrapezoid, kTriangle, kGaussian, kBell, kSigmoid };

  std::string name;
  Shape shape = Shape::kTrapezoid;
  /// trapezoid: a b c d; triangle: a b c; gaussian: centre, sigma; bell: half width, slope, centre;
  /// sigmoid: steepness, crossing. The units are those of the variable.
  std::vector<double> points;
  bool open_below = false;  ///< stays 1 below its top (a left shoulder)
  bool open_above = false;  ///< stays 1 above its top

  /// Degree of membership, 0..1. NaN in, NaN out.
  double operator()(double x) const;
  /// Middle of the top, where a symbol is turned back into a number; the crossing for a sigmoid.
  double top_middle() const;
};

}  // namespace preshape
