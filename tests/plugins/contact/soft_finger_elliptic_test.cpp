#include <functional>
#include <numbers>

#include "contact_samples.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

namespace {

/// Mean distance from the centre of a unit disc under a pressure that depends on it: friction's moment over its
/// force. Midpoints in the angle u, s = sin(u), which tames the edge of Hertz's pressure.
double mean_distance(const std::function<double(double)>& pressure) {
  double moment = 0.0, force = 0.0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double u = 0.5 * std::numbers::pi * (i + 0.5) / kSteps, s = std::sin(u);
    const double ring = pressure(s) * s * std::cos(u);
    force += ring;
    moment += ring * s;
  }
  return moment / force;
}

}  // namespace

TEST_CASE("Elliptic soft finger: pure torsion is borne up to the friction integrated over the area") {
  const std::pair<const char*, std::function<double(double)>> pressures[] = {
      {"constant", [](double) { return 1.0; }},
      {"hertz", [](double s) { return std::sqrt(1.0 - s * s); }},
      {"winkler", [](double s) { return 1.0 - s * s; }}};
  for (const auto& [name, pressure] : pressures) {
    const auto model = contact_model("soft_finger_elliptic", Value::table({{"mu", 0.7}, {"radius", 0.2}, {"pressure", name}}));
    INFO(name);
    // The midpoint rule leaves about 1e-9 at these steps, the bisection 1e-12.
    CHECK_NEAR(reach(*model, plain_contact(), wrench(0, 0, 0, 0, 0, 1)), 0.7 * 0.2 * mean_distance(pressure), 1e-8);
  }
}

TEST_CASE("Elliptic soft finger: four unit wrenches, three forces and the moment about the normal") {
  WrenchBasis expected = WrenchBasis::Zero(6, 4);
  expected(2, 0) = expected(0, 1) = expected(1, 2) = expected(5, 3) = 1.0;
  CHECK_NEAR(basis_of(*contact_model("soft_finger_elliptic"), plain_contact()), expected, 0);
}

TEST_CASE("Elliptic soft finger: with 0.6 of its friction in force it bears 0.8 of its torsion") {
  const auto model = contact_model("soft_finger_elliptic",
                                   Value::table({{"mu", 0.5}, {"radius", 0.3}, {"pressure", "constant"}, {"lean", 0.0}}));
  CHECK_NEAR(pattern_of(*model, plain_contact()).vector(), wrench(0.3, 0, 1, 0, 0, 0.08), 4 * kEps);
  CHECK(admits(*model, plain_contact(), wrench(0.3, 0, 1, 0, 0, 0.08)));
  CHECK(!admits(*model, plain_contact(), wrench(0.3, 0, 1, 0, 0, 0.0801)));
  CHECK(!admits(*model, plain_contact(), wrench(0.3001, 0, 1, 0, 0, -0.08)));
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, 1, 1e-6, 0, 0)));
}

TEST_CASE("Elliptic soft finger: without torsion it is a hard finger") {
  const auto soft = contact_model("soft_finger_elliptic"), hard = contact_model("hard_finger");
  Random random(31);
  for (int i = 0; i < 200; ++i) {
    const ContactFrame C = random_contact(random);
    const Vector6 F = (Vector6() << C.n + 0.6 * random_vector(random), 0, 0, 0).finished();
    CHECK(admits(*soft, C, F) == admits(*hard, C, F));
  }
}

TEST_CASE("Elliptic soft finger: every edge lies on the limit surface, and 1/k^2 of the reach is missed between them") {
  const auto model = contact_model("soft_finger_elliptic", Value::table({{"mu", 0.5}, {"radius", 0.5}}));
  Random random(32);
  const ContactFrame C = random_contact(random);
  const double e_z = 0.5 * 3 * std::numbers::pi / 16;
  const WrenchBasis edges = edges_of(*model, C, 8);
  REQUIRE(edges.cols() == 26);
  for (Eigen::Index k = 0; k < edges.cols(); ++k) {
    const Eigen::Vector3d ft = edges.col(k).head<3>() - C.n;
    const double mz = edges.col(k).tail<3>().dot(C.n);
    CHECK_NEAR(ft.squaredNorm() + mz * mz / (e_z * e_z), 0.25, 16 * kEps);
  }
  for (int i = 0; i < 20; ++i) {
    Vector6 load = (Vector6() << C.n.cross(random_unit(random)), e_z * random.uniform(-1, 1) * C.n).finished();
    const double most = reach(*model, C, load);
    const Vector6 normal = (Vector6() << C.n, 0, 0, 0).finished();
    // Cells of 45 degrees: the middle of one is at most 1 - cos(22.5)^2 = 0.15 inside.
    CHECK(distance_from_cone(edges, normal + 0.85 * most * load) < 1e-9);
    CHECK(distance_from_cone(edges, normal + 1.001 * most * load) > 1e-6);
  }
}

TEST_CASE("Elliptic soft finger: the pattern is borne for every share") {
  Random random(33);
  for (const double pull : {0.0, 0.6, 1.0}) {
    for (const double twist : {-1.0, 0.3}) {
      check_pattern_borne(*contact_model("soft_finger_elliptic", Value::table({{"pull", pull}, {"twist", twist}, {"lean", -2.0}})), random);
    }
  }
}

TEST_CASE("Elliptic soft finger: a finer resolution than numbers can count is not a negative number of edges") {
  CHECK(contact_limits(*contact_model("soft_finger_elliptic"))->primitive_count(1 << 30) > 0);
}

TEST_SUITE_END();
