#include "lesson.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape::nadaraya_watson {

namespace {

std::string size_text(const Matrix& rows) {
  return std::to_string(rows.rows()) + " x " + std::to_string(rows.cols());
}

void check_rows(const Matrix& inputs, const Matrix& targets) {
  if (inputs.rows() < 1) {
    throw InputError("classifier 'nadaraya_watson': there are no rows to learn; give at least one");
  }
  if (inputs.rows() != targets.rows() || inputs.cols() < 1 || targets.cols() < 1) {
    throw InputError("classifier 'nadaraya_watson': " + size_text(inputs) + " inputs do not go with " +
                     size_text(targets) + " targets; give one row of targets to each row of inputs");
  }
  check_finite(inputs);
  for (Eigen::Index r = 0; r < targets.rows(); ++r) {
    for (Eigen::Index k = 0; k < targets.cols(); ++k) {
      if (targets(r, k) == 0.0 || targets(r, k) == 1.0) continue;
      throw InputError("classifier 'nadaraya_watson': target " + std::to_string(k + 1) + " of row " +
                       std::to_string(r + 1) + " must be 0 or 1, got " + number_text(targets(r, k)));
    }
  }
}

bool row_less(const double* a, const double* b, Eigen::Index width) {
  return std::lexicographical_compare(a, a + width, b, b + width);
}

/// The rows' places in the order of their inputs, then their targets, each row once.
std::vector<Eigen::Index> order_of(const RowMatrix& inputs, const RowMatrix& targets) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(inputs.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto by = [](const RowMatrix& m, Eigen::Index a, Eigen::Index b) {
    return row_less(m.row(a).data(), m.row(b).data(), m.cols());
  };
  const auto less = [&](Eigen::Index a, Eigen::Index b) {
    return by(inputs, a, b) || (!by(inputs, b, a) && by(targets, a, b));
  };
  std::sort(order.begin(), order.end(), less);
  const auto same = [&](Eigen::Index a, Eigen::Index b) { return !less(a, b) && !less(b, a); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  return order;
}

}  // namespace

void check_finite(const Matrix& inputs) {
  for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
    if (inputs.row(r).allFinite()) continue;
    throw InputError("classifier 'nadaraya_watson': row " + std::to_string(r + 1) +
                     " holds a number that is not finite");
  }
}

Lesson::Lesson(const Matrix& inputs, const Matrix& targets) {
  check_rows(inputs, targets);
  const RowMatrix plain = inputs.array() + 0.0, codes = targets.array() + 0.0;  // no negative zeros
  const auto order = order_of(plain, codes);
  inputs_ = plain(order, Eigen::all);
  targets_ = codes(order, Eigen::all);
}

Lesson Lesson::with(const Matrix& inputs, const Matrix& targets) const {
  const Lesson fresh(inputs, targets);
  if (empty()) return fresh;
  if (inputs.cols() != inputs_.cols() || targets.cols() != targets_.cols()) {
    throw InputError("classifier 'nadaraya_watson' knows rows of " + std::to_string(inputs_.cols()) + " inputs and " +
                     std::to_string(targets_.cols()) + " bits, and cannot learn " +
                     std::to_string(inputs.cols()) + " inputs and " + std::to_string(targets.cols()) +
                     " bits beside them; fit it anew");
  }
  const Eigen::Index width = inputs_.cols();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0, j = 0; i < inputs_.rows(); ++i) {
    const double* row = inputs_.row(i).data();
    while (j < fresh.inputs_.rows() && row_less(fresh.inputs_.row(j).data(), row, width)) ++j;
    const bool again = j < fresh.inputs_.rows() && !row_less(row, fresh.inputs_.row(j).data(), width);
    if (!again) kept.push_back(i);
  }
  RowMatrix all(static_cast<Eigen::Index>(kept.size()) + fresh.inputs_.rows(), width),
      codes(all.rows(), targets_.cols());
  all << inputs_(kept, Eigen::all), fresh.inputs_;
  codes << targets_(kept, Eigen::all), fresh.targets_;
  return Lesson(all, codes);
}

}  // namespace preshape::nadaraya_watson
