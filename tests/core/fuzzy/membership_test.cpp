#include <cmath>

#include "preshape/fuzzy/membership.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/fuzzy");

namespace {
Membership set(Membership::Shape shape, std::vector<double> points) { return {"s", shape, std::move(points), false, false}; }
}  // namespace

TEST_CASE("Membership: a trapezoid is 0 outside, 1 on its top, linear between") {
  const auto m = set(Membership::Shape::kTrapezoid, {0, 1, 3, 5});
  CHECK(m(-0.1) == 0.0);
  CHECK(m(0.25) == 0.25);
  CHECK(m(1.0) == 1.0);
  CHECK(m(3.0) == 1.0);
  CHECK(m(4.0) == 0.5);
  CHECK(m(5.0) == 0.0);
  CHECK(m.top_middle() == 2.0);
}

TEST_CASE("Membership: a shoulder stays 1 beyond its top, however far") {
  auto m = set(Membership::Shape::kTrapezoid, {0.75, 0.9, 1.2, 1.2});
  CHECK(m(2.3) == 0.0);
  m.open_above = true;
  CHECK(m(2.3) == 1.0);
  CHECK(m(1e9) == 1.0);
  CHECK_NEAR(m(0.825), 0.5, 4 * kEps);
}

TEST_CASE("Membership: triangle, Gaussian, bell and sigmoid have their textbook values") {
  CHECK(set(Membership::Shape::kTriangle, {0, 1, 3})(2) == 0.5);
  CHECK_NEAR(set(Membership::Shape::kGaussian, {1, 2})(3), std::exp(-0.5), kEps);
  CHECK_NEAR(set(Membership::Shape::kBell, {2, 4, 6})(8), 0.5, kEps);
  CHECK_NEAR(set(Membership::Shape::kSigmoid, {5, 0.3})(0.3), 0.5, kEps);
}

TEST_CASE("Membership: every shape stays within 0 and 1 and is highest at the middle of its top") {
  for (const auto& m : {set(Membership::Shape::kTrapezoid, {-1, 0, 0.5, 2}), set(Membership::Shape::kTriangle, {-1, 0, 2}),
                        set(Membership::Shape::kGaussian, {0.2, 0.3}), set(Membership::Shape::kBell, {0.4, 2, 0.1})}) {
    for (double x = -3; x <= 3; x += 0.01) {
      const double degree = m(x);
      CHECK_MESSAGE((degree >= 0.0 && degree <= m(m.top_middle())), x);
    }
    CHECK(m(m.top_middle()) == 1.0);
  }
}

TEST_CASE("Membership: NaN stays NaN instead of becoming a degree") {
  auto m = set(Membership::Shape::kTrapezoid, {0, 1, 2, 3});
  m.open_below = m.open_above = true;
  CHECK(std::isnan(m(std::nan(""))));
}

TEST_SUITE_END();
