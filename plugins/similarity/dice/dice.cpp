#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Dice's coefficient [Dice1945] with memberships for elements: for each component 2 |q and w| / (|q| + |w|),
/// with |.| the sum of the memberships and "and" their minimum; summed over the six components. 0 .. 6,
/// higher is nearer. Two empty fuzzy vectors are equal and count 1.
class Dice final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric", "additive",         "reflexive",
            "separating",        "monotone",  "crisp_complement", "permutation_invariant",
            "formula_dice"};
  }
  explicit Dice(const preshape::Parameters&) {}

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
      throw preshape::InputError("similarity 'dice': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return both > 0.0 ? 2.0 * common / both : 1.0;
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"dice", "1.0.0", "BSD-3-Clause", "the preshape developers", "Dice's coefficient"}),
                ({"similarity/dice"}),
                preshape::component<Dice>("dice", "Twice the common memberships over all of both patterns"))
