#pragma once

#include <span>

#include "preshape/base/export.h"
#include "preshape/fuzzy/pattern.h"

namespace preshape {

/// The values that a similarity measure can take, and its direction: nearer is towards `nearest`.
struct SimilarityScale {
  double farthest = 0.0;
  double nearest = 1.0;
  bool higher_is_nearer() const { return nearest > farthest; }
  /// a is nearer than b.
  bool nearer(double a, double b) const { return higher_is_nearer() ? a > b : a < b; }
  /// The score reaches a threshold.
  bool reaches(double score, double threshold) const {
    return higher_is_nearer() ? score >= threshold : score <= threshold;
  }
};

/// Kind `similarity`: how near a wrench pattern is to a task (thesis sec. 3.9). [any thread, const]
class PRESHAPE_API Similarity {
 public:
  virtual ~Similarity();

  /// @param sets number of fuzzy sets of the patterns
  virtual SimilarityScale scale(int sets) const noexcept = 0;

  /// Scores of `patterns` against the single pattern `task`; `scores` has patterns.count.
  virtual void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const = 0;

  /// How much each of the six components adds to the score of one pattern; for a measure that is a sum over
  /// components the six add up to compare's score, else each is the measure of that component alone.
  virtual void component_scores(const PatternView& task, const PatternView& pattern,
                                std::span<double, kComponents> scores) const = 0;

  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
