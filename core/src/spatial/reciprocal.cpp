#include "preshape/spatial/reciprocal.h"

#include <cmath>
#include <utility>

namespace preshape {

namespace {

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Column-pivoted modified Gram-Schmidt, A P = Q R, stopped at the rank.
struct PivotedFactor {
  int rank = 0;
  int order[6] = {0, 1, 2, 3, 4, 5};                                  ///< order[k]: column of A at place k
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Zero();  ///< rank x 6, columns in pivot order

  PivotedFactor(Columns A, double tolerance) {
    double first = 0.0;
    for (int k = 0; k < 6; ++k) {
      int best = k;
      double best_norm = -1.0;
      for (int j = k; j < 6; ++j) {
        const double norm = A.col(j).squaredNorm();
        if (norm > best_norm) best = j, best_norm = norm;
      }
      const double pivot = std::sqrt(std::max(best_norm, 0.0));
      if (k == 0) first = pivot;
      if (pivot == 0.0 || pivot <= tolerance * first) return;
      if (best != k) {
        A.col(k).swap(A.col(best));
        R.col(k).swap(R.col(best));
        std::swap(order[k], order[best]);
      }
      R(k, k) = pivot;
      A.col(k) /= pivot;
      for (int j = k + 1; j < 6; ++j) {
        R(k, j) = A.col(k).dot(A.col(j));
        A.col(j) -= R(k, j) * A.col(k);
      }
      ++rank;
    }
  }
};

}  // namespace

int wrench_rank(const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, 6>>& wrench_union, double tolerance) {
  if (wrench_union.rows() == 0) return 0;
  return PivotedFactor(wrench_union, tolerance).rank;
}

std::vector<Twist> reciprocal_twists(
    const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, 6>>& wrench_union, double tolerance) {
  // A row (f, m) and a twist written (v, w) are reciprocal when f.v + m.w = 0, so the null space of the rows is
  // the reciprocal space in that order of writing.
  PivotedFactor factor(wrench_union.rows() > 0 ? Columns(wrench_union) : Columns::Zero(1, 6), tolerance);
  const int rank = factor.rank;
  std::vector<Eigen::Matrix<double, 6, 1>> basis;
  for (int free = rank; free < 6; ++free) {
    // R11 x = -R12(:, free), by back substitution.
    Eigen::Matrix<double, 6, 1> x = Eigen::Matrix<double, 6, 1>::Zero();
    x[free] = 1.0;
    for (int i = rank - 1; i >= 0; --i) {
      double sum = -factor.R(i, free);
      for (int j = i + 1; j < rank; ++j) sum -= factor.R(i, j) * x[j];
      x[i] = sum / factor.R(i, i);
    }
    Eigen::Matrix<double, 6, 1> twist;
    for (int k = 0; k < 6; ++k) twist[factor.order[k]] = x[k];
    for (const auto& other : basis) twist -= other.dot(twist) * other;
    basis.push_back(twist.normalized());
  }
  std::vector<Twist> twists;
  for (const auto& twist : basis) twists.emplace_back(twist.head<3>(), twist.tail<3>());
  return twists;
}

}  // namespace preshape
