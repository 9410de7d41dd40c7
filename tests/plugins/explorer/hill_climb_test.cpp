// What hill climbing does beside what all explorers do (explorer_test.cpp).
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "landscape.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/explorer");

namespace {

constexpr std::int64_t kAmple = 1000000;

ExplorationResult climbed(const Landscape& landscape, std::uint64_t seed = 1, Value::Table parameters = {},
                          std::int64_t budget = kAmple) {
  return explorer("hill_climb", Value::table(std::move(parameters)))
      ->explore(landscape, budget, seed, nullptr);
}

/// The stations of all symbols, planes and finger counts.
std::vector<Station> symbol_grid(const Landscape& landscape) {
  std::vector<Station> grid;
  for (int plane = 0; plane < landscape.planes(); ++plane) {
    for (const double x : landscape.symbol_stations()) {
      for (const int fingers : landscape.finger_counts()) grid.push_back({plane, x, fingers});
    }
  }
  return grid;
}

}  // namespace

TEST_CASE("Hill climbing: finds the top of a smooth hill to half its finest step, wherever it lies") {
  for (int plane = 0; plane < 4; ++plane) {
    for (double top = -0.95; top <= 0.95; top += 0.01) {
      const auto found = climbed(Landscape(hill(plane, top)));
      INFO("plane ", plane, ", top ", top);
      CHECK(found.best.plane == plane);
      CHECK_NEAR(found.best.approach, top, 0.025 + 1e-9);
    }
  }
}

TEST_CASE("Hill climbing: a finer last step comes as much nearer") {
  const Landscape landscape(hill(1, 0.4321));
  for (const double finest : {0.05, 0.0125, 0.003125}) {
    CHECK_NEAR(climbed(landscape, 1, {{"finest", finest}}).best.approach, 0.4321, finest / 2 + 1e-9);
  }
}

TEST_CASE("Hill climbing: it walks on as far as it goes up, where the beam stops after its steps") {
  const auto far = [] { return Landscape(hill(2, 0.9), {0}, {-0.95}); };
  CHECK_NEAR(climbed(far()).best.approach, 0.9, 0.025 + 1e-9);
  CHECK(explorer("beam")->explore(far(), kAmple, 1, nullptr).best.approach < 0.0);
}

TEST_CASE("Hill climbing: it goes the steepest way, and changes the finger count where that is it") {
  // One finger leads from 0 to 0.4, and only there three have a peak, higher than the one for two.
  const Landscape landscape(
      [](const Station& s) {
        const double off = std::abs(s.approach - 0.4);
        if (s.plane != 0) return StationScore{};
        return StationScore{s.virtual_fingers == 1 ? -off : off < 0.01 ? s.virtual_fingers : -5.0, 0.0};
      },
      {1, 2, 3}, {0.0});
  const auto found = climbed(landscape, 1, {{"restarts", 1}});
  CHECK(found.best.virtual_fingers == 3);
  CHECK_NEAR(found.best.approach, 0.4, 1e-9);
}

TEST_CASE("Hill climbing: what it ends with is no worse than any of its neighbours at the finest step") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Landscape landscape(rough(seed), {1, 2, 3});
    const auto found = climbed(landscape, seed);
    const Station& b = found.best;
    std::vector<Station> near;
    for (const double x : {b.approach - 0.05, b.approach + 0.05})
      near.push_back({b.plane, std::clamp(x, -0.95, 0.95), b.virtual_fingers});
    for (const int fingers : {1, 2, 3}) near.push_back({b.plane, b.approach, fingers});
    CHECK_FALSE(best_of(landscape, near).better_than(found.score));
  }
}

TEST_CASE(
    "Hill climbing: it looks at every symbol of every plane first, in an order of the seed, and at no "
    "station twice") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Landscape landscape(rough(seed), {1, 2, 3}), other(rough(seed), {1, 2, 3});
    climbed(landscape, seed), climbed(other, seed + 1);
    const auto grid = symbol_grid(landscape);
    const auto last = static_cast<std::ptrdiff_t>(grid.size());
    REQUIRE(landscape.asked.size() >= grid.size());
    CHECK(std::is_permutation(grid.begin(), grid.end(), landscape.asked.begin(),
                              landscape.asked.begin() + last));
    CHECK_FALSE(std::equal(grid.begin(), grid.end(), landscape.asked.begin()));
    CHECK_FALSE(std::equal(landscape.asked.begin(), landscape.asked.begin() + last, other.asked.begin()));
    std::map<std::tuple<int, long, int>, int> count;
    for (const Station& s : landscape.asked)
      CHECK(++count[{s.plane, std::lround(s.approach * 1e6), s.virtual_fingers}] == 1);
  }
}

TEST_CASE("Hill climbing: the same seed asks the same stations, a smaller budget the first of them") {
  const Landscape whole(rough(9)), again(rough(9)), part(rough(9));
  climbed(whole, 5), climbed(again, 5), climbed(part, 5, {}, 40);
  CHECK(whole.asked == again.asked);
  REQUIRE(part.asked.size() == 40);
  CHECK(std::equal(part.asked.begin(), part.asked.end(), whole.asked.begin()));
}

TEST_CASE("Hill climbing: it climbs from the best starts alone, and more restarts never find worse") {
  // One broad hill around 0, and a high peak that only the worst start leads to.
  const auto score = [](const Station& s) {
    if (s.plane != 1) return StationScore{-20.0, 0.0};
    return StationScore{std::abs(s.approach + 0.75) < 0.01 ? 10.0 : -std::abs(s.approach - 0.01), 0.0};
  };
  CHECK(climbed(Landscape(score), 1, {{"restarts", 1}}).best.approach == 0.0);
  CHECK(climbed(Landscape(score), 1, {{"restarts", 6}}).best.approach == 0.0);
  CHECK(climbed(Landscape(score), 1, {{"restarts", 7}}).score.first == 10.0);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    StationScore before;
    std::int64_t cost = 0;
    for (const int restarts : {1, 2, 8, 40}) {
      const auto found = climbed(Landscape(rough(seed)), seed, {{"restarts", restarts}});
      CHECK_FALSE(before.better_than(found.score));
      CHECK(found.evaluations >= cost);
      before = found.score, cost = found.evaluations;
    }
  }
}

TEST_CASE("Hill climbing: a start without a grasp leads to a neighbour that has one") {
  const Landscape landscape(
      [](const Station& s) {
        return s.plane == 0 && s.approach > 0.05 && s.approach < 0.15 ? StationScore{1.0, 0.0}
                                                                      : StationScore{};
      },
      {0}, {0.0});
  const auto found = climbed(landscape);
  CHECK(found.score.feasible());
  CHECK_NEAR(found.best.approach, 0.1, 1e-9);
}

TEST_SUITE_END();
