#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Similarity by the largest difference [PappisKaracapilidis1993]: for each component 1 - max |q - w| over
/// the memberships; summed over the six components. 0 .. 6, higher is nearer.
class LargestDifference final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite",
            "symmetric",
            "additive",
            "reflexive",
            "separating",
            "monotone",
            "continuous",
            "metric",
            "crisp_complement",
            "permutation_invariant",
            "formula_largest_difference"};
  }
  explicit LargestDifference(const preshape::Parameters&) {}

  preshape::SimilarityScale scale(int) const noexcept override { return {0.0, kComponents}; }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    const auto sets = static_cast<std::size_t>(task.sets);
    for (std::size_t k = 0; k < kComponents; ++k) {
      scores[k] = component(k, {task.memberships + k * sets, sets}, {pattern.memberships + k * sets, sets});
    }
  }

 private:
  static double component(std::size_t k, std::span<const double> q, std::span<const double> w) {
    double largest = 0.0, all = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      largest = std::max(largest, std::abs(q[i] - w[i]));
      all += q[i] + w[i];
    }
    if (!std::isfinite(all)) {
      throw preshape::InputError("similarity 'largest_difference': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return 1.0 - largest;
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"largest_difference", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Similarity by the largest difference"}),
                ({"similarity/largest_difference"}),
                preshape::component<LargestDifference>("largest_difference",
                                                       "One minus the largest difference of the memberships"))
