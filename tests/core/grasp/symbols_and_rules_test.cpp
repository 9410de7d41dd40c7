#include "preshape/grasp/approach_symbols.h"
#include "preshape/grasp/virtual_fingers.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/grasp");

TEST_CASE("Rules R1 to R3: the depth decides the finger count, limits included") {
  const double U = 0.03;
  CHECK(ruled_virtual_fingers(0.0, U) == 1);
  CHECK(ruled_virtual_fingers(1.999 * U, U) == 1);
  CHECK(ruled_virtual_fingers(2.0 * U, U) == 2);
  CHECK(ruled_virtual_fingers(3.999 * U, U) == 2);
  CHECK(ruled_virtual_fingers(4.0 * U, U) == 3);
}

TEST_CASE("Forefingers stand symmetrically, one spacing apart") {
  CHECK(forefinger_places(1, 0.03) == std::vector<double>{0.0});
  CHECK(forefinger_places(2, 0.03) == std::vector<double>{-0.015, 0.015});
  CHECK(forefinger_places(3, 0.03) == std::vector<double>{-0.03, 0.0, 0.03});
}

TEST_CASE("Approach symbols: the middles are 0, 0.25, 0.65 and the clipped 0.95 of the half extent") {
  const ApproachSymbols symbols(FuzzyPartition::thesis(), ApproachSymbols::Universe::kHalfExtent);
  const std::vector<double> expected = {-0.95, -0.65, -0.25, 0.0, 0.25, 0.65, 0.95};
  for (int s = 1; s <= 7; ++s) {
    CHECK_NEAR(symbols.fraction(s, 0.04, 0.18), expected[static_cast<std::size_t>(s - 1)], 1e-15);
    CHECK(symbols.symbol(symbols.fraction(s, 0.04, 0.18), 0.04, 0.18) == s);
  }
  CHECK(symbols.fractions(0.04, 0.18).size() == 7);
}

TEST_CASE("Approach symbols over L: far symbols of a small object share its edge") {
  const ApproachSymbols symbols(FuzzyPartition::thesis(), ApproachSymbols::Universe::kNormalised);
  CHECK_NEAR(symbols.fraction(5, 0.09, 0.18), 0.5, 1e-15);  // 0.25 L = 0.045 m of 0.09 m
  CHECK(symbols.fraction(6, 0.09, 0.18) == 0.95);
  CHECK(symbols.fractions(0.09, 0.18) == std::vector<double>{-0.95, -0.5, 0.0, 0.5, 0.95});
}

TEST_SUITE_END();
