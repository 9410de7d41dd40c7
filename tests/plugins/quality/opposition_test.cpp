#include <cmath>

#include "measured.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/quality");

namespace {

/// The thumb at v from the middle of two forefingers; the hand comes along x, the forefingers push along y.
MeasuredGrasp thumb_at(const Eigen::Vector3d& v) {
  const Eigen::Vector3d middle(0.3, -0.1, 0.2), apart(0.02, 0.01, 0.05), n(0, -1, 0), a(1, 0, 0);
  return {{ContactFrame::at(middle + v, n, a), ContactFrame::at(middle + apart, -n, a), ContactFrame::at(middle - apart, -n, a)}};
}

}  // namespace

TEST_CASE("Opposition: along the opposition axis it is pad, along the approach palm, across both side, either way round") {
  for (const double sign : {0.07, -0.02}) {
    CHECK(measured("opposition", thumb_at({0, sign, 0}))[0] == 0.0);
    CHECK(measured("opposition", thumb_at({sign, 0, 0}))[0] == 1.0);
    CHECK(measured("opposition", thumb_at({0, 0, sign}))[0] == 2.0);
  }
}

TEST_CASE("Opposition: the shares are the squares of the direction cosines, and add up to 1") {
  const auto values = measured("opposition", thumb_at({0.02, 0.03, 0.06}));
  CHECK(values[0] == 2.0);
  CHECK_NEAR(values[1], 9.0 / 49, 1e-14);
  CHECK_NEAR(values[2], 4.0 / 49, 1e-14);
  CHECK_NEAR(values[3], 36.0 / 49, 1e-14);
  CHECK_NEAR(values[1] + values[2] + values[3], 1.0, 4 * kEps);
}

TEST_CASE("Opposition: turning everything changes nothing; a slanting approach counts by its part across the opposition axis") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    MeasuredGrasp grasp = thumb_at(random_vector(random));
    const auto before = measured("opposition", grasp);
    const Eigen::Matrix3d R = random_rotation(random);
    for (auto& C : grasp.contacts) C = ContactFrame::at(R * C.p_OC, R * C.n, R * C.a);
    grasp.approach_O = R * (grasp.approach_O + 0.5 * grasp.opposition_O).normalized();
    grasp.opposition_O = R * grasp.opposition_O;
    const auto now = measured("opposition", grasp);
    CHECK(now[0] == before[0]);
    for (int k = 1; k < 4; ++k) CHECK_NEAR(now[k], before[k], 1e-13);
  }
}

TEST_CASE("Opposition: a single contact, or fingers that meet in a point, oppose nothing") {
  MeasuredGrasp grasp = thumb_at({0, 0, 0});
  CHECK(measured("opposition", grasp) == std::vector<double>{-1, 0, 0, 0});
  grasp.contacts.resize(1);
  CHECK(measured("opposition", grasp) == std::vector<double>{-1, 0, 0, 0});
}

TEST_CASE("Opposition: without the axes it says so") {
  MeasuredGrasp grasp = thumb_at({0, 1, 0});
  grasp.opposition_O = GraspView::kNotKnown;
  CHECK_THROWS_SAYING(measured("opposition", grasp), InputError, "the approach or the opposition axis is not known");
}

TEST_SUITE_END();
