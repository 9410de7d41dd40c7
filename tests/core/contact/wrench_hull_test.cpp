#include "preshape/contact/wrench_hull.h"

#include <cmath>

#include <Eigen/QR>

#include "support/cones.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/contact");

namespace {

/// A cube of half edge 1 with twelve contacts without friction: on the faces across x two that are d off along y and so
/// turn about z, and so on round the axes. Its wrenches are (force, moment) = (+-1, +-d) in three planes at right angles.
GraspWrenchSpace pushed_cube(double d, ForceBound bound) {
  WrenchBasis W = WrenchBasis::Zero(6, 12);
  Eigen::Index column = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      for (const double off : {d, -d}) {
        Eigen::Vector3d p = side * Eigen::Vector3d::Unit(axis), f = -p;
        p[(axis + 1) % 3] = off;
        W.col(column++) << f, p.cross(f);
      }
    }
  }
  return {W, 1, bound};
}

/// Two contacts at (-+r, 0, 0) that press on each other, with four edges of friction along y and z and a spin.
std::vector<PointContact> opposed(double r, double mu, double spin) {
  return {{{-r, 0, 0}, {1, 0, 0}, mu, spin}, {{r, 0, 0}, {-1, 0, 0}, mu, spin}};
}

/// With p = u_fy, q = r u_mz, w = u_fz, z = r u_my, m = u_mx the support of the opposed contacts is the larger of
///   u_fx + mu max(|p - q|, |w + z|, s |m|)   and   -u_fx + mu max(|p + q|, |w - z|, s |m|).
/// On the surface where it is 1 let these maxima be 1 - d and 1 + d over mu, so that u_fx = d. The farthest point has
/// max(|p|, |q|) = 1 / mu and min(|p|, |q|) = d / mu, likewise w and z, and |m| = (1 - d) / (mu s); |u| is convex in d, so
/// that it is largest at 0 or at 1.
double opposed_epsilon(double r, double mu, double spin) {
  const auto farthest = [&](double d) {
    const double pair = std::max(std::pow(1 / r, 2) + d * d, 1 + std::pow(d / r, 2)) / (mu * mu);
    return std::sqrt(d * d + 2 * pair + std::pow((1 - d) / (mu * spin), 2));
  };
  return 1.0 / std::max(farthest(0.0), farthest(1.0));
}

/// Of the cube's L1 space the support is max_i (|f_i| + d |m_i|), so on its unit surface each pair (f_i, m_i) is worst at
/// f_i = 1 or m_i = 1 / d.
double cube_fit(double d, const WrenchVector& half_axes, double along_x) {
  const auto square = [&](int i, bool force) { return std::pow(force ? half_axes[i] : half_axes[i == 0 ? 5 : i + 2] / d, 2); };
  const double others = std::max(square(1, true), square(1, false)) + std::max(square(2, true), square(2, false));
  return 1.0 / std::max(along_x + std::sqrt(square(0, true) + others), std::sqrt(square(0, false) + others));
}

}  // namespace

TEST_CASE("Epsilon: the cross-polytope has 1/sqrt(6), the regular simplex 1/6, the cube of independent forces 1") {
  WrenchBasis axes(6, 12);
  axes << WrenchBasis::Identity(6, 6), -WrenchBasis::Identity(6, 6);
  CHECK_NEAR(largest_ellipsoid({axes, 1, ForceBound::kSum}).factor, 1 / std::sqrt(6.0), 10 * kEps);
  CHECK_NEAR(largest_ellipsoid({axes, 1, ForceBound::kEach}).factor, 1.0, 10 * kEps);
  // The corners of a simplex: unit vectors in seven dimensions less their mean, in a basis of what is left.
  Eigen::Matrix<double, 7, 7> first = Eigen::Matrix<double, 7, 7>::Identity();
  first.col(0).setOnes();
  const Eigen::Matrix<double, 7, 7> Q = Eigen::HouseholderQR<Eigen::Matrix<double, 7, 7>>(first).householderQ();
  WrenchBasis corners = Q.rightCols<6>().transpose();
  corners.colwise().normalize();
  CHECK_NEAR(largest_ellipsoid({corners, 1, ForceBound::kSum}).factor, 1.0 / 6, 20 * kEps);
}

TEST_CASE("Epsilon: a cube pushed by twelve fingers d off its axes has min(d, 1)/sqrt(3), and 2d/sqrt(1 + d^2) when each has its own force") {
  for (const double d : {0.1, 0.5, 1.0}) {
    CHECK_NEAR(largest_ellipsoid(pushed_cube(d, ForceBound::kSum)).factor, d / std::sqrt(3.0), 20 * kEps);
    CHECK_NEAR(largest_ellipsoid(pushed_cube(d, ForceBound::kEach)).factor, 2 * d / std::sqrt(1 + d * d), 100 * kEps);
  }
}

TEST_CASE("Epsilon: two opposed soft fingers with four edges have their closed form, near and far, slippery and rough") {
  for (const double r : {0.2, 0.5, 1.5}) {
    for (const double mu : {0.2, 0.8}) {
      for (const double spin : {0.05, 0.3, 2.0}) {
        const auto fit = largest_ellipsoid(wrench_space(opposed(r, mu, spin), 4, ForceBound::kSum));
        CHECK(fit.spans);
        CHECK_NEAR(fit.factor, opposed_epsilon(r, mu, spin), 20 * kEps);
      }
    }
  }
}

TEST_CASE("Epsilon: fewer than six dimensions are said and give 0: two point contacts, three in a plane, none at all") {
  const auto flat = [](const GraspWrenchSpace& space) {
    const auto fit = largest_ellipsoid(space);
    return !fit.spans && fit.factor == 0.0;
  };
  for (const ForceBound bound : {ForceBound::kSum, ForceBound::kEach}) {
    CHECK(flat(wrench_space(opposed(0.5, 0.6, 0.0), 8, bound)));
    CHECK(flat(wrench_space({{{1, 0, 0}, {-1, 0, 0}, 0.0}, {{0, 1, 0}, {0, -1, 0}, 0.0}, {{-1, 0, 0}, {1, 0, 0}, 0.0}}, 8, bound)));
    CHECK(flat({WrenchBasis(6, 0), 1, bound}));
    CHECK(flat({WrenchBasis::Zero(6, 12), 1, bound}));
  }
}

TEST_CASE("Epsilon: contacts that all push from one side span the space and hold nothing") {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    std::vector<PointContact> contacts;
    for (int k = 0; k < 4; ++k) contacts.push_back({random_vector(random), {0, 0, 1}, 0.4});
    for (const ForceBound bound : {ForceBound::kSum, ForceBound::kEach}) {
      const auto fit = largest_ellipsoid(wrench_space(contacts, 6, bound));
      CHECK(fit.spans);
      CHECK(fit.factor == 0.0);
    }
  }
}

TEST_CASE("Task ellipsoid: in the pushed cube's space any axes and a centre along x have their closed form") {
  const double d = 0.5;
  const GraspWrenchSpace space = pushed_cube(d, ForceBound::kSum);
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    WrenchEllipsoid task;
    for (double& x : task.half_axes) x = random.uniform(0.0, 2.0);
    if (i % 4 == 1) task.half_axes[i % 6] = 0.0;
    task.centre[0] = i % 2 ? random.uniform(0.0, 3.0) : 0.0;
    CHECK_NEAR(largest_ellipsoid(space, task).factor, cube_fit(d, task.half_axes, task.centre[0]), 50 * kEps);
  }
}

TEST_CASE("Task ellipsoid: a single wrench fits as far as the space reaches, also where 0 is at its edge") {
  // Fingers below and at the sides: they bear weight but do not close the grasp.
  WrenchBasis W(6, 11);
  W << WrenchBasis::Identity(6, 6), -Eigen::Matrix<double, 6, 5>::Identity();
  WrenchEllipsoid task{WrenchVector::Unit(5), WrenchVector::Zero()};
  CHECK_NEAR(largest_ellipsoid({W, 1, ForceBound::kEach}, task).factor, 1.0, 10 * kEps);
  task.centre *= -1.0;
  CHECK(largest_ellipsoid({W, 1, ForceBound::kEach}, task).factor == 0.0);
  // |f_x| <= t / 4 about f_z' = t: t + t / 4 of the L1 bound.
  task = {WrenchVector::Unit(5), 0.25 * WrenchVector::Unit(0)};
  CHECK_NEAR(largest_ellipsoid({W, 1, ForceBound::kSum}, task).factor, 0.8, 10 * kEps);
}

TEST_SUITE_END();
