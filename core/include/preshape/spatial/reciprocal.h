#pragma once

#include <vector>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/spatial/twist.h"

namespace preshape {

/// Singular values below this share of the largest count as zero in ranks and null spaces. Lengths are
/// normalised before, else the share has no meaning.
inline constexpr double kRankTolerance = 1e-8;

/// Rank of a stack of wrenches, one a row: column-pivoted Gram-Schmidt.
/// @param wrench_union m x 6, any m >= 0
PRESHAPE_API int wrench_rank(const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, 6>>& wrench_union,
                             double tolerance = kRankTolerance);

/// Reciprocal twist space: a basis of all motions that no row of the wrench union can do work on (Konkar's
/// algorithm with a rank-revealing factorisation in place of the reduced echelon form; thesis sec. 3.7).
/// @returns 6 - rank unit twists about the wrenches' point
PRESHAPE_API std::vector<Twist> reciprocal_twists(
    const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, 6>>& wrench_union,
    double tolerance = kRankTolerance);

}  // namespace preshape
