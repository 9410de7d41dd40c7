#include "preshape/fuzzy/partition_findings.h"

#include <cmath>
#include <limits>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/fuzzy");

namespace {

using Shape = Membership::Shape;

Membership set(const char* name, Shape shape, std::vector<double> points) {
  return {name, shape, std::move(points), false, false};
}

/// Shoulders at both ends, as scripts make them.
FuzzyPartition shouldered(std::vector<Membership> sets) {
  sets.front().open_below = true;
  sets.back().open_above = true;
  return FuzzyPartition(std::move(sets));
}

/// Triangles with tops at whole numbers that add up to 1.
FuzzyPartition ruspini(int count) {
  std::vector<Membership> sets;
  for (int i = 0; i < count; ++i) sets.push_back(set(fmt::format("s{}", i).c_str(), Shape::kTriangle, {i - 1.0, i + 0.0, i + 1.0}));
  return shouldered(std::move(sets));
}

Membership random_set(Random& random, int number) {
  const double x = random.uniform(-1, 1), a = random.uniform(0.02, 0.5), b = random.uniform(0.0, 0.5), c = random.uniform(0.0, 0.5);
  const std::string name = fmt::format("s{}", number);
  switch (random.below(5)) {
    case 0: return set(name.c_str(), Shape::kTrapezoid, {x - a - b, x - b, x + b, x + b + c});
    case 1: return set(name.c_str(), Shape::kTriangle, {x - a, x, x + b});
    case 2: return set(name.c_str(), Shape::kGaussian, {x, a});
    case 3: return set(name.c_str(), Shape::kBell, {a, 0.5 + 4 * b, x});
    default: return set(name.c_str(), Shape::kSigmoid, {random.below(2) ? 2 / a : -2 / a, x});
  }
}

double best_degree(const FuzzyPartition& partition, double x) { return partition[partition.best(x)](x); }

double sum_at(const FuzzyPartition& partition, double x) {
  double sum = 0.0;
  for (const auto& s : partition.sets()) sum += s(x);
  return sum;
}

}  // namespace

TEST_CASE("Alpha-cut: its ends have the degree, inside is more and outside less") {
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const Membership s = random_set(random, i);
    const double degree = random.uniform(0.05, 0.95);
    const Interval cut = alpha_cut(s, degree);
    REQUIRE_FALSE(cut.empty());
    for (const double end : {cut.from, cut.to}) {
      if (!std::isfinite(end)) continue;
      const double inwards = end == cut.from ? 1e-7 : -1e-7;
      INFO("shape ", static_cast<int>(s.shape), ", degree ", degree, ", end ", end);
      CHECK(s(end + inwards) >= degree - 1e-12);
      CHECK(s(end - inwards) <= degree + 1e-12);
    }
  }
}

TEST_CASE("Alpha-cut: a shoulder goes on without end, a top is a cut at 1, and a sigmoid never reaches 1") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Membership s = set("s", Shape::kTrapezoid, {0, 1, 2, 4});
  CHECK(alpha_cut(s, 1.0) == Interval{1, 2});
  CHECK(alpha_cut(s, 0.5) == Interval{0.5, 3});
  s.open_below = true;
  CHECK(alpha_cut(s, 0.5) == Interval{-kInfinity, 3});
  CHECK(alpha_cut(set("g", Shape::kGaussian, {0.5, 0.1}), 1.0) == Interval{0.5, 0.5});
  CHECK(alpha_cut(set("up", Shape::kSigmoid, {3, 0.5}), 0.5) == Interval{0.5, kInfinity});
  CHECK(alpha_cut(set("down", Shape::kSigmoid, {-3, 0.5}), 0.5) == Interval{-kInfinity, 0.5});
  CHECK(alpha_cut(set("up", Shape::kSigmoid, {3, 0.5}), 1.0).empty());
}

TEST_CASE("Findings: the thesis's seven sets are complete to a half and cross at 0.6, 0.5, 0.5, 0.5, 0.5, 0.6") {
  const auto partition = FuzzyPartition::thesis();
  CHECK(span_of(partition) == Interval{-1.2, 1.2});
  const auto found = findings_of(partition, {-1.2, 1.2});
  CHECK(found.fine());
  CHECK(sentences(found, partition).empty());
  REQUIRE(found.crossings.size() == 6);
  const double heights[] = {0.6, 0.5, 0.5, 0.5, 0.5, 0.6}, places[] = {-0.84, -0.425, -0.1, 0.1, 0.425, 0.84};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK_NEAR(found.crossings[i].height, heights[i], 1e-14);
    CHECK_NEAR(found.crossings[i].x, places[i], 1e-14);
  }
  // At 0.8 FwdM still is 1 and FwdH has risen by a third; elsewhere sides that face each other add up to 1.
  CHECK_NEAR(found.most_sum, 4.0 / 3.0, 1e-12);
  CHECK_NEAR(found.least_sum, 1.0, 1e-12);
}

TEST_CASE("Findings: a bound over the lowest crossing opens a gap around it, as wide as the sides say") {
  const auto partition = FuzzyPartition::thesis();
  const auto found = findings_of(partition, {-1.2, 1.2}, 0.55);
  REQUIRE(found.gaps.size() == 4);
  // RwdM falls from 1 to 0 over 0.15, RwdL rises likewise: 0.05 of that to either side.
  CHECK_NEAR(found.gaps[0].where.from, -0.425 - 0.05 * 0.15, 1e-14);
  CHECK_NEAR(found.gaps[0].where.to, -0.425 + 0.05 * 0.15, 1e-14);
  CHECK_NEAR(found.gaps[0].lowest, 0.5, 1e-9);
}

TEST_CASE("Findings: a gap is found with its ends, however narrow") {
  for (const double width : {0.3, 1e-3, 1e-7}) {
    const auto partition = shouldered({set("low", Shape::kTrapezoid, {-1, -1, -0.5, 0}),
                                       set("high", Shape::kTrapezoid, {width, width, 1, 1})});
    const auto found = findings_of(partition, span_of(partition), 0.01);
    REQUIRE(found.gaps.size() == 1);
    CHECK_NEAR(found.gaps[0].where.from, -0.01 * 0.5, 1e-14);
    CHECK_NEAR(found.gaps[0].where.to, width, 1e-14);
    CHECK_NEAR(found.gaps[0].lowest, 0.0, 1e-9);
    CHECK(found.crossings[0].height == 0.0);
    CHECK(std::isnan(found.crossings[0].x));
    CHECK_NEAR(found.least_sum, 0.0, 1e-4);
  }
  const auto partition = shouldered({set("low", Shape::kTrapezoid, {-1, -1, -0.5, 0}), set("high", Shape::kTrapezoid, {0.25, 0.5, 1, 1})});
  const auto told = sentences(findings_of(partition, span_of(partition)), partition);
  REQUIRE(told.size() == 1);
  CHECK(told[0] == "between -0.25 and 0.375 no set reaches 0.5; the best one's degree falls to 0 there");
}

TEST_CASE("Findings: Gaussian sets cross half way, at exp(-d^2 / 8 s^2)") {
  const double sigma = 0.2;
  for (const double d : {0.3, 0.2 * 2 * std::sqrt(2 * std::log(2.0)) - 1e-6, 0.6}) {
    const auto partition = shouldered({set("a", Shape::kGaussian, {0, sigma}), set("b", Shape::kGaussian, {d, sigma})});
    const auto found = findings_of(partition, span_of(partition));
    CHECK_NEAR(found.crossings[0].height, std::exp(-d * d / (8 * sigma * sigma)), 1e-12);
    CHECK_NEAR(found.crossings[0].x, d / 2, 1e-9);
    CHECK(found.gaps.empty() == (found.crossings[0].height >= 0.5));
    if (!found.gaps.empty()) {
      CHECK_NEAR(found.gaps[0].where.from, sigma * std::sqrt(2 * std::log(2.0)), 1e-12);
      CHECK_NEAR(found.gaps[0].lowest, found.crossings[0].height, 1e-7);
    }
  }
}

TEST_CASE("Findings: bells cross half way, at 1 / (1 + (d / 2 w)^2s); sigmoids of opposite ways at their common crossing") {
  const auto bells = shouldered({set("a", Shape::kBell, {0.5, 2, 0}), set("b", Shape::kBell, {0.5, 2, 2})});
  CHECK_NEAR(findings_of(bells, span_of(bells)).crossings[0].height, 1.0 / 17.0, 1e-12);
  const auto slopes = shouldered({set("down", Shape::kSigmoid, {-4, 0.3}), set("up", Shape::kSigmoid, {4, 0.3})});
  const auto found = findings_of(slopes, span_of(slopes));
  CHECK_NEAR(found.crossings[0].height, 0.5, 1e-12);
  CHECK_NEAR(found.crossings[0].x, 0.3, 1e-12);
  CHECK(found.gaps.empty());
  // A slope and its mirror image make a Ruspini partition.
  CHECK_NEAR(found.least_sum, 1.0, 1e-12);
  CHECK_NEAR(found.most_sum, 1.0, 1e-12);
}

TEST_CASE("Findings: triangles that share feet and tops add up to 1 and have nothing to be told") {
  const auto partition = ruspini(6);
  const auto found = findings_of(partition, span_of(partition));
  CHECK(found.fine());
  for (const Crossing& crossing : found.crossings) CHECK_NEAR(crossing.height, 0.5, 1e-14);
  const auto inside = findings_of(partition, {0, 5});
  CHECK_NEAR(inside.least_sum, 1.0, 1e-12);
  CHECK_NEAR(inside.most_sum, 1.0, 1e-12);
}

TEST_CASE("Findings: sets that crowd, that are never best and that stand out of order are told by name") {
  const auto partition = shouldered({set("low", Shape::kTrapezoid, {-1, -1, 0, 0.5}), set("wide", Shape::kTrapezoid, {-0.5, -0.25, 0.5, 1}),
                                     set("lost", Shape::kTriangle, {-0.2, 0.0, 0.2}), set("high", Shape::kTrapezoid, {0, 0.5, 1, 1})});
  const auto found = findings_of(partition, span_of(partition));
  CHECK(found.never_best == std::vector<int>{2});
  CHECK(found.out_of_order == std::vector<int>{2});
  const auto told = sentences(found, partition);
  REQUIRE(told.size() >= 4);
  CHECK(told[0] == "'low' and 'wide' are both 1 at -0.125; the first of them counts there");
  CHECK(told[1] == "'low' and 'lost', which are no neighbours, both reach 1 at 0");
  CHECK(told[told.size() - 2] == "'lost' is nowhere the best set");
  CHECK(told.back() == "'lost' comes after 'wide' but its top is not above that one's; list the sets from low to high");
}

TEST_CASE("Findings: crisp intervals that touch at a point do not crowd") {
  const auto partition = shouldered({set("low", Shape::kTrapezoid, {-1, -1, 0, 0}), set("high", Shape::kTrapezoid, {0, 0, 1, 1})});
  CHECK(findings_of(partition, span_of(partition)).fine());
}

TEST_CASE("Findings: of random families of all shapes they say what a fine sampling sees") {
  Random random(2);
  int with_gaps = 0, with_lost = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<Membership> sets;
    for (int k = 0; k < 5; ++k) sets.push_back(random_set(random, k));
    const FuzzyPartition partition(std::move(sets));
    const Interval universe{-1.5, 1.5};
    const double bound = random.uniform(0.1, 0.9);
    const auto found = findings_of(partition, universe, bound);
    std::vector<int> seen(5, 0);
    int wrong_degrees = 0, wrong_sums = 0;
    for (int k = 0; k <= 20000; ++k) {
      const double x = universe.from + universe.width() * k / 20000, degree = best_degree(partition, x), sum = sum_at(partition, x);
      ++seen[static_cast<std::size_t>(partition.best(x))];
      bool in_gap = false, at_an_end = false;
      for (const Gap& gap : found.gaps) {
        at_an_end = at_an_end || std::min(std::abs(x - gap.where.from), std::abs(x - gap.where.to)) < 1e-9;
        in_gap = in_gap || (x > gap.where.from && x < gap.where.to && degree >= gap.lowest - 1e-6);
      }
      wrong_degrees += !at_an_end && in_gap != (degree < bound);
      wrong_sums += sum < found.least_sum - 1e-4 || sum > found.most_sum + 1e-4;
    }
    CHECK(wrong_degrees == 0);
    CHECK(wrong_sums == 0);
    for (const Crossing& crossing : found.crossings) {
      if (crossing.height == 0.0) continue;
      CHECK_NEAR(std::min(partition[crossing.first](crossing.x), partition[crossing.second](crossing.x)), crossing.height, 1e-6);
    }
    for (const int lost : found.never_best) CHECK(seen[static_cast<std::size_t>(lost)] <= 2);  // less than is looked at
    with_lost += !found.never_best.empty();
    with_gaps += !found.gaps.empty();
  }
  CHECK(with_gaps > 10);
  CHECK(with_lost > 3);
}

TEST_CASE("Findings: a bound outside 0 .. 1 and a universe without width are refused") {
  const auto partition = FuzzyPartition::thesis();
  CHECK_THROWS_SAYING(findings_of(partition, {-1, 1}, 0.0), InputError, "above 0 and at most 1, got 0");
  CHECK_THROWS_SAYING(findings_of(partition, {-1, 1}, NAN), InputError, "the bound of completeness");
  CHECK_THROWS_SAYING(findings_of(partition, {1, 1}), InputError, "an interval of a finite width, got 1 .. 1");
  CHECK_THROWS_SAYING(findings_of(partition, {0, INFINITY}), InputError, "an interval of a finite width");
}

TEST_SUITE_END();
