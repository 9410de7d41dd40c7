#include <algorithm>
#include <cmath>
#include <string>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/fuzzy/additive_similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::ParameterDeclaration;
using preshape::PatternView;

/// Fuzzy Jaccard index: for each of the six components, with the fuzzy vectors q of the task and w of the wrench,
///   J(q, w) = sum_i min(q_i, w_i) / sum_i max(q_i, w_i),   1 where both are zero,
/// weighted by `translation` for the first three components and by `rotation` for the others, and summed. Higher is
/// nearer; a pattern is as near to itself as can be.
class @CLASS@ final : public preshape::AdditiveSimilarity {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("translation", 1.0, 0.01, 10.0, "1", "weight of the components Tx, Ty, Tz"),
            ParameterDeclaration::number("rotation", 1.0, 0.01, 10.0, "1", "weight of the components Rx, Ry, Rz")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric",  "additive",        "reflexive",
            "separating",    "metric",            "monotone",   "crisp_complement"};
  }

  explicit @CLASS@(const preshape::Parameters& p)
      : translation_(p.number("translation")), rotation_(p.number("rotation")) {}

  preshape::SimilarityScale scale(int) const noexcept override {
    double nearest = 0.0;  // summed as the scores are, so that a pattern reaches it exactly
    for (std::size_t k = 0; k < kComponents; ++k) nearest += weight(k);
    return {0.0, nearest};
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    preshape::require_size("sets of the pattern", static_cast<std::size_t>(task.sets), static_cast<std::size_t>(pattern.sets));
    const auto sets = static_cast<std::size_t>(task.sets);
    check("task", task);
    check("pattern", pattern);
    for (std::size_t k = 0; k < kComponents; ++k) {
      const double* q = task.memberships + k * sets;
      const double* w = pattern.memberships + k * sets;
      double common = 0.0, either = 0.0;
      for (std::size_t i = 0; i < sets; ++i) {
        common += std::min(q[i], w[i]);
        either += std::max(q[i], w[i]);
      }
      scores[k] = weight(k) * (either > 0.0 ? common / either : 1.0);
    }
  }

 private:
  double weight(std::size_t component) const { return component < 3 ? translation_ : rotation_; }

  static void check(const char* what, const PatternView& view) {
    const auto finite = [](double value) { return std::isfinite(value); };
    if (std::all_of(view.crisp, view.crisp + kComponents, finite) &&
        std::all_of(view.memberships, view.memberships + kComponents * view.sets, finite)) {
      return;
    }
    throw preshape::InputError(std::string(what) + ": components and memberships must be finite numbers");
  }

  double translation_, rotation_;
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Fuzzy Jaccard index"}),
                ({"similarity/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Weighted sum of fuzzy Jaccard indices over the components"))
