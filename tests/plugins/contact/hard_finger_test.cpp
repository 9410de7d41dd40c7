#include <numbers>

#include "contact_samples.h"
#include "preshape/base/error.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/contact");

TEST_CASE("Hard finger: three forces, along the normal, the approach and t where those are square") {
  const auto model = contact_model("hard_finger");
  WrenchBasis expected = WrenchBasis::Zero(6, 3);
  expected.topRows<3>() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  CHECK_NEAR(basis_of(*model, plain_contact()), expected, 0);
}

TEST_CASE("Hard finger: the pattern is the normal with a share of its friction, lean from the approach to t") {
  const auto model = contact_model("hard_finger", Value::table({{"mu", 0.8}, {"pull", 0.5}, {"lean", std::numbers::pi / 6}}));
  const Wrench F = pattern_of(*model, plain_contact());
  CHECK_NEAR(F.force(), Eigen::Vector3d(0.4 * std::sqrt(0.75), 0.2, 1), 4 * kEps);
  CHECK(F.moment().isZero(0));
}

TEST_CASE("Hard finger: the defaults are near the thesis's weights Ka = 0.45 and Ko = 0.25") {
  const Wrench F = pattern_of(*contact_model("hard_finger"), plain_contact());
  CHECK_NEAR(F.force(), Eigen::Vector3d(0.45, 0.25, 1), 0.012);
}

TEST_CASE("Hard finger: along the normal the approach leaves no friction in the pattern") {
  const auto model = contact_model("hard_finger");
  const Wrench F = pattern_of(*model, ContactFrame::at({0, 0, 0}, {0, 0, 1}, {0, 0, 1}));
  CHECK_NEAR(F.force(), Eigen::Vector3d(0, 0, 1), 0);
}

TEST_CASE("Hard finger: a block on a slope slips where the slope's tangent passes mu") {
  const auto model = contact_model("hard_finger", Value::table({{"mu", 0.3}}));
  for (const double turn : {0.0, 1.0, 2.0, 4.0}) {
    for (const double slope : {0.1, 0.29, 0.31, 0.8}) {
      const double angle = std::atan(slope);
      const Vector6 weight = wrench(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle), 0, 0, 0);
      CHECK(admits(*model, plain_contact(), weight) == (slope < 0.3));
    }
  }
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, -1, 0, 0, 0)));
  CHECK(!admits(*model, plain_contact(), wrench(0, 0, 1, 0, 0, 1e-6)));
}

TEST_CASE("Hard finger: k edges lie on the cone, and between two of them mu cos(pi / k) is left") {
  const auto model = contact_model("hard_finger", Value::table({{"mu", 0.6}}));
  Random random(11);
  for (const int k : {3, 8, 17}) {
    const ContactFrame C = random_contact(random);
    const WrenchBasis edges = edges_of(*model, C, k);
    REQUIRE(edges.cols() == k);
    for (int i = 0; i < k; ++i) {
      const Eigen::Vector3d f = edges.col(i).head<3>(), g = edges.col((i + 1) % k).head<3>();
      CHECK_NEAR(f.dot(C.n), 1.0, 8 * kEps);
      CHECK_NEAR((f - C.n).norm(), 0.6, 8 * kEps);
      CHECK_NEAR((0.5 * (f + g) - C.n).norm(), 0.6 * std::cos(std::numbers::pi / k), 8 * kEps);
    }
  }
}

TEST_CASE("Hard finger: the pattern is borne whatever its friction and direction") {
  Random random(12);
  for (const double pull : {0.0, 0.7, 1.0}) {
    for (const double lean : {-2.0, 0.0, 1.5}) {
      check_pattern_borne(*contact_model("hard_finger", Value::table({{"pull", pull}, {"lean", lean}})), random);
    }
  }
}

TEST_CASE("Hard finger: normals that are not unit and coarse resolutions are refused in one sentence") {
  const auto model = contact_model("hard_finger");
  CHECK_THROWS_SAYING(pattern_of(*model, ContactFrame::at({0, 0, 0}, {0, 0, 2}, {1, 0, 0})), InputError,
                      "contact 0: its normal and approach axis must be unit vectors");
  CHECK_THROWS_SAYING(edges_of(*model, plain_contact(), 2), InputError, "at least 3 edges, got 2");
  CHECK_THROWS_SAYING(admits(*model, plain_contact(), Vector6::Constant(std::numeric_limits<double>::infinity())), InputError, "six components");
}

TEST_SUITE_END();
