#include "preshape/base/random.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/base");

TEST_CASE("Random: the same seed gives the same numbers, another seed others") {
  Random a(7), b(7), c(8);
  bool all_equal = true;
  for (int i = 0; i < 100; ++i) {
    const auto x = a();
    CHECK(x == b());
    all_equal = all_equal && x == c();
  }
  CHECK_FALSE(all_equal);
}

TEST_CASE("Random: a named stream does not depend on what was drawn before") {
  Random a(7), b(7);
  for (int i = 0; i < 10; ++i) b();
  CHECK(a.stream("weights")() == b.stream("weights")());
  CHECK(a.stream("weights")() != a.stream("rows")());
}

TEST_CASE("Random: uniform, normal and below have the moments that they claim") {
  // n = 1e5; tolerances are 5 standard errors.
  Random random(1);
  const int n = 100000;
  double sum = 0, normal_sum = 0, normal_squares = 0, below_sum = 0;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    CHECK_MESSAGE((u >= 0.0 && u < 1.0), u);
    sum += u;
    const double g = random.normal();
    normal_sum += g;
    normal_squares += g * g;
    below_sum += static_cast<double>(random.below(6));
  }
  CHECK_NEAR(sum / n, 0.5, 5 * 0.2887 / std::sqrt(n));
  CHECK_NEAR(normal_sum / n, 0.0, 5 / std::sqrt(n));
  CHECK_NEAR(normal_squares / n, 1.0, 5 * std::sqrt(2.0 / n));
  CHECK_NEAR(below_sum / n, 2.5, 5 * 1.708 / std::sqrt(n));
}

TEST_SUITE_END();
