#pragma once

#include <Eigen/Core>

#include "method.h"

namespace preshape::mlp {

/// Residuals e of rows and their derivatives J by the weights, such that J^T e is the loss's gradient and J^T J
/// its Gauss-Newton matrix. Squared: e = o - t. Cross entropy: both divided by sqrt(o (1 - o)), so that J has
/// the square root of the outputs' variance.
struct Linearised {
  Eigen::MatrixXd jacobian;  ///< rows x outputs, in that order, by the network's weights
  Eigen::VectorXd residuals;
};

/// @param first, count the rows; @param outputs theirs alone, overwritten
Linearised linearise(const Network& network, const Rows& rows, std::size_t first, std::size_t count,
                     Loss loss, std::span<float> outputs);

}  // namespace preshape::mlp
