#include <Eigen/Geometry>

#include "preshape/base/random.h"
#include "preshape/spatial/twist.h"
#include "preshape/spatial/wrench.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/spatial");

TEST_CASE("Wrench: shifting to a point and back gives the same wrench") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Wrench F = random_wrench(random);
    const Eigen::Vector3d p = random_vector(random);
    CHECK_NEAR(F.shifted(p).shifted(-p).vector(), F.vector(), 16 * kEps);
  }
}

TEST_CASE("Wrench: a force at C has the moment p_OC x f about O") {
  const Wrench F_C({0, 0, 2}, {0, 0, 0});
  const Eigen::Vector3d p_OC(3, 0, 0);
  CHECK_NEAR(F_C.shifted(-p_OC).moment(), Eigen::Vector3d(0, -6, 0), 0);
}

TEST_CASE("Wrench and twist: power is the same at every point and in every frame") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Wrench F = random_wrench(random);
    const Twist V(random_vector(random), random_vector(random));
    const Eigen::Vector3d p = random_vector(random);
    const Eigen::Matrix3d R = random_rotation(random);
    const double power = reciprocal_product(F, V);
    CHECK_NEAR(reciprocal_product(F.shifted(p), V.shifted(p)), power, 64 * kEps);
    CHECK_NEAR(reciprocal_product(F.rotated(R), V.rotated(R)), power, 64 * kEps);
  }
}

TEST_SUITE_END();
