#include "formulas.h"

#include <cmath>
#include <numbers>

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

double jaccard(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    const Degrees q = degrees_of(task, k), w = degrees_of(pattern, k);
    const double either = q.max(w).sum();
    sum += either > 0.0 ? q.min(w).sum() / either : 1.0;
  }
  return sum;
}

/// From the differences: |q| + |w| - sum |q - w| is twice what they have in common.
double dice(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    const Degrees q = degrees_of(task, k), w = degrees_of(pattern, k);
    const double both = q.sum() + w.sum();
    sum += both > 0.0 ? 1.0 - (q - w).abs().sum() / both : 1.0;
  }
  return sum;
}

double hamming(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) sum += (degrees_of(task, k) - degrees_of(pattern, k)).abs().mean();
  return sum;
}

double minkowski(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) sum += std::cbrt((degrees_of(task, k) - degrees_of(pattern, k)).abs().cube().sum());
  return sum;
}

double turksen_zhong(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    sum += 1.0 / (1.0 + std::sqrt((degrees_of(task, k) - degrees_of(pattern, k)).square().mean()));
  }
  return sum;
}

/// From the difference: |q|^2 + |w|^2 - |q - w|^2 is twice the dot product.
double chen_vector(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    const Degrees q = degrees_of(task, k), w = degrees_of(pattern, k);
    const double qq = q.square().sum(), ww = w.square().sum();
    const double longer = std::max(qq, ww);
    sum += longer > 0.0 ? (qq + ww - (q - w).square().sum()) / (2.0 * longer) : 1.0;
  }
  return sum;
}

/// From what sticks out of the pattern.
double subsethood(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) {
    const Degrees q = degrees_of(task, k), w = degrees_of(pattern, k);
    sum += q.sum() > 0.0 ? 1.0 - (q - w).max(0.0).sum() / q.sum() : 1.0;
  }
  return sum;
}

double largest_difference(const PatternView& task, const PatternView& pattern) {
  double sum = 0.0;
  for (int k = 0; k < kComponents; ++k) sum += (1.0 - (degrees_of(task, k) - degrees_of(pattern, k)).abs()).minCoeff();
  return sum;
}

/// By the exterior product, whose length is |q| |w| sin (Lagrange's identity): exact at every angle.
double screw_angle(const PatternView& task, const PatternView& pattern) {
  const Crisp q(task.crisp), w(pattern.crisp);
  if (q.isZero(0.0) || w.isZero(0.0)) return q.isZero(0.0) && w.isZero(0.0) ? 0.0 : std::numbers::pi / 2.0;
  double squares = 0.0;
  for (int i = 0; i < kComponents; ++i) {
    for (int j = 0; j < i; ++j) squares += std::pow(q[i] * w[j] - q[j] * w[i], 2);
  }
  return std::atan2(std::sqrt(squares), q.dot(w));
}

double task_distance(const PatternView& task, const PatternView& pattern) {
  return 1.0 - 1.0 / (1.0 + (Crisp(task.crisp) - Crisp(pattern.crisp)).norm());
}

constexpr Formula kFormulas[] = {
    {"formula_tfvadi", "thesis eq. 3.9.11", tfvadi},
    {"formula_tfdist", "thesis eq. 3.9.5", tfdist},
    {"formula_cosine", "(1 + cos) / 2", cosine},
    {"formula_jaccard", "thesis eq. 3.9.1", jaccard},
    {"formula_dice", "2 |q and w| / (|q| + |w|)", dice},
    {"formula_hamming", "the mean of |q - w|", hamming},
    {"formula_minkowski", "the cube root of the sum of |q - w|^3", minkowski},
    {"formula_turksen_zhong", "1 / (1 + D)", turksen_zhong},
    {"formula_chen_vector", "q . w / max(q . q, w . w)", chen_vector},
    {"formula_subsethood", "|q and w| / |q|", subsethood},
    {"formula_largest_difference", "1 - max |q - w|", largest_difference},
    {"formula_screw_angle", "the angle in six dimensions", screw_angle},
    {"formula_task_distance", "d / (1 + d)", task_distance},
};

}  // namespace

const Formula* formula_named(std::string_view capability) {
  for (const Formula& formula : kFormulas) {
    if (formula.capability == capability) return &formula;
  }
  return nullptr;
}

}  // namespace preshape::conformance
