#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::PatternView;

/// Chen's matching function of vectors [Chen1988]: for each component q . w / max(q . q, w . w), with the
/// memberships for coordinates; summed over the six components. 0 .. 6, higher is nearer. Two vectors of
/// zeros are equal and count 1.
class ChenVector final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite",
            "symmetric",
            "additive",
            "reflexive",
            "separating",
            "crisp_complement",
            "permutation_invariant",
            "formula_chen_vector"};
  }
  explicit ChenVector(const preshape::Parameters&) {}

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
    double qw = 0.0, qq = 0.0, ww = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      qw += q[i] * w[i];
      qq += q[i] * q[i];
      ww += w[i] * w[i];
    }
    if (!std::isfinite(qq + ww)) {
      throw preshape::InputError("similarity 'chen_vector': component " + std::to_string(k + 1) +
                                 " has a membership that is not finite");
    }
    const double larger = std::max(qq, ww);
    return larger > 0.0 ? qw / larger : 1.0;
  }
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"chen_vector", "1.0.0", "BSD-3-Clause", "the preshape developers", "Chen's matching function"}),
    ({"similarity/chen_vector"}),
    preshape::component<ChenVector>("chen_vector",
                                    "Dot product of the memberships over that of the longer one with itself"))
