// The two plane contacts of thesis table 2.1, over a rectangle.
#include <numbers>

#include "contact_samples.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

namespace {

Value rectangle() { return Value::table({{"half_length", 0.4}, {"half_width", 0.25}}); }

constexpr double kMu = 0.6, kPyramid = kMu / std::numbers::sqrt2;

Value rough_rectangle() { return Value::table({{"half_length", 0.4}, {"half_width", 0.25}, {"mu", kMu}}); }

/// The edges of point contacts at the rectangle's corners, moved to its middle.
WrenchBasis corner_edges(const WrenchBasis& edges) {
  WrenchBasis all(6, 4 * edges.cols());
  Eigen::Index column = 0;
  for (const double x : {-0.4, 0.4}) {
    for (const double y : {-0.25, 0.25}) {
      for (Eigen::Index k = 0; k < edges.cols(); ++k) {
        all.col(column++) = Wrench::from_vector(edges.col(k)).shifted({-x, -y, 0}).vector();
      }
    }
  }
  return all;
}

/// Forces (sx, sy) across the normal at one point.
WrenchBasis pyramid(double s) {
  WrenchBasis edges = WrenchBasis::Zero(6, 4);
  edges.topRows<3>() << s, s, -s, -s, s, -s, s, -s, 1, 1, 1, 1;
  return edges;
}

}  // namespace

TEST_CASE("Frictionless plane: it bears a push at any point of the rectangle and at none beside it") {
  const auto model = contact_model("frictionless_plane", rectangle());
  for (const double x : {-0.41, -0.39, 0.1, 0.39, 0.41}) {
    for (const double y : {-0.26, -0.24, 0.0, 0.24, 0.26}) {
      const Wrench F = Wrench({0, 0, 2}, {0, 0, 0}).shifted({-x, -y, 0});
      INFO(x, " ", y);
      CHECK(admits(*model, plain_contact(), F.vector()) == (std::abs(x) < 0.4 && std::abs(y) < 0.25));
    }
  }
  CHECK(!admits(*model, plain_contact(), wrench(0, 1e-6, 1, 0, 0, 0)));
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, 1, 0, 0, 1e-6)));
}

TEST_CASE("Frictionless plane: its edges are frictionless points at the corners") {
  const auto plane = contact_model("frictionless_plane", rectangle()), point = contact_model("frictionless_point");
  CHECK_NEAR(edges_of(*plane, plain_contact(), 8), corner_edges(edges_of(*point, plain_contact(), 8)), 2 * kEps);
}

TEST_CASE("Frictionless plane: three unit wrenches, and a pattern that presses where it is told") {
  Value given = rectangle();
  given.set("press_along", 0.5);
  given.set("press_across", -1.0);
  const auto model = contact_model("frictionless_plane", given);
  WrenchBasis expected = WrenchBasis::Zero(6, 3);
  expected(2, 0) = expected(3, 1) = expected(4, 2) = 1.0;
  CHECK_NEAR(basis_of(*model, plain_contact()), expected, 0);
  CHECK_NEAR(pattern_of(*model, plain_contact()).vector(), wrench(0, 0, 1, -0.25, -0.2, 0), 2 * kEps);
  Random random(41);
  check_pattern_borne(*model, random);
}

TEST_CASE("Plane with friction: it transmits every wrench") {
  CHECK_NEAR(basis_of(*contact_model("planar_with_friction"), plain_contact()).rowwise().sum(), Vector6(Vector6::Ones()), 0);
  CHECK_NEAR(basis_of(*contact_model("planar_with_friction"), plain_contact()).colwise().sum(), Eigen::RowVectorXd(Eigen::RowVectorXd::Ones(6)), 0);
}

TEST_CASE("Plane with friction: its edges are friction pyramids at the corners, within Coulomb's cone") {
  const auto model = contact_model("planar_with_friction", rough_rectangle());
  const WrenchBasis expected = corner_edges(pyramid(kPyramid)), edges = edges_of(*model, plain_contact(), 8);
  REQUIRE(edges.cols() == 16);
  for (Eigen::Index k = 0; k < 16; ++k) {
    CHECK(((expected.colwise() - edges.col(k)).colwise().norm().array() < 4 * kEps).count() == 1);
    CHECK_NEAR(edges.col(k).head<2>().norm(), kMu, 4 * kEps);
  }
}

TEST_CASE("Plane with friction: the closed form bears what the corners' pyramids add up to, and nothing else") {
  const auto model = contact_model("planar_with_friction", rough_rectangle());
  const WrenchBasis corners = corner_edges(pyramid(kPyramid));
  Random random(42);
  int torsion_bound = 0;
  for (int i = 0; i < 40; ++i) {
    Vector6 load = random_wrench(random).vector();
    load[2] = 0.0;
    const double most = reach(*model, plain_contact(), load);
    const Vector6 normal = wrench(0, 0, 1, 0, 0, 0);
    CHECK(distance_from_cone(corners, normal + (1.0 - 1e-6) * most * load) < 1e-9);
    CHECK(distance_from_cone(corners, normal + (1.0 + 1e-6) * most * load) > 1e-9);
    const double box = std::min({kPyramid / load.head<2>().cwiseAbs().maxCoeff(), 0.25 / std::abs(load[3]), 0.4 / std::abs(load[4])});
    torsion_bound += most < 0.999 * box;
  }
  CHECK(torsion_bound > 10);  // otherwise the bounds of mz have not been tried
}

TEST_CASE("Plane with friction: pure torsion reaches s (X + Y), and none of it is left when it slips along a diagonal") {
  const auto model = contact_model("planar_with_friction", rough_rectangle());
  CHECK_NEAR(reach(*model, plain_contact(), wrench(0, 0, 0, 0, 0, 1)), kPyramid * 0.65, 1e-9);
  const Vector6 slipping = wrench(kPyramid, kPyramid, 1, 0, 0, 0);
  CHECK(admits(*model, plain_contact(), slipping));
  CHECK(!admits(*model, plain_contact(), slipping + wrench(0, 0, 0, 0, 0, 1e-6)));
}

TEST_CASE("Plane with friction: the pattern shares the friction between force and torsion, and is borne") {
  Value given = rough_rectangle();
  given.set("lean", 0.0);
  const auto model = contact_model("planar_with_friction", given);
  CHECK_NEAR(pattern_of(*model, plain_contact()).vector(), wrench(0.6 * kPyramid, 0, 1, 0, 0, 0.4 * kPyramid * 0.65), 4 * kEps);
  Random random(43);
  for (const double lean : {-2.5, 0.0, 0.8}) {
    for (const double twist : {-1.0, 1.0}) {
      given.set("lean", lean);
      given.set("twist", twist);
      check_pattern_borne(*contact_model("planar_with_friction", given), random);
    }
  }
}

TEST_CASE("Plane contacts: a resolution below three is refused") {
  for (const char* name : {"frictionless_plane", "planar_with_friction"}) {
    CHECK_THROWS_SAYING(edges_of(*contact_model(name), plain_contact(), 2), InputError, "at least 3, got 2");
  }
}

TEST_SUITE_END();
