#include "preshape/fuzzy/membership.h"

#include <cmath>

#include "preshape/base/assert.h"

namespace preshape {

namespace {

double trapezoid(double x, double a, double b, double c, double d) {
  if (x >= b && x <= c) return 1.0;
  if (x <= a || x >= d) return 0.0;
  return x < b ? (x - a) / (b - a) : (d - x) / (d - c);
}

}  // namespace

double Membership::operator()(double x) const {
  if (std::isnan(x)) return x;
  const auto& p = points;
  if (shape != Shape::kSigmoid) {
    // The sigmoid is a shoulder by itself; every other shape may be held at 1 beyond its top.
    const double top = top_middle();
    if ((open_below && x <= top) || (open_above && x >= top)) return 1.0;
  }
  switch (shape) {
    case Shape::kTrapezoid: return trapezoid(x, p[0], p[1], p[2], p[3]);
    case Shape::kTriangle: return trapezoid(x, p[0], p[1], p[1], p[2]);
    case Shape::kGaussian: return std::exp(-0.5 * std::pow((x - p[0]) / p[1], 2));
    case Shape::kBell: return 1.0 / (1.0 + std::pow(std::abs((x - p[2]) / p[0]), 2.0 * p[1]));
    case Shape::kSigmoid: return 1.0 / (1.0 + std::exp(-p[0] * (x - p[1])));
  }
  return 0.0;
}

double Membership::top_middle() const {
  switch (shape) {
    case Shape::kTrapezoid: return 0.5 * (points[1] + points[2]);
    case Shape::kTriangle:
    case Shape::kSigmoid: return points[1];
    case Shape::kGaussian: return points[0];
    case Shape::kBell: return points[2];
  }
  return 0.0;
}

}  // namespace preshape
