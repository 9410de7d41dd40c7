#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Set-theoretic similarity (thesis eq. 3.9.1, there after Santini and Jain) [Jaccard1912]: for each
/// component |q and w| / (|q| + |w| - |q and w|), with |.| the sum of the memberships and "and" their
/// minimum; summed over the six components. 0 .. 6, higher is nearer. Two empty fuzzy vectors are equal and
/// count 1.
class Jaccard final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite",
            "symmetric",
            "additive",
            "reflexive",
            "separating",
            "monotone",
            "metric",
            "crisp_complement",
            "permutation_invariant",
            "formula_jaccard"};
  }
  explicit Jaccard(const preshape::Parameters&) {}

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
    double common = 0.0, both = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      common += std::min(q[i], w[i]);
      both += q[i] + w[i];
    }
    if (!std::isfinite(both)) {
      throw preshape::InputError("similarity 'jaccard': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return both > 0.0 ? common / (both - common) : 1.0;
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"jaccard", "1.0.0", "BSD-3-Clause", "the preshape developers", "Set-theoretic similarity"}),
                ({"similarity/jaccard"}),
                preshape::component<Jaccard>("jaccard",
                                             "Intersection over union of the memberships (thesis eq. 3.9.1)"))
