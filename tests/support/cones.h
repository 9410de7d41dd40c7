#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "preshape/contact/grasp_wrench_space.h"
#include "support/sample.h"

namespace preshape::test {

/// A point contact for tests of grasps: where, the inward normal, Coulomb's friction, and the ratio of torsional to
/// tangential friction (0: none).
struct PointContact {
  Eigen::Vector3d p_OC, n;
  double mu = 0.5, spin = 0.0;
};

/// Edges of the contact's cone about O, written out here and not by a contact model: `edges` round the normal (one along
/// it without friction) and two of spin where there is any.
inline WrenchBasis cone_edges(const PointContact& C, int edges) {
  const Eigen::Vector3d u = C.n.unitOrthogonal(), v = C.n.cross(u);
  const bool rough = C.mu > 0.0;
  WrenchBasis W((6), (rough ? edges : 1) + (C.spin > 0.0 ? 2 : 0));
  for (int k = 0; k < W.cols(); ++k) {
    const bool spins = rough && k >= edges;
    const double angle = 2.0 * std::numbers::pi * k / edges;
    Eigen::Vector3d force = C.n;
    if (rough && !spins) force += C.mu * (std::cos(angle) * u + std::sin(angle) * v);
    const Eigen::Vector3d spin = spins ? Eigen::Vector3d((k == edges ? 1.0 : -1.0) * C.mu * C.spin * C.n) : Eigen::Vector3d::Zero();
    W.col(k) << force, C.p_OC.cross(force) + spin;
  }
  return W;
}

/// The space of contacts that are all of one sort.
inline GraspWrenchSpace wrench_space(const std::vector<PointContact>& contacts, int edges, ForceBound bound) {
  WrenchBasis all(6, 0);
  Eigen::Index each = 1;
  for (const PointContact& C : contacts) {
    const WrenchBasis W = cone_edges(C, edges);
    each = W.cols();
    all.conservativeResize(6, all.cols() + each);
    all.rightCols(each) = W;
  }
  return {all, each, bound};
}

/// Contacts on a unit sphere whose normals point inwards but for a tilt.
inline std::vector<PointContact> random_grasp(Random& random, int count, double mu, double spin = 0.0) {
  std::vector<PointContact> contacts;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = random_unit(random);
    contacts.push_back({p, (-p + 0.4 * random_vector(random)).normalized(), mu, spin});
  }
  return contacts;
}

}  // namespace preshape::test
