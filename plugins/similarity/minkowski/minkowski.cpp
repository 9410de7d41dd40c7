#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Minkowski distance of the fuzzy vectors: for each component (sum_i |q_i - w_i|^p)^(1/p); summed over the
/// six components. Lower is nearer; at most sets^(1/p) a component. Order 2 is the thesis's total fuzzy
/// distance (eq. 3.9.5), order 1 the sum of the differences; a high order tells the largest one.
class Minkowski final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<preshape::ParameterDeclaration> parameters() {
    return {preshape::ParameterDeclaration::number("order", 3.0, 1.0, 100.0, "1",
                                                   "exponent p; 1 adds the differences, 2 is tfdist")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric",  "additive", "reflexive",        "separating",
            "monotone",          "continuous", "metric",   "crisp_complement", "permutation_invariant",
            "formula_minkowski"};
  }
  explicit Minkowski(const preshape::Parameters& p) : order_(p.number("order")) {}

  preshape::SimilarityScale scale(int sets) const noexcept override {
    return {kComponents * std::pow(sets, 1.0 / order_), 0.0};
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    const auto sets = static_cast<std::size_t>(task.sets);
    for (std::size_t k = 0; k < kComponents; ++k) {
      scores[k] = component(k, {task.memberships + k * sets, sets}, {pattern.memberships + k * sets, sets});
    }
  }

 private:
  double component(std::size_t k, std::span<const double> q, std::span<const double> w) const {
    double largest = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      sum += std::abs(q[i] - w[i]);
      largest = std::max(largest, std::abs(q[i] - w[i]));
    }
    if (!std::isfinite(sum)) {
      throw preshape::InputError("similarity 'minkowski': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    if (largest == 0.0) return 0.0;
    double powers = 0.0;  // of shares of the largest, so that none underflows to nothing
    for (std::size_t i = 0; i < q.size(); ++i) powers += std::pow(std::abs(q[i] - w[i]) / largest, order_);
    return largest * std::pow(powers, 1.0 / order_);
  }

  double order_;
};

}  // namespace

PRESHAPE_PLUGIN(({"minkowski", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Minkowski distance of the memberships"}),
                ({"similarity/minkowski"}),
                preshape::component<Minkowski>("minkowski",
                                               "Sum of Minkowski distances of the memberships, of any order"))
