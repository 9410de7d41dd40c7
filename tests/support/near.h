#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <Eigen/Core>

#include <doctest/doctest.h>

namespace preshape::test {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Largest absolute difference; NaN in either side is never near.
template <class A, class B>
double difference(const A& a, const B& b) {
  if constexpr (std::is_arithmetic_v<A>) {
    return std::abs(a - b);
  } else {
    const auto d = (a - b).eval();
    return d.size() == 0 ? 0.0 : (d.array().isNaN().any() ? std::numeric_limits<double>::quiet_NaN()
                                                         : d.cwiseAbs().maxCoeff());
  }
}

}  // namespace preshape::test

/// |a - b| <= tolerance, component by component; the tolerance is always said.
#define CHECK_NEAR(a, b, tolerance)                                                          \
  do {                                                                                       \
    const double preshape_difference = ::preshape::test::difference((a), (b));               \
    INFO(#a " differs from " #b " by ", preshape_difference, ", allowed ", double(tolerance)); \
    CHECK(preshape_difference <= (tolerance));                                               \
  } while (false)

/// The expression throws `type` and its message contains `part`.
#define CHECK_THROWS_SAYING(expression, type, part)                       \
  do {                                                                    \
    bool preshape_thrown = false;                                         \
    try {                                                                 \
      (void)(expression);                                                 \
    } catch (const type& error) {                                         \
      preshape_thrown = true;                                             \
      INFO("message: ", std::string(error.what()));                                    \
      CHECK(std::string(error.what()).find(part) != std::string::npos);   \
    }                                                                     \
    INFO("no " #type " from " #expression);                               \
    CHECK(preshape_thrown);                                               \
  } while (false)
