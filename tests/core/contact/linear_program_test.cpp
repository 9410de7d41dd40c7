#include "preshape/contact/linear_program.h"

#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "preshape/base/error.h"
#include "support/cones.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/contact");

namespace {

EquilibriumProgram random_program(Random& random, Eigen::Index equations, Eigen::Index unknowns, Eigen::Index bounds) {
  EquilibriumProgram p;
  const auto fill = [&](auto& m, double low) {
    for (double& x : m.reshaped()) x = random.uniform(low, 1.0);
  };
  p.E.resize(equations, unknowns), p.A.resize(bounds, unknowns), p.b.resize(bounds), p.c.resize(unknowns);
  fill(p.E, -1.0), fill(p.A, -0.5), fill(p.b, 0.0), fill(p.c, -1.0);
  p.A.row(0).setOnes();  // so that there is a maximum
  return p;
}

/// How evenly the wrenches of a ring of contacts that is `off` from symmetric can balance: the last unknown adds to all.
EquilibriumProgram ring_program(Random& random, int count, double off) {
  std::vector<PointContact> contacts;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back({p + off * random_vector(random), -p, 0.6});
  }
  const WrenchBasis G = wrench_space(contacts, 8, ForceBound::kSum).primitives();
  EquilibriumProgram p{Eigen::MatrixXd(6, G.cols() + 1), Eigen::RowVectorXd::Ones(G.cols() + 1), Eigen::VectorXd::Ones(1), {}};
  p.E << G, G.rowwise().sum();
  p.A(0, G.cols()) = static_cast<double>(G.cols());
  p.c = p.A(0, G.cols()) * Eigen::VectorXd::Unit(G.cols() + 1, G.cols());
  return p;
}

/// The weight along z that such a ring holds, limited by three joints a contact; the forces themselves nearly free.
EquilibriumProgram weight_program(Random& random, int count, double off) {
  EquilibriumProgram p = ring_program(random, count, off);
  const Eigen::Index wrenches = p.E.cols() - 1;
  p.E.col(wrenches) = -WrenchVector::Unit(2);
  p.c = Eigen::VectorXd::Unit(wrenches + 1, wrenches);
  p.A = Eigen::MatrixXd::Zero(7 * count, wrenches + 1);
  p.b = Eigen::VectorXd::Constant(7 * count, 1e6);
  for (int i = 0; i < count; ++i) p.A.row(i).segment(8 * i, 8).setOnes();
  for (int j = 0; j < 3 * count; ++j) {
    const Eigen::Index contact = j % count, row = count + 2 * j;
    const Eigen::RowVectorXd torques = 0.1 * random_wrench(random).vector().transpose() * p.E.middleCols(8 * contact, 8);
    p.A.row(row).segment(8 * contact, 8) = torques;
    p.A.row(row + 1).segment(8 * contact, 8) = -torques;
    p.b.segment(row, 2).setConstant(random.uniform(0.1, 1.0));
  }
  return p;
}

/// The best of all basic solutions: every choice of as many columns as rows.
double by_enumeration(const EquilibriumProgram& p) {
  const Eigen::Index m = p.E.rows() + p.A.rows(), n = p.c.size() + p.A.rows();
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(m, n);
  T.topLeftCorner(p.E.rows(), p.c.size()) = p.E;
  T.bottomLeftCorner(p.A.rows(), p.c.size()) = p.A;
  T.bottomRightCorner(p.A.rows(), p.A.rows()).setIdentity();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(m), cost = Eigen::VectorXd::Zero(n);
  right.tail(p.A.rows()) = p.b;
  cost.head(p.c.size()) = p.c;
  double best = -std::numeric_limits<double>::infinity();
  for (unsigned chosen = 0; chosen < 1u << n; ++chosen) {
    if (std::popcount(chosen) != static_cast<int>(m)) continue;
    Eigen::MatrixXd basis(m, m);
    Eigen::VectorXd basic_cost(m);
    for (Eigen::Index j = 0, k = 0; j < n; ++j) {
      if (chosen >> j & 1u) basis.col(k) = T.col(j), basic_cost[k++] = cost[j];
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> factor(basis);
    if (!factor.isInvertible()) continue;
    const Eigen::VectorXd x = factor.solve(right);
    if (x.minCoeff() > -1e-10) best = std::max(best, basic_cost.dot(x));
  }
  return best;
}

}  // namespace

TEST_CASE("Linear programme: the maximum of small ones is that of all their basic solutions, and its point is feasible") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const EquilibriumProgram p = random_program(random, i % 3, 6, 1 + i % 4);
    const EquilibriumOptimum found = maximise(p);
    REQUIRE(found.bounded);
    CHECK_NEAR(found.value, by_enumeration(p), 1e-10);
    CHECK_NEAR(found.value, p.c.dot(found.x), 1e-12);
    CHECK(found.x.minCoeff() >= 0.0);
    CHECK((p.A * found.x - p.b).maxCoeff() <= 1e-12);
    if (p.E.rows() > 0) CHECK((p.E * found.x).cwiseAbs().maxCoeff() <= 1e-12);
  }
}

TEST_CASE("Linear programme: equations that say the same twice, or nothing, change nothing") {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    EquilibriumProgram p = random_program(random, 2, 7, 3);
    const double value = maximise(p).value;
    p.E.conservativeResize(5, 7);
    p.E.row(2) = p.E.row(0) - 2.0 * p.E.row(1);
    p.E.row(3).setZero();
    p.E.row(4) = p.E.row(0);
    CHECK_NEAR(maximise(p).value, value, 1e-12);
  }
}

TEST_CASE("Linear programme: small pivots on the way, as of nearly symmetric grasps, leave its point feasible") {
  Random random(3);
  for (int i = 0; i < 600; ++i) {
    const double off = std::pow(10.0, -5 - i % 9);
    const EquilibriumProgram p = ring_program(random, 3 + i % 3, off);
    const EquilibriumOptimum found = maximise(p);
    REQUIRE(found.bounded);
    CHECK((p.E * found.x).cwiseAbs().maxCoeff() <= 1e-9);
    CHECK((p.A * found.x - p.b).maxCoeff() <= 1e-9);
    CHECK_NEAR(found.value, 1.0, 10 * off);  // the whole ring's wrenches add up to 0
  }
}

TEST_CASE("Linear programme: rounding does not add up over many pivots beside far larger bounds") {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const EquilibriumProgram p = weight_program(random, 3 + i % 3, std::pow(10.0, -5 - i % 9));
    const EquilibriumOptimum found = maximise(p);
    REQUIRE(found.bounded);
    const double allowed = 500 * kEps * p.b.maxCoeff();  // some hundred sums of numbers as large as the bounds
    CHECK((p.E * found.x).cwiseAbs().maxCoeff() <= allowed);
    CHECK((p.A * found.x - p.b).maxCoeff() <= allowed);
  }
}

TEST_CASE("Linear programme: what nothing bounds is said to be unbounded, and with nothing to gain 0 is best") {
  EquilibriumProgram p{Eigen::MatrixXd(1, 2), Eigen::MatrixXd(0, 2), Eigen::VectorXd(0), Eigen::Vector2d(1, 0)};
  p.E << 1, -1;
  CHECK_FALSE(maximise(p).bounded);
  p.c = Eigen::Vector2d(-1, 0);
  CHECK(maximise(p).bounded);
  CHECK(maximise(p).value == 0.0);
  p.E << 1, 1;  // only x = 0 is feasible
  p.c = Eigen::Vector2d(1, 1);
  CHECK(maximise(p).value == 0.0);
}

TEST_CASE("Linear programme: Beale's example, on which the textbook rule goes round for ever, ends at 1/20") {
  EquilibriumProgram p{Eigen::MatrixXd(0, 4), Eigen::MatrixXd(3, 4), Eigen::Vector3d(0, 0, 1), Eigen::Vector4d(0.75, -150, 0.02, -6)};
  p.A << 0.25, -60, -0.04, 9, 0.5, -90, -0.02, 3, 0, 0, 1, 0;
  CHECK_NEAR(maximise(p).value, 0.05, 1e-15);
}

TEST_CASE("Linear programme: coefficients that are not finite and negative bounds are refused") {
  EquilibriumProgram p{Eigen::MatrixXd(0, 1), Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Ones(1), Eigen::VectorXd::Ones(1)};
  p.A(0, 0) = NAN;
  CHECK_THROWS_SAYING(maximise(p), InputError, "its coefficients must be finite");
  p.A(0, 0) = 1.0;
  p.b[0] = -1.0;
  CHECK_THROWS_SAYING(maximise(p), InputError, "its bounds not negative");
}

TEST_SUITE_END();
