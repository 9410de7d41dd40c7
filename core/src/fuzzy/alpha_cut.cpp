#include "preshape/fuzzy/alpha_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace preshape {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Interval trapezoid_cut(double a, double b, double c, double d, double degree) {
  return {a + degree * (b - a), d - degree * (d - c)};
}

Interval sigmoid_cut(double steepness, double crossing, double degree) {
  if (steepness == 0.0) return degree <= 0.5 ? Interval{-kInfinity, kInfinity} : Interval{};
  const double end = crossing + std::log(degree / (1.0 - degree)) / steepness;
  if (!std::isfinite(end)) return {};  // 1 is never reached
  return steepness > 0.0 ? Interval{end, kInfinity} : Interval{-kInfinity, end};
}

Interval closed_cut(const Membership& set, double degree) {
  const auto& p = set.points;
  const auto around = [](double centre, double half) { return Interval{centre - half, centre + half}; };
  switch (set.shape) {
    case Membership::Shape::kTrapezoid: return trapezoid_cut(p[0], p[1], p[2], p[3], degree);
    case Membership::Shape::kTriangle: return trapezoid_cut(p[0], p[1], p[1], p[2], degree);
    case Membership::Shape::kGaussian: return around(p[0], p[1] * std::sqrt(-2.0 * std::log(degree)));
    case Membership::Shape::kBell: return around(p[2], p[0] * std::pow((1.0 - degree) / degree, 0.5 / p[1]));
    case Membership::Shape::kSigmoid: return sigmoid_cut(p[0], p[1], degree);
  }
  return {};
}

/// Where a set differs from what it is far away, on the whole.
Interval span_of(const Membership& set) {
  const auto& p = set.points;
  switch (set.shape) {
    case Membership::Shape::kTrapezoid:
    case Membership::Shape::kTriangle: return {p.front(), p.back()};
    case Membership::Shape::kGaussian: return {p[0] - 3 * p[1], p[0] + 3 * p[1]};
    case Membership::Shape::kBell: return {p[2] - 3 * p[0], p[2] + 3 * p[0]};
    case Membership::Shape::kSigmoid: {
      const double half = p[0] == 0.0 ? 0.0 : 6.0 / std::abs(p[0]);
      return {p[1] - half, p[1] + half};
    }
  }
  return {};
}

}  // namespace

Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

Interval alpha_cut(const Membership& set, double degree) {
  Interval cut = closed_cut(set, degree);
  if (set.shape == Membership::Shape::kSigmoid) return cut;  // a shoulder by itself
  if (set.open_below) cut.from = -kInfinity;
  if (set.open_above) cut.to = kInfinity;
  return cut;
}

Interval span_of(const FuzzyPartition& partition) {
  Interval span{kInfinity, -kInfinity};
  for (const Membership& set : partition.sets()) {
    const Interval own = span_of(set);
    span = {std::min(span.from, own.from), std::max(span.to, own.to)};
  }
  return span;
}

}  // namespace preshape
