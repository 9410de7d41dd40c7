#include <algorithm>
#include <cmath>

#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Total fuzzy distance (thesis eq. 3.9.4, 3.9.5): the Euclidean distance of the two fuzzy vectors of each
/// component, summed over the six components. Lower is nearer; at most sqrt(sets) a component, whatever the sets.
class Tfdist final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() { return {"symmetric", "additive", "reflexive", "separating", "monotone", "continuous", "metric", "crisp_complement",
            "permutation_invariant", "formula_tfdist"}; }
  explicit Tfdist(const preshape::Parameters&) {}

  preshape::SimilarityScale scale(int sets) const noexcept override {
    return {kComponents * std::sqrt(static_cast<double>(sets)), 0.0};
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    for (std::size_t k = 0; k < kComponents; ++k) {
      const double* q = task.memberships + k * static_cast<std::size_t>(task.sets);
      const double* w = pattern.memberships + k * static_cast<std::size_t>(task.sets);
      double squares = 0.0;
      for (int i = 0; i < task.sets; ++i) squares += (q[i] - w[i]) * (q[i] - w[i]);
      scores[k] = std::sqrt(squares);
    }
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"tfdist", "1.0.0", "BSD-3-Clause", "the preshape developers", "Total fuzzy distance"}),
                ({"similarity/tfdist"}),
                preshape::component<Tfdist>("tfdist", "Sum of Euclidean distances of memberships (thesis eq. 3.9.5)"))
