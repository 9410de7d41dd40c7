#pragma once

#include <array>

#include "../context.h"
#include "preshape/fuzzy/pattern.h"
#include "preshape/fuzzy/similarity.h"

namespace preshape::conformance {

/// Partitions with different numbers of sets, the thesis's seven first.
const std::vector<FuzzyPartition>& partitions();

/// Six numbers of a case as a fuzzified vector.
Patterns pattern_of(Case six, const FuzzyPartition& partition = partitions().front());

/// Memberships given as they are, of `sets` sets each, with a crisp vector that does not matter.
struct RawPattern {
  std::array<double, kComponents> crisp{};
  std::vector<double> memberships;
  int sets = 0;
  RawPattern(Case numbers, int set_count);
  PatternView view() const { return {1, sets, crisp.data(), memberships.data()}; }
};

/// One score.
double score(const Similarity& measure, const PatternView& task, const PatternView& pattern);

/// Crisp values at which patterns change their kind: centres and borders of the thesis's sets.
extern const std::vector<double> kCrispCorners;

}  // namespace preshape::conformance
