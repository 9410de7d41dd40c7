// The measures of fuzzy sets that the comparisons of the field put beside each other: closed forms, and how
// they go with the other measures.
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

/// Of patterns with any memberships, six rows of `sets`.
Vector parts_of(const char* name, int sets, const std::vector<double>& q, const std::vector<double>& w) {
  const Vector crisp{};
  const auto measure = registry().create<Similarity>(name);
  Vector parts;
  measure->component_scores({1, sets, crisp.data(), q.data()}, {1, sets, crisp.data(), w.data()}, parts);
  return parts;
}

/// The score of one component, whose memberships are these.
double row(const char* name, std::vector<double> q, std::vector<double> w) {
  const int sets = static_cast<int>(q.size());
  q.resize(q.size() * 6), w.resize(w.size() * 6);
  return parts_of(name, sets, q, w)[0];
}

Vector parts(const char* name, const Vector& q, const Vector& w, const Value& parameters = {}) {
  static const auto partition = FuzzyPartition::thesis();
  const Patterns task(partition, q), pattern(partition, w);
  Vector found;
  registry().create<Similarity>(name, parameters)->component_scores(task.view(), pattern.view(), found);
  return found;
}

void check_parts(const Vector& found, const Vector& expected) {
  for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(found[k], expected[k], 1e-12);
}

Vector random_pattern(Random& random) {
  Vector v;
  for (double& x : v) x = random.uniform(-1.5, 1.5);
  return v;
}

std::vector<double> random_degrees(Random& random) {
  std::vector<double> degrees(42);
  for (double& degree : degrees) degree = random.uniform();
  return degrees;
}

}  // namespace

// The memberships of figure 3.19 that are not 0 or 1, by hand from the sets: 0.10 is 1/2 Zero and 1/2 FwdL,
// 0.06 is 0.9 Zero and 0.1 FwdL, 0.79 is FwdM and 4/15 FwdH, 0.08 is 0.7 Zero and 0.3 FwdL; -0.28 is 1 BwdL,
// 0.65 and 0.73 are FwdM.

TEST_CASE("Turksen and Zhong: the rows of figure 3.19's patterns are 1 / (1 + D), by hand") {
  const auto similarity = [](double squares) { return 1 / (1 + std::sqrt(squares / 7)); };
  check_parts(parts("turksen_zhong", kTask, kWrench),
              {1, 1, similarity(1.5), similarity(1.82), similarity(16.0 / 225), similarity(0.18)});
}

TEST_CASE("Turksen and Zhong: D is the order 2 of Minkowski over the root of the number of sets") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector q = random_pattern(random), w = random_pattern(random);
    const Vector s = parts("turksen_zhong", q, w),
                 d = parts("minkowski", q, w, Value::table({{"order", 2.0}}));
    for (std::size_t k = 0; k < 6; ++k) CHECK_NEAR(1 / s[k] - 1, d[k] / std::sqrt(7.0), 1e-14);
  }
}

TEST_CASE("Turksen and Zhong: crisp complements are as far as can be, at one half each") {
  CHECK(row("turksen_zhong", {1, 0, 0, 1}, {0, 1, 1, 0}) == 0.5);
  const auto scale = registry().create<Similarity>("turksen_zhong")->scale(7);
  CHECK(scale.farthest == 3.0);
  CHECK(scale.nearest == 6.0);
}

TEST_CASE("Chen: the rows of figure 3.19's patterns are dot products over the longer one's, by hand") {
  check_parts(parts("chen_vector", kTask, kWrench), {1, 1, 0, 0, 1 / (1 + 16.0 / 225), 0.7});
}

TEST_CASE("Chen: a vector in the direction of another scores the ratio of their lengths") {
  CHECK_NEAR(row("chen_vector", {0.4, 0.2, 0.6}, {0.2, 0.1, 0.3}), 0.5, 1e-15);
  CHECK_NEAR(row("chen_vector", {0.2, 0.1, 0.3}, {0.4, 0.2, 0.6}), 0.5, 1e-15);
  // 3 x 5 of the right triangle: the dot product is 0.3 * 0.5 * 0.6.
  CHECK_NEAR(row("chen_vector", {0.3, 0.0}, {0.3, 0.4}), 0.09 / 0.25, 1e-15);
}

TEST_CASE("Chen: of nested memberships the outermost may be nearer, as its page says") {
  CHECK_NEAR(row("chen_vector", {0.5, 0}, {0.5, 1}), 1.0 / 5, 1e-15);
  CHECK_NEAR(row("chen_vector", {0.5, 0}, {1, 1}), 1.0 / 4, 1e-15);
}

TEST_CASE(
    "Subsethood: the rows of figure 3.19's patterns are the part of the task's that the wrench shares, by "
    "hand") {
  check_parts(parts("subsethood", kTask, kWrench), {1, 1, 0, 0, 1 / (1 + 4.0 / 15), 0.7});
  check_parts(parts("subsethood", kWrench, kTask), {1, 1, 0, 0, 1, 0.7});
}

TEST_CASE("Subsethood: what is shared is the same from both sides, and a superset holds all") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const auto q = random_degrees(random), w = random_degrees(random);
    std::vector<double> either(42);
    for (std::size_t j = 0; j < 42; ++j) either[j] = std::max(q[j], w[j]);
    const Vector there = parts_of("subsethood", 7, q, w), back = parts_of("subsethood", 7, w, q);
    const Vector all = parts_of("subsethood", 7, q, either);
    for (std::size_t k = 0; k < 6; ++k) {
      double size_q = 0.0, size_w = 0.0;
      for (std::size_t j = 7 * k; j < 7 * (k + 1); ++j) size_q += q[j], size_w += w[j];
      CHECK_NEAR(there[k] * size_q, back[k] * size_w, 1e-14);
      CHECK(all[k] == 1.0);
    }
  }
  CHECK(row("subsethood", {0, 0}, {0, 0}) == 1.0);
  CHECK(row("subsethood", {0, 0}, {1, 0}) == 1.0);
  CHECK(row("subsethood", {1, 0}, {0, 0}) == 0.0);
}

TEST_CASE("Subsethood: where the memberships of every number add up to 1 it is Dice's") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double a = random.uniform(), b = random.uniform();
    CHECK_NEAR(row("subsethood", {a, 1 - a, 0}, {0, b, 1 - b}), row("dice", {a, 1 - a, 0}, {0, b, 1 - b}),
               1e-14);
  }
}

TEST_CASE("Largest difference: the rows of figure 3.19's patterns, by hand") {
  check_parts(parts("largest_difference", kTask, kWrench), {1, 1, 0, 0, 11.0 / 15, 0.7});
}

TEST_CASE("Largest difference: it is one minus what a high order of Minkowski goes to") {
  Random random(4);
  const auto measure = registry().create<Similarity>("minkowski", Value::table({{"order", 100.0}}));
  const Vector crisp{};
  for (int i = 0; i < 100; ++i) {
    const auto q = random_degrees(random), w = random_degrees(random);
    Vector limit;
    measure->component_scores({1, 7, crisp.data(), q.data()}, {1, 7, crisp.data(), w.data()}, limit);
    const Vector found = parts_of("largest_difference", 7, q, w);
    // Of seven differences: at most 7^(1/100) of the largest.
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(1 - found[k] <= limit[k] + 1e-12);
      CHECK(limit[k] <= (1 - found[k]) * std::pow(7.0, 0.01) + 1e-12);
    }
  }
}

TEST_CASE("Measures of the comparisons refuse a membership that is not finite, and say in which component") {
  const Vector crisp{};
  Vector good{}, bad{};
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  for (const char* name : {"turksen_zhong", "chen_vector", "subsethood", "largest_difference"}) {
    double score = 0.0;
    const auto measure = registry().create<Similarity>(name);
    for (const auto& [q, w] : {std::pair(&good, &bad), std::pair(&bad, &good)}) {
      CHECK_THROWS_SAYING(
          measure->compare({1, 1, crisp.data(), q->data()}, {1, 1, crisp.data(), w->data()}, {&score, 1}),
          InputError, std::string(name) + "': component 4 has a membership that is not finite");
    }
  }
}

TEST_SUITE_END();
