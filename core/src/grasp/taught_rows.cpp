#include "preshape/grasp/taught_rows.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape {

namespace {

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

/// Places of the sorted rows whose inputs are not among other sorted rows'.
std::vector<Eigen::Index> not_among(const RowMatrix& rows, const RowMatrix& others) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0, j = 0; i < rows.rows(); ++i) {
    const double* row = rows.row(i).data();
    while (j < others.rows() && row_less(others.row(j).data(), row, rows.cols())) ++j;
    const bool again = j < others.rows() && !row_less(row, others.row(j).data(), rows.cols());
    if (!again) kept.push_back(i);
  }
  return kept;
}

}  // namespace

void check_lesson(std::string_view classifier, const RowsView& inputs, const RowsView& targets) {
  if (inputs.rows() < 1) throw InputError(fmt::format("classifier '{}': there are no rows to learn; give at least one", classifier));
  if (inputs.rows() != targets.rows() || inputs.cols() < 1 || targets.cols() < 1) {
    throw InputError(fmt::format("classifier '{}': {} x {} inputs do not go with {} x {} targets; give one row of targets to each row of inputs",
                                 classifier, inputs.rows(), inputs.cols(), targets.rows(), targets.cols()));
  }
  for (Eigen::Index r = 0; r < targets.rows(); ++r) {
    for (Eigen::Index k = 0; k < targets.cols(); ++k) {
      if (targets(r, k) == 0.0 || targets(r, k) == 1.0) continue;
      throw InputError(fmt::format("classifier '{}': target {} of row {} must be 0 or 1, got {}", classifier, k + 1, r + 1,
                                   number_text(targets(r, k))));
    }
  }
}

void check_finite_rows(std::string_view classifier, const RowsView& inputs) {
  for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
    if (inputs.row(r).allFinite()) continue;
    throw InputError(fmt::format("classifier '{}': row {} holds a number that is not finite", classifier, r + 1));
  }
}

TaughtRows::TaughtRows(std::string_view classifier, const RowsView& inputs, const RowsView& targets) {
  check_lesson(classifier, inputs, targets);
  check_finite_rows(classifier, inputs);
  const RowMatrix plain = inputs.array() + 0.0, codes = targets.array() + 0.0;  // no negative zeros
  const auto order = order_of(plain, codes);
  inputs_ = plain(order, Eigen::all);
  targets_ = codes(order, Eigen::all);
}

TaughtRows TaughtRows::with(std::string_view classifier, const RowsView& inputs, const RowsView& targets, Again again) const {
  const TaughtRows fresh(classifier, inputs, targets);
  if (empty()) return fresh;
  if (inputs.cols() != inputs_.cols() || targets.cols() != targets_.cols()) {
    throw InputError(fmt::format("classifier '{}' knows rows of {} inputs and {} bits, and cannot learn {} inputs and {} bits beside them; fit it anew",
                                 classifier, inputs_.cols(), targets_.cols(), inputs.cols(), targets.cols()));
  }
  std::vector<Eigen::Index> kept;
  if (again == Again::kLast) {
    kept = not_among(inputs_, fresh.inputs_);
  } else {
    kept.resize(static_cast<std::size_t>(inputs_.rows()));
    std::iota(kept.begin(), kept.end(), Eigen::Index{0});
  }
  RowMatrix all(std::ssize(kept) + fresh.inputs_.rows(), inputs_.cols()), codes(all.rows(), targets_.cols());
  all << inputs_(kept, Eigen::all), fresh.inputs_;
  codes << targets_(kept, Eigen::all), fresh.targets_;
  return {classifier, all, codes};
}

}  // namespace preshape
