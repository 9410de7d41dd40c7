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
  qh_freeqhull(&state, False);
  int blocks = 0, bytes = 0;
  qh_memfreeshort(&state, &blocks, &bytes);
  std::fclose(silent);
  return hull;
}

}  // namespace preshape::test
