#include <cmath>

#include "measured.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

Value task(const std::vector<double>& half_axes, const std::vector<double>& centre = {0, 0, 0, 0, 0, 0}, const char* norm = "l1") {
  return Value::table({{"half_axes", Value::numbers(half_axes)}, {"centre", Value::numbers(centre)}, {"norm", norm}});
}

}  // namespace

TEST_CASE("Task ellipsoid: of the unit ball it is Ferrari and Canny's epsilon, under either bound") {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const MeasuredGrasp grasp = {random_contacts(random, 2 + i % 4), contact("soft_finger_elliptic"), 1.3};
    for (const char* norm : {"l1", "linf"}) {
      const double epsilon = measured("ferrari_canny", Value::table({{"norm", norm}}), grasp)[0];
      CHECK(measured("task_ellipsoid", Value::table({{"norm", norm}}), grasp)[0] == epsilon);
      CHECK_NEAR(measured("task_ellipsoid", task({4, 4, 4, 4, 4, 4}, {0, 0, 0, 0, 0, 0}, norm), grasp)[0], epsilon / 4, 1e-12);
    }
  }
}

TEST_CASE("Task ellipsoid: a task of one wrench alone fits as often as two opposed fingers bear it") {
  // Under the sum 1, halves on either side: mu across their line, mu r as a moment about z; a half of each along it.
  const double mu = 0.5, r = 0.4;
  const MeasuredGrasp grasp = {opposed_contacts(r), contact("soft_finger_elliptic", Value::table({{"mu", mu}}))};
  const auto fits = [&](const std::vector<double>& half_axes, const char* norm) {
    return measured("task_ellipsoid", task(half_axes, {0, 0, 0, 0, 0, 0}, norm), grasp)[0];
  };
  CHECK_NEAR(fits({0, 1, 0, 0, 0, 0}, "l1"), mu, 1e-12);
  CHECK_NEAR(fits({0, 0, 2, 0, 0, 0}, "l1"), mu / 2, 1e-12);
  CHECK_NEAR(fits({0, 0, 0, 0, 0, 1}, "l1"), mu * r, 1e-12);
  CHECK_NEAR(fits({1, 0, 0, 0, 0, 0}, "l1"), 1.0, 1e-12);
  CHECK_NEAR(fits({0, 1, 0, 0, 0, 0}, "linf"), 2 * mu, 1e-12);
  CHECK_NEAR(fits({0, 0, 0, 0, 0, 1}, "linf"), 2 * mu * r, 1e-12);
}

TEST_CASE("Task ellipsoid: it weighs what the task asks for, not what the grasp is weakest in") {
  // Close fingers are weak in moments: a task that asks for little of them fits much better.
  const MeasuredGrasp grasp = {opposed_contacts(0.05), contact("soft_finger_elliptic")};
  const double ball = measured("task_ellipsoid", grasp)[0];
  CHECK(measured("task_ellipsoid", task({1, 1, 1, 0.01, 0.01, 0.01}), grasp)[0] > 5 * ball);
}

TEST_CASE("Task ellipsoid: lists of another length, a task of nothing and a model without limits are refused") {
  CHECK_THROWS_SAYING(measured("task_ellipsoid", task({1, 1, 1}), {opposed_contacts(0.1)}), InputError,
                      "half_axes takes 6 numbers, three of force and three of moment, got 3");
  CHECK_THROWS_SAYING(measured("task_ellipsoid", task({0, 0, 0, 0, 0, 0}), {opposed_contacts(0.1)}), InputError,
                      "half_axes and centre are all 0");
  CHECK_THROWS_SAYING(measured("task_ellipsoid", {opposed_contacts(0.1), contact("salisbury_soft_finger")}), InputError,
                      "quality 'task_ellipsoid': the contact model does not say what a contact can bear; choose one");
}

TEST_SUITE_END();
