#include <cmath>
#include <numbers>

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
  if (!vector.allFinite()) throw preshape::InputError("similarity 'screw_angle': a component is not finite");
  return vector;
}

/// Angle [rad] between the weighted six-vectors (force f, moment m) of task and wrench in R^6: 0 .. pi, lower
/// is nearer. Without the moments it is the angle between the axes of the two screws, by Poinsot's theorem
/// [Ball1900]. A vector of no length is at a right angle to every vector but another of no length.
class ScrewAngle final : public preshape::Similarity {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {
        ParameterDeclaration::number("force", 1.0, 0.0, 1000.0, "1", "weight of the first three components"),
        ParameterDeclaration::number("moment", 1.0, 0.0, 1000.0, "1", "weight of the last three components")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "symmetric",          "reflexive", "metric",
            "scale_invariant",   "formula_screw_angle"};
  }

  explicit ScrewAngle(const preshape::Parameters& p) {
    const double force = p.number("force"), moment = p.number("moment");
    if (force == 0.0 && moment == 0.0) {
      throw preshape::InputError(
          "similarity 'screw_angle': force and moment are both 0, so nothing counts; make one larger");
    }
    weights_ << force, force, force, moment, moment, moment;
  }

  preshape::SimilarityScale scale(int) const noexcept override { return {std::numbers::pi, 0.0}; }

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
  /// The direction of the weighted vector, zero where it has none; of any length, however large or small.
  Vector direction(const Vector& v) const {
    const double largest = v.cwiseAbs().maxCoeff();
    if (largest == 0.0) return Vector::Zero();
    const Vector weighted = weights_.cwiseProduct(v / largest);
    return weighted.isZero(0.0) ? weighted : Vector(weighted.stableNormalized());
  }

  /// Half angles, which are as exact near 0 and pi as between.
  double score(const Vector& q, const Vector& w) const {
    const Vector u = direction(q), v = direction(w);
    return 2.0 * std::atan2((u - v).norm(), (u + v).norm());
  }

  Vector weights_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"screw_angle", "1.0.0", "BSD-3-Clause", "the preshape developers", "Angle between task and wrench"}),
    ({"similarity/screw_angle"}),
    preshape::component<ScrewAngle>("screw_angle",
                                    "Angle between the screws of task and wrench, parts weighted"))
