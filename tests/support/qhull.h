#pragma once

#include <cstdio>
#include <vector>

#include <Eigen/Core>

#include "preshape/contact/grasp_wrench_space.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace preshape::test {

/// A convex hull in six dimensions by Qhull, the independent method.
struct Hull {
  bool made = false;  ///< false: the points span fewer dimensions
  std::vector<WrenchVector> normals;
  std::vector<double> offsets;  ///< n.x = offset on the facet
  double volume = 0.0;
};

/// @param points 6 x n
inline Hull qhull(const WrenchBasis& points, bool with_volume = false) {
  qhT state;
  qh_zero(&state, stderr);
  std::FILE* silent = std::tmpfile();
  WrenchBasis copy = points;
  char options[] = "qhull";
  Hull hull;
  hull.made = qh_new_qhull(&state, 6, static_cast<int>(points.cols()), copy.data(), False, options, nullptr, silent) == 0;
  if (hull.made) {
    qhT* qh = &state;
    facetT* facet;
    FORALLfacets {
      hull.normals.push_back(Eigen::Map<const WrenchVector>(facet->normal));
      hull.offsets.push_back(-facet->offset);
    }
    if (with_volume) {
      qh_getarea(qh, qh->facet_list);
      hull.volume = qh->totvol;
    }
  }
  qh_freeqhull(&state, True);
  std::fclose(silent);
  return hull;
}

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
