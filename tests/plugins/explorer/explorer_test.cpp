#include <algorithm>
#include <cmath>

#include "landscape.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/explorer");

namespace {

const std::vector<const char*> kExplorers = {"beam", "exhaustive", "hill_climb"};

}  // namespace

TEST_CASE("Exhaustive: finds what a plain loop over planes, stations and finger counts finds") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Landscape landscape(rough(seed), {1, 2, 3});
    std::vector<Station> grid;
    for (int plane = 0; plane < 4; ++plane) {
      for (int k = -19; k <= 19; ++k) {
        for (int fingers = 1; fingers <= 3; ++fingers) grid.push_back({plane, k * 0.05, fingers});
      }
    }
    Station best;
    const StationScore score = best_of(landscape, grid, &best);
    landscape.asked.clear();
    const auto found = explorer("exhaustive")->explore(landscape, 1000000, seed, nullptr);
    CHECK(found.best == best);
    CHECK(same(found.score, score));
    CHECK(found.evaluations == static_cast<std::int64_t>(grid.size()));
    CHECK(landscape.asked.size() == grid.size());
    CHECK_FALSE(found.budget_spent);
  }
}

TEST_CASE("Exhaustive: a finer step never finds worse, for its grid holds the coarser one") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Landscape landscape(rough(seed));
    const auto coarse = explorer("exhaustive", Value::table({{"step", 0.1}}))->explore(landscape, 1000000, 1, nullptr);
    const auto fine = explorer("exhaustive", Value::table({{"step", 0.05}}))->explore(landscape, 1000000, 1, nullptr);
    CHECK_FALSE(coarse.score.better_than(fine.score));
  }
}

TEST_CASE("Explorers stay within the planes, the finger counts and the bounds of the approach value") {
  for (const char* name : kExplorers) {
    for (const double top : {-2.0, -0.95, 0.94, 0.95, 2.0}) {
      // The hill lies beyond the bounds: a search that follows it is led out, if it can be.
      const Landscape landscape(hill(3, top), {1, 3});
      const auto found = explorer(name)->explore(landscape, 1000000, 1, nullptr);
      CHECK(landscape.asked.size() == static_cast<std::size_t>(found.evaluations));
      for (const Station& s : landscape.asked) {
        CHECK((s.plane >= 0 && s.plane < 4));
        CHECK((s.virtual_fingers == 1 || s.virtual_fingers == 3));
        CHECK(std::abs(s.approach) <= 0.95 + 2 * kEps);  // 19 times 0.05
      }
      CHECK(found.best.plane == 3);
      CHECK_NEAR(found.best.approach, std::clamp(top, -0.95, 0.95), 0.025);
    }
  }
}

TEST_CASE("Explorers never ask for more stations than the budget, and say when it stopped them") {
  for (const char* name : kExplorers) {
    const Landscape whole(rough(5));
    const std::int64_t all = explorer(name)->explore(whole, 1000000, 1, nullptr).evaluations;
    for (const std::int64_t budget : {std::int64_t{0}, std::int64_t{1}, std::int64_t{5}, std::int64_t{29}, all - 1, all, all + 1}) {
      INFO(name, ", budget ", budget, " of ", all);
      const Landscape landscape(rough(5));
      const auto found = explorer(name)->explore(landscape, budget, 1, nullptr);
      CHECK(landscape.asked.size() == static_cast<std::size_t>(found.evaluations));
      CHECK(found.evaluations == std::min(budget, all));
      CHECK(found.budget_spent == (budget < all));
    }
  }
}

TEST_CASE("Explorers answer any time: the best of what was asked so far, and more budget never finds worse") {
  for (const char* name : kExplorers) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      StationScore before;
      for (std::int64_t budget = 0; budget <= 160; budget += 7) {
        const Landscape landscape(rough(seed));
        const auto found = explorer(name)->explore(landscape, budget, 1, nullptr);
        const std::vector<Station> asked = landscape.asked;
        CHECK(same(found.score, best_of(landscape, asked)));
        CHECK_FALSE(before.better_than(found.score));
        before = found.score;
      }
    }
  }
}

TEST_CASE("Explorers say that there is nothing where no station has a grasp") {
  for (const char* name : kExplorers) {
    const Landscape barren([](const Station&) { return StationScore{}; });
    const auto found = explorer(name)->explore(barren, 1000000, 1, nullptr);
    CHECK_FALSE(found.score.feasible());
    CHECK(found.evaluations > 0);
    CHECK_FALSE(found.budget_spent);
  }
}

TEST_CASE("Explorers let the second measure decide between stations that tie on the first") {
  for (const char* name : kExplorers) {
    const Landscape landscape([](const Station& s) {
      return StationScore{1.0, s.plane == 2 && std::abs(s.approach - 0.25) < 1e-9 ? 0.0 : -1.0};
    });
    const auto found = explorer(name)->explore(landscape, 1000000, 1, nullptr);
    CHECK(found.best.plane == 2);
    CHECK_NEAR(found.best.approach, 0.25, 1e-9);
  }
}

TEST_CASE("Beam: finds the top of a smooth hill to half its finest step, wherever it lies") {
  for (int plane = 0; plane < 4; ++plane) {
    for (double top = -0.95; top <= 0.95; top += 0.01) {
      const Landscape landscape(hill(plane, top));
      const auto found = explorer("beam")->explore(landscape, 1000000, 1, nullptr);
      INFO("plane ", plane, ", top ", top);
      CHECK(found.best.plane == plane);
      CHECK_NEAR(found.best.approach, top, 0.025 + 1e-9);
    }
  }
}

TEST_CASE("Beam: a finer last step comes as much nearer") {
  const Landscape landscape(hill(1, 0.4321));
  for (const double finest : {0.05, 0.0125, 0.003125}) {
    const auto found = explorer("beam", Value::table({{"finest", finest}}))->explore(landscape, 1000000, 1, nullptr);
    CHECK_NEAR(found.best.approach, 0.4321, finest / 2 + 1e-9);
  }
}

TEST_CASE("Beam: ends no worse than its first generation, which stands on every symbol of every plane") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Landscape landscape(rough(seed), {1, 2, 3});
    std::vector<Station> first;
    for (int plane = 0; plane < 4; ++plane) {
      for (const double x : landscape.symbol_stations()) {
        for (const int fingers : {1, 2, 3}) first.push_back({plane, x, fingers});
      }
    }
    const StationScore best = best_of(landscape, first);
    landscape.asked.clear();
    const auto found = explorer("beam")->explore(landscape, 1000000, seed, nullptr);
    CHECK_FALSE(best.better_than(found.score));
    REQUIRE(landscape.asked.size() >= first.size());
    for (const Station& s : first) {
      CHECK(std::find(landscape.asked.begin(), landscape.asked.begin() + static_cast<std::ptrdiff_t>(first.size()), s) !=
            landscape.asked.begin() + static_cast<std::ptrdiff_t>(first.size()));
    }
  }
}

TEST_CASE("Beam: costs a fraction of the whole grid and asks for no station twice in a generation") {
  const Landscape landscape(rough(3));
  const auto beam = explorer("beam")->explore(landscape, 1000000, 1, nullptr);
  const auto whole = explorer("exhaustive")->explore(Landscape(rough(3)), 1000000, 1, nullptr);
  CHECK(beam.evaluations < whole.evaluations);
  CHECK(beam.evaluations <= 4 * 7 + 3 * 2 * 8);  // symbols, then two neighbours of eight at three steps
}

TEST_CASE("Explorers without randomness give the same answer each time, whatever the seed") {
  for (const char* name : {"beam", "exhaustive"}) {
    const Landscape first(rough(9)), second(rough(9));
    const auto a = explorer(name)->explore(first, 1000000, 1, nullptr);
    const auto b = explorer(name)->explore(second, 1000000, 77, nullptr);
    CHECK(a.best == b.best);
    CHECK(same(a.score, b.score));
    CHECK(first.asked == second.asked);
  }
}

namespace {

struct Watch final : Progress {
  std::vector<double> fractions;
  void advance(std::string_view, double fraction, std::string_view) override { fractions.push_back(fraction); }
};

}  // namespace

TEST_CASE("Explorers tell how far they are, forwards, and end at the whole") {
  for (const char* name : kExplorers) {
    Watch watch;
    explorer(name)->explore(Landscape(rough(2)), 1000000, 1, &watch);
    REQUIRE_FALSE(watch.fractions.empty());
    CHECK(std::is_sorted(watch.fractions.begin(), watch.fractions.end()));
    CHECK(watch.fractions.back() == 1.0);
  }
}

TEST_SUITE_END();
