#include "lesson.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape::knn {

namespace {

/// A range below this share of the feature's largest number is its rounding.
constexpr double kLeastRange = 1e-12;

std::string size_text(const Rows& rows) {
  return std::to_string(rows.rows()) + " x " + std::to_string(rows.cols());
}

void check_rows(const Rows& inputs, const Rows& targets) {
  if (inputs.rows() < 1) throw InputError("classifier 'knn': there are no rows to learn; give at least one");
  if (inputs.rows() != targets.rows() || inputs.cols() < 1 || targets.cols() < 1) {
    throw InputError("classifier 'knn': " + size_text(inputs) + " inputs do not go with " +
                     size_text(targets) + " targets; give one row of targets to each row of inputs");
  }
  check_finite(inputs);
  for (Eigen::Index r = 0; r < targets.rows(); ++r) {
    for (Eigen::Index k = 0; k < targets.cols(); ++k) {
      if (targets(r, k) == 0.0 || targets(r, k) == 1.0) continue;
      throw InputError("classifier 'knn': target " + std::to_string(k + 1) + " of row " +
                       std::to_string(r + 1) + " must be 0 or 1, got " + number_text(targets(r, k)));
    }
  }
}

/// The rows' places in the order of their inputs, then their targets, each row once.
std::vector<Eigen::Index> order_of(const RowMatrix& inputs, const RowMatrix& targets) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(inputs.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto row_less = [](const RowMatrix& m, Eigen::Index a, Eigen::Index b) {
    const double *x = m.row(a).data(), *y = m.row(b).data();
    return std::lexicographical_compare(x, x + m.cols(), y, y + m.cols());
  };
  const auto less = [&](Eigen::Index a, Eigen::Index b) {
    return row_less(inputs, a, b) || (!row_less(inputs, b, a) && row_less(targets, a, b));
  };
  std::sort(order.begin(), order.end(), less);
  const auto same = [&](Eigen::Index a, Eigen::Index b) { return !less(a, b) && !less(b, a); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  return order;
}

double scale_of(const Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>& feature) {
  const double highest = feature.maxCoeff(), lowest = feature.minCoeff(), scale = 1.0 / (highest - lowest);
  const bool constant = highest - lowest <= kLeastRange * std::max(std::abs(highest), std::abs(lowest));
  return constant || !std::isnormal(scale) ? 0.0 : scale;
}

}  // namespace

void check_finite(const Rows& inputs) {
  for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
    if (inputs.row(r).allFinite()) continue;
    throw InputError("classifier 'knn': row " + std::to_string(r + 1) + " holds a number that is not finite");
  }
}

Lesson::Lesson(const Rows& inputs, const Rows& targets) {
  check_rows(inputs, targets);
  const RowMatrix plain = inputs.array() + 0.0, codes = targets.array() + 0.0;  // no negative zeros
  const auto order = order_of(plain, codes);
  inputs_ = plain(order, Eigen::all);
  targets_ = codes(order, Eigen::all);
  for (Eigen::Index j = 0; j < inputs_.cols(); ++j) scales_.push_back(scale_of(inputs_.col(j)));
}

Lesson Lesson::with(const Rows& inputs, const Rows& targets) const {
  if (empty()) return Lesson(inputs, targets);
  check_rows(inputs, targets);
  if (inputs.cols() != inputs_.cols() || targets.cols() != targets_.cols()) {
    throw InputError("classifier 'knn' knows rows of " + std::to_string(inputs_.cols()) + " inputs and " +
                     std::to_string(targets_.cols()) + " bits, and cannot learn " +
                     std::to_string(inputs.cols()) + " inputs and " + std::to_string(targets.cols()) +
                     " bits beside them; fit it anew");
  }
  RowMatrix all(inputs_.rows() + inputs.rows(), inputs_.cols()), codes(all.rows(), targets_.cols());
  all << inputs_, inputs;
  codes << targets_, targets;
  return Lesson(all, codes);
}

std::span<const Neighbour> Lesson::nearest(const double* question, std::size_t count,
                                           Neighbours& room) const {
  std::size_t found = 0;
  for (Eigen::Index i = 0; i < inputs_.rows(); ++i) {
    const double* row = inputs_.row(i).data();
    double squares = 0.0;
    for (std::size_t j = 0; j < scales_.size(); ++j) {
      if (scales_[j] == 0.0) continue;
      const double d = (row[j] - question[j]) * scales_[j];
      squares += d * d;
    }
    if (!(squares <= std::numeric_limits<double>::max())) squares = std::numeric_limits<double>::max();
    if (found == count && squares >= room[found - 1].squares) continue;
    // Insertion: the rows are met in their order, so of equally near ones the first stays before.
    std::size_t place = found < count ? found++ : found - 1;
    for (; place > 0 && room[place - 1].squares > squares; --place) room[place] = room[place - 1];
    room[place] = {squares, i};
  }
  return std::span(room).first(found);
}

}  // namespace preshape::knn
