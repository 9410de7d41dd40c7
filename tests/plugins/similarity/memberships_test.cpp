// Similarities of memberships beside TFVADI and TFDist: closed forms, and how they go with each other.
#include <array>
#include <cmath>
#include <limits>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/similarity");

namespace {

using Vector = std::array<double, 6>;

const Vector kTask = {1.14, 1.02, 0.10, 0.06, 0.79, 0.08};
const Vector kWrench = {2.3, 1, -0.28, 0.65, 0.73, -0.0016};

struct Scores {
  double whole = 0.0;
  Vector parts;
};

Scores scores(const char* name, const Vector& q, const Vector& w, const Value& parameters = {}) {
  static const auto partition = FuzzyPartition::thesis();
  const auto measure = registry().create<Similarity>(name, parameters);
  const Patterns task(partition, q), pattern(partition, w);
  Scores found;
  measure->compare(task.view(), pattern.view(), {&found.whole, 1});
  measure->component_scores(task.view(), pattern.view(), found.parts);
  return found;
}

Vector random_pattern(Random& random) {
  Vector v;
  for (double& x : v) x = random.uniform(-1.5, 1.5);
  return v;
}

const Value order(double p) {
  return Value::table({{"order", p}});
}

// The memberships of figure 3.19 that are not 0 or 1, by hand from the sets: 0.10 is 1/2 Zero and 1/2 FwdL,
// 0.06 is 0.9 Zero and 0.1 FwdL, 0.79 is FwdM and 4/15 FwdH, 0.08 is 0.7 Zero and 0.3 FwdL.
const double kFifth = 1.0 / (1.0 + 4.0 / 15.0);

}  // namespace

TEST_CASE("Jaccard: the rows of figure 3.19's patterns are intersections over unions, by hand") {
  const Scores found = scores("jaccard", kTask, kWrench);
  const Vector expected = {1, 1, 0, 0, kFifth, 0.7 / 1.3};
  for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(found.parts[k], expected[k], 1e-12);
  CHECK_NEAR(found.whole, 2 + kFifth + 0.7 / 1.3, 1e-12);
}

TEST_CASE("Dice: the rows of figure 3.19's patterns are twice the intersections over both, by hand") {
  const Scores found = scores("dice", kTask, kWrench);
  const Vector expected = {1, 1, 0, 0, 2.0 / (2.0 + 4.0 / 15.0), 0.7};
  for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(found.parts[k], expected[k], 1e-12);
}

TEST_CASE("Dice: each row is 2 j / (1 + j) of Jaccard's row j") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector q = random_pattern(random), w = random_pattern(random);
    const Vector j = scores("jaccard", q, w).parts, d = scores("dice", q, w).parts;
    for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(d[k], 2 * j[k] / (1 + j[k]), 1e-14);
  }
}

TEST_CASE("Jaccard and Dice: a pattern is as near as can be to itself, also between two sets") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector q = random_pattern(random);
    CHECK(scores("jaccard", q, q).whole == 6.0);
    CHECK(scores("dice", q, q).whole == 6.0);
  }
}

TEST_CASE(
    "Jaccard and Dice: two empty fuzzy vectors are equal, an empty one and another have nothing in common") {
  const std::array<double, 6> crisp{};
  const std::array<double, 12> none{}, all = {1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0};
  const PatternView empty{1, 2, crisp.data(), none.data()}, full{1, 2, crisp.data(), all.data()};
  for (const char* name : {"jaccard", "dice"}) {
    double score = -1.0;
    const auto measure = registry().create<Similarity>(name);
    measure->compare(empty, empty, {&score, 1});
    CHECK(score == 6.0);
    measure->compare(empty, full, {&score, 1});
    CHECK(score == 0.0);
  }
}

TEST_CASE("Hamming: the rows of figure 3.19's patterns are sums of differences over seven sets, by hand") {
  const Scores found = scores("hamming", kTask, kWrench);
  const Vector expected = {0, 0, 2.0, 2.0, 4.0 / 15.0, 0.6};
  for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(found.parts[k], expected[k] / 7.0, 1e-12);
}

TEST_CASE(
    "Minkowski: order 2 is the thesis's total fuzzy distance, 3.2648 in figure 3.19, and order 1 seven times "
    "Hamming's") {
  // The printed sum adds rows rounded to four digits.
  CHECK_NEAR(scores("minkowski", kTask, kWrench, order(2)).whole, 3.2648, 2e-4);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector q = random_pattern(random), w = random_pattern(random);
    CHECK_NEAR(scores("minkowski", q, w, order(2)).whole, scores("tfdist", q, w).whole, 1e-12);
    CHECK_NEAR(scores("minkowski", q, w, order(1)).whole, 7 * scores("hamming", q, w).whole, 1e-12);
  }
}

TEST_CASE("Minkowski: a higher order never gives more, and a high one the largest difference") {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Vector q = random_pattern(random), w = random_pattern(random);
    double before = std::numeric_limits<double>::infinity();
    for (const double p : {1.0, 1.5, 2.0, 5.0, 30.0, 100.0}) {
      const double now = scores("minkowski", q, w, order(p)).whole;
      CHECK(now <= before + 1e-12);
      before = now;
    }
  }
  // Two differences of 1: 2^(1/100).
  CHECK_NEAR(scores("minkowski", {0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0}, order(100)).whole,
             std::pow(2.0, 0.01), 1e-12);
}

TEST_CASE("Minkowski: the smallest difference counts in the highest order") {
  const std::array<double, 6> crisp{};
  std::array<double, 6> a{}, b{};
  b[3] = 1e-9;
  double score = 0.0;
  const auto measure = registry().create<Similarity>("minkowski", order(100));
  measure->compare({1, 1, crisp.data(), a.data()}, {1, 1, crisp.data(), b.data()}, {&score, 1});
  CHECK_NEAR(score, 1e-9, 1e-20);
}

TEST_CASE("Similarities of memberships refuse one that is not finite, and say in which component") {
  const std::array<double, 6> crisp{};
  std::array<double, 6> good{}, bad{};
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  for (const char* name : {"jaccard", "dice", "hamming", "minkowski"}) {
    double score = 0.0;
    const auto measure = registry().create<Similarity>(name);
    CHECK_THROWS_SAYING(
        measure->compare({1, 1, crisp.data(), good.data()}, {1, 1, crisp.data(), bad.data()}, {&score, 1}),
        InputError, "component 4 has a membership that is not finite");
  }
}

TEST_SUITE_END();
