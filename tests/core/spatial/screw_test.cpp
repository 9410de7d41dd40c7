#include <Eigen/Geometry>

#include "preshape/spatial/screw.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/spatial");

TEST_CASE("Poinsot: the reduced screw is the same force system") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Wrench F_P = random_wrench(random);
    const Screw s = poinsot_reduce(F_P);
    const Eigen::Vector3d moment = s.magnitude * (s.point.cross(s.direction) + s.pitch * s.direction);
    CHECK_NEAR(Eigen::Vector3d(s.magnitude * s.direction), F_P.force(), 8 * kEps);
    CHECK_NEAR(moment, F_P.moment(), 64 * kEps * (1 + s.point.norm()));
  }
}

TEST_CASE("Poinsot: a pure force has zero pitch wherever it acts") {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d f = random_vector(random), p_OC = random_vector(random);
    CHECK_NEAR(poinsot_reduce(Wrench(f, {0, 0, 0}).shifted(-p_OC)).pitch, 0.0, 16 * kEps / f.norm());
  }
}

TEST_CASE("Poinsot: a pure couple has infinite pitch and its moment as magnitude") {
  const Screw s = poinsot_reduce(Wrench({0, 0, 0}, {0, 3, 4}));
  CHECK(std::isinf(s.pitch));
  CHECK(s.magnitude == 5.0);
}

TEST_CASE("Poinsot: the pitch does not change when the point of reference does") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Wrench F = random_wrench(random);
    const double pitch = poinsot_reduce(F).pitch;
    CHECK_NEAR(poinsot_reduce(F.shifted(random_vector(random))).pitch, pitch, 1e-12 * (1 + std::abs(pitch)));
  }
}

TEST_SUITE_END();
