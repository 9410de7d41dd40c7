#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::kComponents;
using preshape::ParameterDeclaration;
using preshape::PatternView;
using Vector = Eigen::Matrix<double, kComponents, 1>;

/// The numbers of a pattern.
Vector crisp(const PatternView& pattern) {
  const Vector vector = Eigen::Map<const Vector>(pattern.crisp);
  if (!vector.allFinite())
    throw preshape::InputError("similarity 'task_distance': a component is not finite");
  return vector;
}

/// Weighted Euclidean distance d of the crisp vectors of task and wrench, d^2 = sum_k (c_k (q_k - w_k))^2,
/// brought to a bounded scale by d / (half + d): 0 .. 1, lower is nearer, 1/2 at d = half. The map is
/// increasing and concave: it keeps the order and the triangle inequality, and unlike a saturation makes no
/// two distances equal.
class TaskDistance final : public preshape::Similarity {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::list("weights", {1, 1, 1, 1, 1, 1}, 0.0, 1000.0, "1",
                                       "of the six components, in their order Tx Ty Tz Rx Ry Rz"),
            ParameterDeclaration::number("half", 1.0, 1e-6, 1e6, "1", "distance that scores one half")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric", "reflexive", "continuous", "metric", "formula_task_distance"};
  }

  explicit TaskDistance(const preshape::Parameters& p) : half_(p.number("half")) {
    const auto weights = p.numbers("weights");
    preshape::require_size("similarity 'task_distance', weights", kComponents, weights.size());
    weights_ = Eigen::Map<const Vector>(weights.data());
  }

  preshape::SimilarityScale scale(int) const noexcept override { return {1.0, 0.0}; }

  void compare(const PatternView& task, const PatternView& patterns,
               std::span<double> scores) const override {
    preshape::require_size("scores", static_cast<std::size_t>(patterns.count), scores.size());
    const Vector q = crisp(task);
    for (int i = 0; i < patterns.count; ++i)
      scores[static_cast<std::size_t>(i)] = score(q, crisp(patterns[i]));
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    const Vector q = crisp(task), w = crisp(pattern);
    for (int k = 0; k < kComponents; ++k) {
      scores[static_cast<std::size_t>(k)] = score(Vector::Unit(k) * q[k], Vector::Unit(k) * w[k]);
    }
  }

 private:
  double score(const Vector& q, const Vector& w) const {
    const double d = weights_.cwiseProduct(q - w).stableNorm();
    return d < std::numeric_limits<double>::max() ? d / (half_ + d) : 1.0;
  }

  Vector weights_;
  double half_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"task_distance", "1.0.0", "BSD-3-Clause", "the preshape developers", "Distance of the crisp vectors"}),
    ({"similarity/task_distance"}),
    preshape::component<TaskDistance>("task_distance",
                                      "Weighted Euclidean distance of task and wrench, as numbers"))
