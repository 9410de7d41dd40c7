#include <algorithm>

#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Total fuzzy vector approaching degree index (thesis eq. 3.9.7 to 3.9.11): for each component the inner product
/// max_i min(q_i, w_i) and the complement of the outer product, 1 - min_i max(q_i, w_i); the smaller of the two;
/// summed over the six components. 0 .. 6, higher is nearer. A fuzzy vector's index with itself is its own height,
/// which is below 1 between two sets.
class Tfvadi final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() { return {"symmetric", "additive", "monotone", "continuous", "crisp_complement", "permutation_invariant",
            "formula_tfvadi"}; }
  explicit Tfvadi(const preshape::Parameters&) {}

  preshape::SimilarityScale scale(int) const noexcept override { return {0.0, kComponents}; }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    for (std::size_t k = 0; k < kComponents; ++k) {
      const double* q = task.memberships + k * static_cast<std::size_t>(task.sets);
      const double* w = pattern.memberships + k * static_cast<std::size_t>(task.sets);
      double inner = 0.0, outer = 1.0;
      for (int i = 0; i < task.sets; ++i) {
        inner = std::max(inner, std::min(q[i], w[i]));
        outer = std::min(outer, std::max(q[i], w[i]));
      }
      scores[k] = std::min(inner, 1.0 - outer);
    }
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"tfvadi", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Total fuzzy vector approaching degree index"}),
                ({"similarity/tfvadi"}),
                preshape::component<Tfvadi>("tfvadi", "Sum of approaching degrees over the components (thesis eq. 3.9.11)"))
