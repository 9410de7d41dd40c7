#include <array>
#include <cmath>

#include "preshape/base/random.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/similarity");

namespace {

using Vector = std::array<double, 6>;

double score(const Similarity& measure, const Vector& q, const Vector& w) {
  static const auto partition = FuzzyPartition::thesis();
  const Patterns task(partition, q), pattern(partition, w);
  double value = 0;
  measure.compare(task.view(), pattern.view(), {&value, 1});
  return value;
}

Vector random_pattern(Random& random) {
  Vector v;
  for (double& x : v) x = random.uniform(-1.5, 1.5);
  return v;
}

const Vector kTask = {1.14, 1.02, 0.10, 0.06, 0.79, 0.08};
const Vector kWrench = {2.3, 1, -0.28, 0.65, 0.73, -0.0016};

}  // namespace

TEST_CASE("TFVADI: figure 3.19 has the rows 1, 1, 0, 0, 1, 0.7 and the sum 3.7") {
  const auto measure = registry().create<Similarity>("tfvadi");
  const auto partition = FuzzyPartition::thesis();
  const Patterns task(partition, kTask), pattern(partition, kWrench);
  std::array<double, 6> rows;
  measure->component_scores(task.view(), pattern.view(), rows);
  const std::array<double, 6> expected = {1, 1, 0, 0, 1, 0.7};
  for (std::size_t i = 0; i < 6; ++i) CHECK_NEAR(rows[i], expected[i], 1e-12);
  CHECK_NEAR(score(*measure, kTask, kWrench), 3.7, 1e-12);
}

TEST_CASE("TFDist: figure 3.19 has the rows 0, 0, 1.2247, 1.3491, 0.2667, 0.4243, whose sum prints as 3.2648") {
  const auto measure = registry().create<Similarity>("tfdist");
  const auto partition = FuzzyPartition::thesis();
  const Patterns task(partition, kTask), pattern(partition, kWrench);
  std::array<double, 6> rows;
  measure->component_scores(task.view(), pattern.view(), rows);
  const std::array<double, 6> expected = {0, 0, std::sqrt(1.5), std::sqrt(1.82), 4.0 / 15.0, std::sqrt(0.18)};
  for (std::size_t i = 0; i < 6; ++i) CHECK_NEAR(rows[i], expected[i], 1e-12);
  // The printed sum adds rows rounded to four digits: four halves of the last digit at most.
  CHECK_NEAR(score(*measure, kTask, kWrench), 3.2648, 2e-4);
}

TEST_CASE("TFVADI and TFDist: symmetric, within their range, and the batch equals the single calls") {
  for (const char* name : {"tfvadi", "tfdist"}) {
    const auto measure = registry().create<Similarity>(name);
    const auto scale = measure->scale(7);
    const auto [low, high] = std::minmax(scale.farthest, scale.nearest);
    const auto partition = FuzzyPartition::thesis();
    Random random(1);
    const Vector q = random_pattern(random);
    Patterns batch(partition);
    std::vector<double> single;
    for (int i = 0; i < 500; ++i) {
      const Vector w = random_pattern(random);
      batch.add(w);
      single.push_back(score(*measure, q, w));
      CHECK(score(*measure, w, q) == single.back());
      CHECK_MESSAGE((single.back() >= low && single.back() <= high), name);
    }
    std::vector<double> scores(500);
    const Patterns task(partition, q);
    measure->compare(task.view(), batch.view(), scores);
    CHECK(scores == single);
  }
}

TEST_CASE("TFDist: it is zero between equal patterns only where memberships are equal, and obeys the triangle inequality") {
  const auto measure = registry().create<Similarity>("tfdist");
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vector a = random_pattern(random), b = random_pattern(random), c = random_pattern(random);
    CHECK(score(*measure, a, a) == 0.0);
    CHECK(score(*measure, a, c) <= score(*measure, a, b) + score(*measure, b, c) + 1e-12);
  }
}

TEST_CASE("TFVADI: a pattern's index with itself is the sum of its heights") {
  const auto measure = registry().create<Similarity>("tfvadi");
  CHECK_NEAR(score(*measure, {1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}), 6.0, 1e-12);
  CHECK_NEAR(score(*measure, {0.1, 1, 1, 1, 1, 1}, {0.1, 1, 1, 1, 1, 1}), 5.5, 1e-12);
}

TEST_SUITE_END();
