#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Normalised Hamming distance of fuzzy sets [Kaufmann1975]: for each component the mean over the sets of
/// |q_i - w_i|; summed over the six components. 0 .. 6, lower is nearer.
class Hamming final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric",  "additive", "reflexive",        "separating",
            "monotone",          "continuous", "metric",   "crisp_complement", "permutation_invariant",
            "formula_hamming"};
  }
  explicit Hamming(const preshape::Parameters&) {}

  preshape::SimilarityScale scale(int) const noexcept override { return {kComponents, 0.0}; }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    const auto sets = static_cast<std::size_t>(task.sets);
    for (std::size_t k = 0; k < kComponents; ++k) {
      scores[k] = component(k, {task.memberships + k * sets, sets}, {pattern.memberships + k * sets, sets});
    }
  }

 private:
  static double component(std::size_t k, std::span<const double> q, std::span<const double> w) {
    double sum = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) sum += std::abs(q[i] - w[i]);
    if (!std::isfinite(sum)) {
      throw preshape::InputError("similarity 'hamming': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    return sum / static_cast<double>(q.size());
  }
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"hamming", "1.0.0", "BSD-3-Clause", "the preshape developers", "Hamming distance of the memberships"}),
    ({"similarity/hamming"}),
    preshape::component<Hamming>("hamming", "Mean difference of the memberships, summed over the components"))
