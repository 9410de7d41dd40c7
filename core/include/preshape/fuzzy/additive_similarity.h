#pragma once

#include "preshape/fuzzy/similarity.h"

namespace preshape {

/// A similarity that is the sum of its six component scores: a plugin has to say scale and component_scores
/// alone. Declare the capability "additive".
class PRESHAPE_API AdditiveSimilarity : public Similarity {
 public:
  ~AdditiveSimilarity() override;
  /// @throws InputError when there is not one score for each pattern
  void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const final;
};

}  // namespace preshape
