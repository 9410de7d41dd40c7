#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Similarity of approximate analogical reasoning [TurksenZhong1988]: for each component 1 / (1 + D) with D
/// the Euclidean distance over the root of the number of sets; summed over the six components. 3 .. 6, higher
/// is nearer.
class TurksenZhong final : public preshape::AdditiveSimilarity {
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
            "formula_turksen_zhong"};
  }
  explicit TurksenZhong(const preshape::Parameters&) {}

  preshape::SimilarityScale scale(int) const noexcept override { return {0.5 * kComponents, kComponents}; }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    const auto sets = static_cast<std::size_t>(task.sets);
    for (std::size_t k = 0; k < kComponents; ++k) {
      scores[k] = component(k, {task.memberships + k * sets, sets}, {pattern.memberships + k * sets, sets});
    }
  }

 private:
  static double component(std::size_t k, std::span<const double> q, std::span<const double> w) {
    double squares = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) squares += (q[i] - w[i]) * (q[i] - w[i]);
    if (!std::isfinite(squares)) {
      throw preshape::InputError("similarity 'turksen_zhong': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return 1.0 / (1.0 + std::sqrt(squares / static_cast<double>(q.size())));
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"turksen_zhong", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Similarity of analogical reasoning"}),
                ({"similarity/turksen_zhong"}),
                preshape::component<TurksenZhong>(
                    "turksen_zhong", "One over one plus the mean Euclidean distance of the memberships"))
