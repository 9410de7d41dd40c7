#pragma once

#include "preshape/fuzzy/partition.h"

namespace preshape {

/// A closed interval of the real line, whose ends may be infinite; empty when it ends before it begins.
struct Interval {
  double from = 0.0, to = -1.0;
  bool empty() const { return !(from <= to); }
  double width() const { return empty() ? 0.0 : to - from; }
  bool operator==(const Interval&) const = default;
};

PRESHAPE_API Interval intersection(const Interval& a, const Interval& b);

/// Where a set's degree is `degree` at least: its alpha-cut, in closed form. It is one interval, for every shape is a hill
/// or a slope.
/// @param degree 0 < degree <= 1
PRESHAPE_API Interval alpha_cut(const Membership& set, double degree);

/// The interval in which the sets differ: from the lowest to the highest of their points, of a curve three widths to either
/// side (a sigmoid's width being one over its steepness, twice). Shoulders go on beyond it.
PRESHAPE_API Interval span_of(const FuzzyPartition& partition);

}  // namespace preshape
