#pragma once

#include <Eigen/Core>

#include "preshape/base/export.h"

namespace preshape {

/// A linear programme about equilibrium: x = 0, no force at all, is always feasible.
///   maximise c'x   subject to   E x = 0,  A x <= b,  x >= 0,   with b >= 0
struct EquilibriumProgram {
  Eigen::MatrixXd E;  ///< any rows, dependent ones too
  Eigen::MatrixXd A;
  Eigen::VectorXd b;  ///< >= 0
  Eigen::VectorXd c;
};

struct EquilibriumOptimum {
  bool bounded = true;  ///< else c'x has no maximum, and value and x say nothing
  double value = 0.0;
  Eigen::VectorXd x;
};

/// By the dense simplex method. As x = 0 is feasible there is no first phase: the equations are eliminated
/// with complete pivoting, which finds the dependent ones, then columns enter by the steepest cost, and by
/// Bland's rule while the programme stalls, so that it ends. The tableau is renewed from the first one now
/// and then and at the end, so that small pivots leave nothing behind. For programmes of some hundred columns
/// with coefficients near 1.
/// @throws InputError when a coefficient is not finite, or rounding keeps it from its end
/// @see [Dantzig1963; Bland1977]
PRESHAPE_API EquilibriumOptimum maximise(const EquilibriumProgram& programme);

}  // namespace preshape
