#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Degree of subsethood [Kosko1986], compared in [YeungTsang1997]: for each component |q and w| / |q|, how
/// far the task's fuzzy vector q lies in the wrench's, with |.| the sum of the memberships and "and" their
/// minimum; summed over the six components. 0 .. 6, higher is nearer. Not symmetric. The empty vector lies in
/// every other.
class Subsethood final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite",     "additive",          "reflexive", "monotone", "inclusion",
            "permutation_invariant", "formula_subsethood"};
  }
  explicit Subsethood(const preshape::Parameters&) {}

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
    double common = 0.0, whole = 0.0, other = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      common += std::min(q[i], w[i]);
      whole += q[i];
      other += w[i];
    }
    if (!std::isfinite(whole + other)) {
      throw preshape::InputError("similarity 'subsethood': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return whole > 0.0 ? common / whole : 1.0;
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"subsethood", "1.0.0", "BSD-3-Clause", "the preshape developers", "Degree of subsethood"}),
                ({"similarity/subsethood"}),
                preshape::component<Subsethood>("subsethood",
                                                "How far the task's fuzzy vectors lie in the wrench's"))
