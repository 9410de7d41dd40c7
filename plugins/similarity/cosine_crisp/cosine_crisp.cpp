#include <algorithm>
#include <cmath>

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
  if (!vector.allFinite()) throw preshape::InputError("similarity 'cosine_crisp': a component is not finite");
  return vector;
}

/// The direction of a vector, zero where it has none; of any length, however large or small.
Vector direction(const Vector& v) {
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0.0 ? Vector((v / largest).normalized()) : Vector(Vector::Zero());
}

/// Cosine of the angle between the crisp vectors of task and wrench, mapped to 0 .. 1: ((1 + cos) /
/// 2)^sharpness. Higher is nearer. A zero vector is at a right angle to every vector, itself too. The
/// component `cosine` in Lua computes the same.
class CosineCrisp final : public preshape::Similarity {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number(
        "sharpness", 1.0, 0.01, 100.0, "1",
        "power of the mapped cosine; above 1 it tells small angles better apart")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric", "permutation_invariant", "scale_invariant", "formula_cosine"};
  }

  explicit CosineCrisp(const preshape::Parameters& p) : sharpness_(p.number("sharpness")) {}

  preshape::SimilarityScale scale(int) const noexcept override { return {0.0, 1.0}; }

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
    const double cosine = std::clamp(direction(q).dot(direction(w)), -1.0, 1.0);
    return std::pow(0.5 + 0.5 * cosine, sharpness_);
  }

  double sharpness_;
};

}  // namespace

PRESHAPE_PLUGIN(({"cosine_crisp", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Cosine of the crisp vectors"}),
                ({"similarity/cosine_crisp"}),
                preshape::component<CosineCrisp>("cosine_crisp",
                                                 "Cosine of the angle between task and wrench, as numbers"))
