#pragma once

#include "preshape/fuzzy/alpha_cut.h"

namespace preshape {

/// Least and greatest sum of the degrees of a number of the universe, to 1e-4.
Interval sums_of(const FuzzyPartition& partition, const Interval& universe);

/// Sets that are the best one on no part of the universe wider than a 16384th of it.
std::vector<int> never_best(const FuzzyPartition& partition, const Interval& universe);

}  // namespace preshape
