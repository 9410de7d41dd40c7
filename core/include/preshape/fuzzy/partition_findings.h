#pragma once

#include <string>
#include <vector>

#include "preshape/fuzzy/alpha_cut.h"

namespace preshape {

/// An interval in which no set reaches the bound.
struct Gap {
  Interval where;
  double lowest = 0.0;  ///< to which the best set's degree falls in it
};

/// Two sets and the highest degree that they have together.
struct Crossing {
  int first = 0, second = 0;  ///< indices, in the order of the partition
  double height = 0.0;        ///< max over x of the lower of both degrees; 0 where they do not meet
  double x = 0.0;             ///< where; NaN where they do not meet
};

/// How well a family of sets divides a variable. Nothing here is a mistake that FuzzyPartition refuses: a family with gaps
/// works, and answers badly in them.
struct PartitionFindings {
  Interval universe;
  double bound = 0.5;
  std::vector<Gap> gaps;            ///< ascending; none: the family is complete to the bound (epsilon-complete)
  std::vector<Crossing> crossings;  ///< of each set with the next
  std::vector<Crossing> crowded;    ///< neighbours that are both 1 on more than a point; others that reach the bound together
  double least_sum = 0.0, most_sum = 0.0;  ///< of the degrees of a number, to 1e-4; both 1 in a Ruspini partition
  std::vector<int> never_best;      ///< sets that are best on no part of the universe over a 16384th of it
  std::vector<int> out_of_order;    ///< sets whose top is not above that of the one before

  /// Nothing that a user should be told.
  bool fine() const { return gaps.empty() && crowded.empty() && never_best.empty() && out_of_order.empty(); }
};

/// Looks at a family over a universe, from its alpha-cuts: gaps and crossings are exact to rounding and none is overlooked,
/// however narrow, down to 1e-9 of the universe.
/// @param bound 0 < bound <= 1; a half is customary
/// @throws InputError when the bound is none, or the universe is empty or infinite
PRESHAPE_API PartitionFindings findings_of(const FuzzyPartition& partition, const Interval& universe, double bound = 0.5);

/// What a user should be told, a sentence each.
PRESHAPE_API std::vector<std::string> sentences(const PartitionFindings& findings, const FuzzyPartition& partition);

}  // namespace preshape
