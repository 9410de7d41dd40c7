// The two line contacts of thesis table 2.1.
#include "contact_samples.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

namespace {

Value piece(const char* line) { return Value::table({{"half_length", 0.3}, {"line", line}}); }

/// The edges of a point contact at both ends of a line along `u`, moved to its middle.
WrenchBasis end_edges(const WrenchBasis& edges, const Eigen::Vector3d& u) {
  WrenchBasis all(6, 2 * edges.cols());
  for (Eigen::Index k = 0; k < edges.cols(); ++k) {
    all.col(k) = Wrench::from_vector(edges.col(k)).shifted(0.3 * u).vector();
    all.col(k + edges.cols()) = Wrench::from_vector(edges.col(k)).shifted(-0.3 * u).vector();
  }
  return all;
}

}  // namespace

TEST_CASE("Frictionless line: a force and the moment about the axis across the line, which lies along a or t") {
  WrenchBasis along = WrenchBasis::Zero(6, 2), across = along;
  along(2, 0) = across(2, 0) = 1.0;
  along(4, 1) = 1.0;    // a line along x: about y
  across(3, 1) = -1.0;  // along y: about -x
  CHECK_NEAR(basis_of(*contact_model("frictionless_line", piece("along")), plain_contact()), along, 0);
  CHECK_NEAR(basis_of(*contact_model("frictionless_line", piece("across")), plain_contact()), across, 0);
}

TEST_CASE("Frictionless line: it bears a push at any point of the line and at none beside it") {
  const auto along = contact_model("frictionless_line", piece("along")), across = contact_model("frictionless_line", piece("across"));
  for (const double s : {-0.31, -0.29, 0.1, 0.31}) {
    const Vector6 on_x = Wrench({0, 0, 2}, {0, 0, 0}).shifted({-s, 0, 0}).vector();
    const Vector6 on_y = Wrench({0, 0, 2}, {0, 0, 0}).shifted({0, -s, 0}).vector();
    CHECK(admits(*along, plain_contact(), on_x) == (std::abs(s) < 0.3));
    CHECK(admits(*across, plain_contact(), on_y) == (std::abs(s) < 0.3));
    CHECK(!admits(*along, plain_contact(), on_y));
    CHECK(!admits(*across, plain_contact(), on_x));
  }
  CHECK(!admits(*along, plain_contact(), wrench(1e-6, 0, 1, 0, 0, 0)));
  CHECK(!admits(*along, plain_contact(), wrench(0, 0, 1, 0, 0, 1e-6)));
}

TEST_CASE("Frictionless line: its edges are frictionless points at the ends, its pattern a push where it is told") {
  Value given = piece("along");
  given.set("press", 0.5);
  const auto model = contact_model("frictionless_line", given), point = contact_model("frictionless_point");
  CHECK_NEAR(edges_of(*model, plain_contact(), 8), end_edges(edges_of(*point, plain_contact(), 8), {1, 0, 0}), 2 * kEps);
  CHECK_NEAR(pattern_of(*model, plain_contact()).vector(), wrench(0, 0, 1, 0, -0.15, 0), 2 * kEps);
  Random random(51);
  check_pattern_borne(*model, random);
}

TEST_CASE("Friction line: everything but the moment about the line") {
  WrenchBasis expected = WrenchBasis::Zero(6, 5);
  expected(2, 0) = expected(0, 1) = expected(1, 2) = expected(4, 3) = expected(5, 4) = 1.0;
  CHECK_NEAR(basis_of(*contact_model("friction_line", piece("along")), plain_contact()), expected, 0);
  CHECK(!admits(*contact_model("friction_line"), plain_contact(), wrench(0, 0, 1, 1e-6, 0, 0)));
}

TEST_CASE("Friction line: its edges are those of hard fingers at the ends, borne one by one and in sums") {
  const auto line = contact_model("friction_line", piece("along")), hard = contact_model("hard_finger");
  const WrenchBasis edges = end_edges(edges_of(*hard, plain_contact(), 12), {1, 0, 0});
  CHECK_NEAR(edges_of(*line, plain_contact(), 12), edges, 4 * kEps);
  Random random(52);
  for (int i = 0; i < 500; ++i) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(edges.cols());
    for (int k = 0; k < 3; ++k) weights[static_cast<Eigen::Index>(random.below(24))] = random.uniform();
    CHECK(admits(*line, plain_contact(), edges * weights));
  }
}

TEST_CASE("Friction line: what the closed form bears is what cones at the ends add up to, and nothing else") {
  for (const char* lie : {"along", "across"}) {
    const auto line = contact_model("friction_line", piece(lie)), hard = contact_model("hard_finger");
    const bool along = std::string(lie) == "along";
    const Eigen::Vector3d u = along ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    const WrenchBasis ends = end_edges(edges_of(*hard, plain_contact(), 48), u);
    Random random(53);
    for (int i = 0; i < 20; ++i) {
      Vector6 load = random_wrench(random).vector();
      load[2] = load[along ? 3 : 4] = 0.0;
      const double most = reach(*line, plain_contact(), load);
      const Vector6 normal = wrench(0, 0, 1, 0, 0, 0);
      // 48 edges miss 1 - cos(pi / 48) = 0.2 % of a cone.
      CHECK(distance_from_cone(ends, normal + 0.99 * most * load) < 1e-9);
      CHECK(distance_from_cone(ends, normal + 1.001 * most * load) > 1e-6);
    }
  }
}

TEST_CASE("Friction line: pure torsion reaches mu times the half length, and a push at an end bears none") {
  const auto model = contact_model("friction_line", piece("along"));
  CHECK_NEAR(reach(*model, plain_contact(), wrench(0, 0, 0, 0, 0, 1)), 0.15, 1e-9);
  // At the end x = 0.3 the one force f bears the moment 0.3 fy about n, with |f| within its cone.
  CHECK(admits(*model, plain_contact(), Wrench({0.3, 0.4, 1}, {0, 0, 0}).shifted({-0.3, 0, 0}).vector()));
  CHECK(!admits(*model, plain_contact(), Wrench({0.3, 0.4, 1}, {0, 0, 1e-4}).shifted({-0.3, 0, 0}).vector()));
}

TEST_CASE("Friction line: the pattern shares the friction between force and torsion, and is borne") {
  Value given = piece("along");
  given.set("lean", 0.0);
  CHECK_NEAR(pattern_of(*contact_model("friction_line", given), plain_contact()).vector(), wrench(0.3, 0, 1, 0, 0, 0.06), 4 * kEps);
  Random random(54);
  for (const double pull : {0.0, 0.6, 1.0}) {
    for (const double lean : {-2.5, 1.5707963}) {
      given.set("pull", pull);
      given.set("lean", lean);
      check_pattern_borne(*contact_model("friction_line", given), random);
    }
  }
}

TEST_CASE("Line contacts: a resolution below three is refused") {
  CHECK_THROWS_SAYING(edges_of(*contact_model("frictionless_line"), plain_contact(), 2), InputError, "at least 3, got 2");
  CHECK_THROWS_SAYING(edges_of(*contact_model("friction_line"), plain_contact(), 2), InputError, "at least 3 edges, got 2");
}

TEST_SUITE_END();
