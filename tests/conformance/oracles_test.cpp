// What the suite measures contacts and grasps with.
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/contact/cone.h"
#include "conformance/contact/frames.h"
#include "preshape/base/random.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::conformance;
using Vector6 = Eigen::Matrix<double, 6, 1>;

TEST_SUITE_BEGIN("conformance");

namespace {

WrenchBasis random_columns(Random& random, int count) {
  WrenchBasis columns(6, count);
  for (double& x : std::span(columns.data(), static_cast<std::size_t>(columns.size()))) x = random.normal();
  return columns;
}

/// A circular cone of half angle 45 degrees about z, by its edges.
WrenchBasis round_cone(int edges) {
  WrenchBasis columns = WrenchBasis::Zero(6, edges);
  for (int k = 0; k < edges; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / edges;
    columns.col(k).head<3>() << std::cos(angle), std::sin(angle), 1.0;
  }
  return columns;
}

}  // namespace

TEST_CASE("Cone: a sum of edges with weights >= 0 has no distance from it") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const WrenchBasis edges = random_columns(random, 1 + i % 20);
    Vector6 sum = Vector6::Zero();
    for (Eigen::Index k = 0; k < edges.cols(); ++k) sum += std::max(0.0, random.normal()) * edges.col(k);
    CHECK_NEAR(distance_from_cone(edges, sum), 0.0, 1e-9 * (1.0 + sum.norm()));
  }
}

TEST_CASE("Cone: it is no farther than its nearest edge, and turning everything changes no distance") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const WrenchBasis edges = random_columns(random, 1 + i % 12);
    const Vector6 vector = random_columns(random, 1).col(0);
    const double distance = distance_from_cone(edges, vector);
    for (Eigen::Index k = 0; k < edges.cols(); ++k) {
      const double along = std::max(0.0, edges.col(k).dot(vector)) / edges.col(k).norm();
      CHECK(distance <= std::sqrt(std::max(0.0, vector.squaredNorm() - along * along)) + 1e-9);
    }
    const Eigen::Matrix3d R = rotation_of(std::array{random.normal(), random.normal(), random.normal(), random.normal()});
    const WrenchBasis one = vector;
    CHECK_NEAR(distance_from_cone(rotated(R, edges), rotated(R, one).col(0)), distance, 1e-9);
  }
}

TEST_CASE("Cone: distances from a square one are those of the textbook") {
  const WrenchBasis square = round_cone(4);
  Vector6 vector = Vector6::Zero();
  vector.head<3>() << 0, 0, -2;
  CHECK_NEAR(distance_from_cone(square, vector), 2.0, 1e-12);  // behind its tip
  vector.head<3>() << 2, 0, 0;
  CHECK_NEAR(distance_from_cone(square, vector), std::sqrt(2.0), 1e-12);  // beside the edge (1 0 1)
  vector.head<3>() << 0, 0, 1;
  vector[5] = 3.0;
  CHECK_NEAR(distance_from_cone(square, vector), 3.0, 1e-12);  // a moment that it does not have
  CHECK_NEAR(distance_from_cone(WrenchBasis(6, 0), vector), vector.norm(), 1e-15);
}

TEST_CASE("Rank and span: as many columns as were drawn are independent, and their sums are inside") {
  Random random(3);
  for (int rank = 1; rank <= 6; ++rank) {
    const WrenchBasis axes = random_columns(random, rank);
    const WrenchBasis mixed = axes * random_columns(random, 9).topRows(rank);
    CHECK(rank_of(mixed) == rank);
    CHECK_NEAR(outside(mixed, mixed.col(3)), 0.0, 1e-12);
    if (rank < 6) CHECK(outside(mixed, random_columns(random, 1).col(0)) > 1e-3);
  }
  CHECK(rank_of(WrenchBasis::Zero(6, 4)) == 0);
  CHECK(outside(WrenchBasis(6, 0), Vector6::Ones()) == 1.0);
}

TEST_SUITE_END();
