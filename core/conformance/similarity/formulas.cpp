#include "formulas.h"

#include <Eigen/Core>

namespace preshape::conformance {

namespace {

using Degrees = Eigen::Map<const Eigen::ArrayXd>;
using Crisp = Eigen::Map<const Eigen::Matrix<double, kComponents, 1>>;

Degrees degrees_of(const PatternView& pattern, int component) {
  return {pattern.memberships + component * pattern.sets, pattern.sets};
}

double tfvadi(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    const Degrees q = degrees_of(task, k), w = degrees_of(pattern, k);
    sum += std::min(q.min(w).maxCoeff(), 1.0 - q.max(w).minCoeff());
  }
  return sum;
}

double tfdist(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) sum += (degrees_of(task, k) - degrees_of(pattern, k)).matrix().norm();
  return sum;
}

double cosine(const PatternView& task, const PatternView& pattern) {
  const Crisp q(task.crisp), w(pattern.crisp);
  const double lengths = q.norm() * w.norm();
  return lengths > 0.0 ? 0.5 + 0.5 * q.dot(w) / lengths : 0.5;
}

constexpr Formula kFormulas[] = {
    {"formula_tfvadi", "thesis eq. 3.9.11", tfvadi},
    {"formula_tfdist", "thesis eq. 3.9.5", tfdist},
    {"formula_cosine", "(1 + cos) / 2", cosine},
};

}  // namespace

const Formula* formula_named(std::string_view capability) {
  for (const Formula& formula : kFormulas) {
    if (formula.capability == capability) return &formula;
  }
  return nullptr;
}

}  // namespace preshape::conformance
