#include <stdexcept>

#include "components.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

/// Highest at plane 2 (from 0), approach 0.3; the other planes have no grasp beyond 0.5.
class Hill final : public ExplorationProblem {
 public:
  int planes() const noexcept override { return 4; }
  std::span<const double> symbol_stations() const noexcept override { return symbols_; }
  double lowest_approach() const noexcept override { return -0.95; }
  double highest_approach() const noexcept override { return 0.95; }
  std::span<const int> finger_counts() const noexcept override { return counts_; }
  std::span<const double> transverse_offsets() const noexcept override { return offsets_; }
  void evaluate(std::span<const Station> stations, std::span<StationScore> scores) const override {
    evaluated += static_cast<int>(stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Station& s = stations[i];
      scores[i] = s.plane != 2 && std::abs(s.approach) > 0.5
                      ? StationScore{}
                      : StationScore{-std::abs(s.plane - 2) - std::abs(s.approach - 0.3), 0.1 * s.virtual_fingers};
    }
  }
  mutable int evaluated = 0;

 private:
  std::vector<double> symbols_ = {-0.8, 0.0, 0.8};
  std::vector<int> counts_ = {1, 2, 3};
  std::vector<double> offsets_ = {0.0, 0.5};
};

constexpr const char* kGrid =
    "return { explore = function(problem, budget, seed)\n"
    "  local best, station\n"
    "  for plane = 1, problem.planes do\n"
    "    local stations = {}\n"
    "    for _, x in ipairs(problem.symbol_stations) do stations[#stations + 1] = { plane = plane, approach = x, virtual_fingers = problem.finger_counts[2] } end\n"
    "    local scores = problem.evaluate(stations)\n"
    "    if not scores then return station end\n"
    "    for i, score in ipairs(scores) do\n"
    "      if score.feasible and (not best or score.first > best) then best, station = score.first, stations[i] end\n"
    "    end\n"
    "  end\n"
    "  return station\n"
    "end }";

ExplorationResult explore(const std::string& inside, std::int64_t budget, const Hill& hill = {}, std::uint64_t seed = 1) {
  const OneComponent component("explorer", "x", inside);
  return component->create<Explorer>("x")->explore(hill, budget, seed, nullptr);
}

std::string failing(const std::string& body) {
  try {
    explore("return { explore = function(problem, budget, seed)\n " + body + "\nend }", 10);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua explorer: it finds the best of its stations, and the adapter counts them") {
  const auto result = explore(kGrid, 100);
  CHECK(result.best == Station{2, 0.0, 2});
  CHECK_NEAR(result.score.first, -0.3, kEps);
  CHECK(result.evaluations == 12);
  CHECK_FALSE(result.budget_spent);
}

TEST_CASE("Lua explorer: beyond the budget nothing is evaluated, and the best so far stands") {
  Hill hill;
  const auto result = explore(kGrid, 5, hill);
  CHECK(hill.evaluated == 5);
  CHECK(result.evaluations == 5);
  CHECK(result.budget_spent);
  CHECK(result.best == Station{1, 0.0, 2});
  const auto nothing = explore(kGrid, 0);
  CHECK(nothing.evaluations == 0);
  CHECK_FALSE(nothing.score.feasible());
}

TEST_CASE("Lua explorer: the best evaluated station counts, whatever is returned; a new one is evaluated") {
  const std::string all = "problem.evaluate({ { plane = 3, approach = 0.25 }, { plane = 1, approach = 0 } })\n";
  CHECK(explore("return { explore = function(problem) " + all + "return { plane = 1, approach = 0 } end }", 9).best == Station{2, 0.25, 1});
  CHECK(explore("return { explore = function(problem) " + all + "end }", 9).best == Station{2, 0.25, 1});
  const auto later = explore("return { explore = function(problem) " + all + "return { plane = 3, approach = 0.3 } end }", 9);
  CHECK(later.best == Station{2, 0.3, 1});
  CHECK(later.evaluations == 3);
  const auto none = explore("return { explore = function(problem) problem.evaluate({ { plane = 1, approach = 0.9 } }) end }", 9);
  CHECK_FALSE(none.score.feasible());
}

TEST_CASE("Lua explorer: its randomness is the seed's") {
  const std::string random = "return { explore = function(problem, budget)\n for i = 1, budget do problem.evaluate({ { plane = 3, approach = 1.8 * math.random() - 0.9 } }) end\nend }";
  const auto a = explore(random, 20, {}, 5), b = explore(random, 20, {}, 5), c = explore(random, 20, {}, 6);
  CHECK(a.best == b.best);
  CHECK_FALSE(a.best == c.best);
}

TEST_CASE("Lua explorer: what the progress throws goes through, also where the script catches errors") {
  struct Stopping final : Progress {
    void advance(std::string_view, double, std::string_view) override { throw std::out_of_range("stopped by the person"); }
  } stopping;
  const OneComponent component("explorer", "x", "return { explore = function(problem)\n for i = 1, 3 do pcall(problem.evaluate, { { plane = 1, approach = 0 } }) end\nend }");
  const auto explorer = component->create<Explorer>("x");
  const Hill hill;
  CHECK_THROWS_AS(explorer->explore(hill, 9, 1, &stopping), std::out_of_range);
  CHECK(hill.evaluated == 1);
  CHECK(explorer->explore(hill, 9, 1, nullptr).evaluations == 3);
}

TEST_CASE("Lua explorer: stations out of bounds, and functions kept for later, are errors with file and line") {
  CHECK(failing("problem.evaluate({ { plane = 5, approach = 0 } })").find("x.plugin.lua:5: station: 'plane' must be in 1 .. 4, got 5") != std::string::npos);
  CHECK(failing("problem.evaluate({ { plane = 1, approach = 1 } })").find("x.plugin.lua:5: station: 'approach' must be in -0.95 .. 0.95, got 1") != std::string::npos);
  CHECK(failing("problem.evaluate({ { plane = 1, approach = 0, virtual_fingers = 0 } })").find("'virtual_fingers' must be one of finger_counts, got 0") != std::string::npos);
  CHECK(failing("problem.evaluate({ { plane = 1, aproach = 0 } })").find("unknown key 'aproach'; did you mean 'approach'?") != std::string::npos);
  CHECK(failing("problem.evaluate(3)").find("x.plugin.lua:5: evaluate: expected a list of stations, got number") != std::string::npos);
  CHECK(failing("return { plane = 9, approach = 0 }").find("station: 'plane' must be in 1 .. 4, got 9") != std::string::npos);
  const OneComponent component("explorer", "x", "local kept\nreturn { explore = function(problem)\n kept = kept or problem.evaluate\n kept({})\nend }");
  const auto explorer = component->create<Explorer>("x");
  CHECK_NOTHROW(explorer->explore(Hill(), 3, 1, nullptr));
  CHECK_THROWS_SAYING(explorer->explore(Hill(), 3, 1, nullptr), ScriptError, "x.plugin.lua:7: evaluate: it can be called only during the call that it was given to");
}

TEST_SUITE_END();
