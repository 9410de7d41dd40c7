#pragma once

#include "preshape/contact/grasp_wrench_space.h"

namespace preshape::test {

/// Every vertex candidate of the space, sums of contacts enumerated; 0 among them.
inline WrenchBasis enumerated(const GraspWrenchSpace& space) {
  WrenchBasis points = WrenchBasis::Zero(6, 1);
  const Eigen::Index each = space.per_contact();
  for (Eigen::Index first = 0; first < space.primitives().cols(); first += each) {
    const Eigen::Index before = points.cols();
    if (space.bound() == ForceBound::kSum) {
      points.conservativeResize(6, before + each);
      points.rightCols(each) = space.primitives().middleCols(first, each);
      continue;
    }
    WrenchBasis sums(6, before * (each + 1));
    sums.leftCols(before) = points;
    for (Eigen::Index k = 0; k < each; ++k) {
      sums.middleCols((k + 1) * before, before) = points.colwise() + space.primitives().col(first + k);
    }
    points = std::move(sums);
  }
  return points;
}

}  // namespace preshape::test
