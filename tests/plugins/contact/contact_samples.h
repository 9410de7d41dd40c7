#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <Eigen/QR>

#include "preshape/contact/contact_limits.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

namespace preshape::test {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The normal along z, the approach along x and t along y, so that wrenches can be read off.
inline ContactFrame plain_contact() { return ContactFrame::at({0.3, -0.2, 0.1}, {0, 0, 1}, {1, 0, 0}); }

/// A frame whose approach axis is anywhere but along the normal.
inline ContactFrame random_contact(Random& random) {
  const Eigen::Vector3d p = random_vector(random), n = random_unit(random);
  Eigen::Vector3d a = random_unit(random);
  while (n.cross(a).norm() < 0.1) a = random_unit(random);
  return ContactFrame::at(p, n, a);
}

inline std::shared_ptr<ContactModel> contact_model(const char* name, const Value& given = Value::table({})) {
  return registry().create<ContactModel>(name, given);
}

inline WrenchBasis basis_of(const ContactModel& model, const ContactFrame& C) {
  WrenchBasis basis(6, model.basis_size());
  model.wrench_basis({&C, 1}, basis);
  return basis;
}

inline Wrench pattern_of(const ContactModel& model, const ContactFrame& C) {
  Wrench pattern;
  model.pattern_wrenches({&C, 1}, {&pattern, 1});
  return pattern;
}

inline WrenchBasis edges_of(const ContactModel& model, const ContactFrame& C, int resolution) {
  WrenchBasis edges(6, contact_limits(model)->primitive_count(resolution));
  contact_limits(model)->primitive_wrenches({&C, 1}, resolution, edges);
  return edges;
}

inline bool admits(const ContactModel& model, const ContactFrame& C, const Vector6& F) {
  return contact_limits(model)->admits(C, Wrench::from_vector(F), 1e-9);
}

inline Vector6 wrench(double fx, double fy, double fz, double mx, double my, double mz) {
  return (Vector6() << fx, fy, fz, mx, my, mz).finished();
}

/// The largest multiple of a load that the contact bears with a unit normal force, by bisection; at most 10.
inline double reach(const ContactModel& model, const ContactFrame& C, const Vector6& load) {
  const Vector6 normal = (Vector6() << C.n, Eigen::Vector3d::Zero()).finished();
  double within = 0.0, beyond = 10.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (within + beyond);
    (contact_limits(model)->admits(C, Wrench::from_vector(normal + middle * load), 1e-12) ? within : beyond) = middle;
  }
  return within;
}

/// Distance of a wrench from the cone of the edges, by Lawson and Hanson's active set: the edge that points most
/// along what is left comes in, edges whose weight would be negative go out.
inline double distance_from_cone(const WrenchBasis& edges, const Vector6& F) {
  std::vector<Eigen::Index> chosen;
  Eigen::VectorXd weights(0);
  Vector6 left = F;
  for (int turn = 0; turn < 200; ++turn) {
    Eigen::Index best = 0;
    if ((edges.transpose() * left).maxCoeff(&best) < 1e-12 || std::count(chosen.begin(), chosen.end(), best)) break;
    chosen.push_back(best);
    weights.conservativeResize(weights.size() + 1);
    weights[weights.size() - 1] = 0.0;
    while (true) {
      const Eigen::MatrixXd columns = edges(Eigen::all, chosen);
      const Eigen::VectorXd wanted = columns.colPivHouseholderQr().solve(F);
      double step = 1.0;
      Eigen::Index first = -1;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        const double until = weights[i] / (weights[i] - wanted[i]);
        if (wanted[i] < 0.0 && until < step) step = until, first = i;
      }
      weights += step * (wanted - weights);
      left = F - columns * weights;
      if (first < 0) break;
      chosen.erase(chosen.begin() + first);
      const Eigen::Index after = weights.size() - first - 1;
      weights.segment(first, after) = weights.tail(after).eval();
      weights.conservativeResize(weights.size() - 1);
    }
  }
  return left.norm();
}

/// The pattern wrench must be one that the contact bears, whatever the parameters and the frame.
inline void check_pattern_borne(const ContactModel& model, Random& random) {
  for (int i = 0; i < 50; ++i) {
    const ContactFrame C = random_contact(random);
    CHECK(admits(model, C, pattern_of(model, C).vector()));
  }
}

}  // namespace preshape::test
