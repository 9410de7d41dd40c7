#include "preshape/contact/linear_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

#include "preshape/base/assert.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr double kZero = 1e-12;  ///< smallest cost that is followed; smallest pivot, as a share of its column
constexpr double kRounding = 1e-14;       ///< share of the largest right side that counts as 0
constexpr double kMissed = 1e-10;         ///< the same, by which a bound may be missed
constexpr Eigen::Index kRenewAfter = 30;  ///< pivots
constexpr Eigen::Index kNone = -1;

/// Rows: equations, inequalities, cost; columns: x, slacks, right side. The cost row is c - (its basic part).
class Tableau {
 public:
  explicit Tableau(const EquilibriumProgram& p)
      : equations_(p.E.rows()),
        rows_(p.E.rows() + p.A.rows()),
        unknowns_(p.c.size()),
        columns_(unknowns_ + p.A.rows()),
        T_(Table::Zero(rows_ + 1, columns_ + 1)),
        basic_(rows_, kNone) {
    T_.topLeftCorner(equations_, unknowns_) = p.E;
    T_.block(equations_, 0, p.A.rows(), unknowns_) = p.A;
    T_.block(equations_, unknowns_, p.A.rows(), p.A.rows()).setIdentity();
    T_.col(columns_).segment(equations_, p.A.rows()) = p.b;
    T_.row(rows_).head(unknowns_) = p.c.transpose();
    for (Eigen::Index i = equations_; i < rows_; ++i) basic_[i] = unknowns_ + i - equations_;
  }

  /// Gives every independent equation a basic unknown; their right sides are and stay 0. A dependent equation
  /// is left as zeros.
  void eliminate_equations() {
    if (equations_ == 0 || unknowns_ == 0) return;
    const double scale = T_.topLeftCorner(equations_, unknowns_).cwiseAbs().maxCoeff();
    for (Eigen::Index done = 0; done < equations_; ++done) {
      Eigen::Index row = kNone, column = kNone;
      double largest = kZero * scale;
      for (Eigen::Index i = 0; i < equations_; ++i) {
        if (basic_[i] != kNone) continue;
        Eigen::Index j;
        const double most = T_.row(i).head(unknowns_).cwiseAbs().maxCoeff(&j);
        if (most > largest) largest = most, row = i, column = j;
      }
      if (row == kNone) break;
      pivot(row, column);
    }
    for (Eigen::Index i = 0; i < equations_; ++i) {
      if (basic_[i] == kNone) T_.row(i).setZero();
    }
  }

  /// @returns whether there is a maximum
  bool maximise() {
    const Table first = T_;
    const Eigen::Index most = 200 * (rows_ + columns_);
    Eigen::Index stalled = 0, since_renewed = 0;
    for (Eigen::Index step = 0; step < most; ++step) {
      const bool careful = stalled > 2 * rows_;
      const Eigen::Index column = entering(careful), row = column == kNone ? kNone : leaving(column, careful);
      if (row == kNone || since_renewed == kRenewAfter) {
        if (since_renewed == 0 || (!renew(first) && row == kNone)) return column == kNone;
        since_renewed = 0;
        continue;
      }
      stalled = T_(row, columns_) > 0.0 ? 0 : stalled + 1;
      pivot(row, column);
      ++since_renewed;
    }
    throw InputError("linear programme: rounding keeps it from its end; use fewer edges (`resolution`)");
  }

  double value() const { return -T_(rows_, columns_); }
  Eigen::VectorXd x() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns_);
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (basic_[i] != kNone && basic_[i] < unknowns_) x[basic_[i]] = T_(i, columns_);
    }
    return x;
  }

 private:
  using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// The column of the largest cost; by Bland's rule the first.
  Eigen::Index entering(bool first) const {
    Eigen::Index column = kNone;
    double largest = kZero;
    for (Eigen::Index j = 0; j < columns_; ++j) {
      if (T_(rows_, j) <= largest) continue;
      column = j;
      if (first) break;
      largest = T_(rows_, j);
    }
    return column;
  }

  /// Of the rows that bound the column first, but for a rounding, that of the largest pivot, by Bland's rule
  /// of the first unknown.
  Eigen::Index leaving(Eigen::Index column, bool first) const {
    const auto entry = T_.col(column).head(rows_), right = T_.col(columns_).head(rows_);
    const double smallest = kZero * std::max(1.0, entry.cwiseAbs().maxCoeff());
    const double rounding = kRounding * right.maxCoeff();
    double step = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (basic_[i] != kNone && entry[i] > smallest) step = std::min(step, right[i] / entry[i]);
    }
    Eigen::Index row = kNone;
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (basic_[i] == kNone || entry[i] <= smallest || right[i] > step * entry[i] + rounding) continue;
      if (row == kNone || (first ? basic_[i] < basic_[row] : entry[i] > entry[row])) row = i;
    }
    return row;
  }

  /// The tableau of the present basis anew from the first one: small pivots on the way leave nothing behind.
  /// @returns false, with nothing changed, where the basis is so nearly singular that this would miss the
  /// bounds
  bool renew(const Table& first) {
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(rows_, rows_);
    Eigen::RowVectorXd cost = Eigen::RowVectorXd::Zero(rows_);
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (basic_[i] == kNone) continue;
      basis.col(i) = first.col(basic_[i]).head(rows_);
      cost[i] = first(rows_, basic_[i]);
    }
    const Eigen::MatrixXd inverse = basis.partialPivLu().inverse();
    const Eigen::VectorXd right = inverse * first.col(columns_).head(rows_);
    const double largest = first.col(columns_).head(rows_).maxCoeff();
    if (!(right.minCoeff() >= -kMissed * largest)) return false;
    T_.topRows(rows_) = inverse * first.topRows(rows_);
    T_.row(rows_) = first.row(rows_) - cost * T_.topRows(rows_);
    T_.col(columns_).head(rows_) = (right.array() > kRounding * largest).select(right, 0.0);
    for (Eigen::Index i = 0; i < rows_; ++i) {
      if (basic_[i] != kNone) T_.col(basic_[i]) = Eigen::VectorXd::Unit(rows_ + 1, i);
    }
    return true;
  }

  void pivot(Eigen::Index row, Eigen::Index column) {
    T_.row(row) /= T_(row, column);
    T_(row, column) = 1.0;
    for (Eigen::Index i = 0; i <= rows_; ++i) {
      const double factor = T_(i, column);
      if (i == row || factor == 0.0) continue;
      T_.row(i) -= factor * T_.row(row);
      T_(i, column) = 0.0;
      if (i < rows_ && T_(i, columns_) < 0.0) T_(i, columns_) = 0.0;  // by a rounding
    }
    basic_[row] = column;
  }

  Eigen::Index equations_, rows_, unknowns_, columns_;
  Table T_;
  std::vector<Eigen::Index> basic_;  ///< unknown of each row; none: a dependent equation
};

}  // namespace

EquilibriumOptimum maximise(const EquilibriumProgram& p) {
  PRESHAPE_DEMAND((p.E.rows() == 0 || p.E.cols() == p.c.size()) &&
                  (p.A.rows() == 0 || p.A.cols() == p.c.size()));
  PRESHAPE_DEMAND(p.b.size() == p.A.rows());
  if (!p.E.allFinite() || !p.A.allFinite() || !p.c.allFinite() || !p.b.allFinite() ||
      (p.b.array() < 0.0).any())
    throw InputError("linear programme: its coefficients must be finite numbers and its bounds not negative");
  Tableau tableau(p);
  tableau.eliminate_equations();
  if (!tableau.maximise()) return {false, 0.0, {}};
  return {true, tableau.value(), tableau.x()};
}

}  // namespace preshape
