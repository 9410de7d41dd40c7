#include <cmath>

#include "measured.h"
#include "preshape/base/error.h"
#include "support/enumerated.h"
#include "support/qhull.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

Value parameters(const char* norm, bool volume) { return Value::table({{"norm", norm}, {"volume", volume}, {"resolution", 4}}); }

/// Epsilon and volume by Qhull on the points that the contact model gives.
std::pair<double, double> by_qhull(const MeasuredGrasp& grasp, ForceBound bound) {
  const auto primitives = grasp_primitives(grasp.model.get(), grasp.contacts, 4, grasp.length_m, "the test");
  const Hull hull = qhull(enumerated({primitives.wrenches, primitives.per_contact, bound}), true);
  double least = INFINITY;
  for (const double offset : hull.offsets) least = std::min(least, offset);
  return {hull.made ? std::max(0.0, least) : 0.0, hull.made ? hull.volume : 0.0};
}

}  // namespace

TEST_CASE("Ferrari-Canny: a cube pushed by twelve fingers d off its axes has d/sqrt(3) and the volume 64 d^3 / 90, at any size") {
  // The hull of three rectangles of area 4 d in planes at right angles: (4 d)^3 (2! 2! 2!) / 6!.
  for (const double L : {0.05, 1.0}) {
    const auto values = measured("ferrari_canny", parameters("l1", true), {pushed_cube(0.5, L), contact("frictionless_point"), L});
    REQUIRE(values.size() == 3);
    CHECK_NEAR(values[0], 0.5 / std::sqrt(3.0), 1e-14);
    CHECK(values[1] == 0.0);
    CHECK_NEAR(values[2], std::pow(4 * 0.5, 3) * 8 / 720, 1e-13);
  }
  const auto each = measured("ferrari_canny", parameters("linf", false), {pushed_cube(0.5, 1.0), contact("frictionless_point")});
  CHECK_NEAR(each[0], 1 / std::sqrt(1.25), 1e-13);
}

TEST_CASE("Ferrari-Canny: two contacts that pull along each axis, each with its own force, make a cube of volume 2^6") {
  // Six pairs would do; here three pairs of opposed contacts at the origin span the forces alone, so it is degenerate.
  std::vector<ContactFrame> contacts;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      contacts.push_back(ContactFrame::at({0, 0, 0}, side * Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Unit((axis + 1) % 3)));
    }
  }
  const auto values = measured("ferrari_canny", parameters("linf", true), {contacts, contact("frictionless_point")});
  CHECK(values == std::vector<double>{0.0, 1.0, 0.0});
}

TEST_CASE("Ferrari-Canny: on random grasps of hard and soft fingers both numbers are those of Qhull's hull of all sums") {
  Random random(1);
  for (int i = 0; i < 24; ++i) {
    const bool soft = i % 2;
    const ForceBound bound = i % 4 < 2 ? ForceBound::kSum : ForceBound::kEach;
    const MeasuredGrasp grasp = {random_contacts(random, 2 + i % 2 + (bound == ForceBound::kSum), 0.1),
                                 contact(soft ? "soft_finger_elliptic" : "hard_finger", Value::table({{"mu", 0.8}})), 0.1};
    const auto values = measured("ferrari_canny", parameters(bound == ForceBound::kSum ? "l1" : "linf", true), grasp);
    const auto [epsilon, volume] = by_qhull(grasp, bound);
    CHECK_NEAR(values[0], epsilon, 1e-11);
    CHECK_NEAR(values[2], volume, 1e-9 * volume);
    CHECK(values[1] == (volume == 0.0 ? 1.0 : 0.0));
  }
}

TEST_CASE("Ferrari-Canny: a model without limits is refused with the mend, and a volume of too many points with its number") {
  CHECK_THROWS_SAYING(measured("ferrari_canny", {opposed_contacts(0.1), contact("salisbury_soft_finger")}), InputError,
                      "quality 'ferrari_canny': the contact model does not say what a contact can bear; choose one that has "
                      "limits, such as contact = \"hard_finger\" (`preshape plugins --kind contact`");
  Random random(2);
  CHECK_THROWS_SAYING(measured("ferrari_canny", parameters("linf", true), {random_contacts(random, 5)}), InputError,
                      "needs the hull of 3125 points, and the most is 1024; lower `resolution`");
}

TEST_SUITE_END();
