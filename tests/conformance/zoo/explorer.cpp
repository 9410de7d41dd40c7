// Explorers that are broken on purpose: each fails the check that its name begins with, and nothing else.
#include <algorithm>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

enum class Fault {
  kNone,
  kOverBudget,
  kInvents,
  kMiscounts,
  kForgetsFingers,
  kMovesTheBest,
  kTakesTheLowest,
  kIgnoresSecond,
  kNeverSpent,
  kBeginsAnywhere,
  kSkipsAPlane,
  kAlwaysFinds,
  kNeedsRoom,
  kTellsPercent,
  kSwallows,
  kTooMuchRoom,
  kLooksNowhere,
};

/// Asks for the symbols' grid, plane by plane, and breaks one rule.
template <Fault fault>
class Grid final : public Explorer {
 public:
  static std::vector<std::string> capabilities() {
    if constexpr (fault == Fault::kNone) return {"anytime", "exhaustive"};
    if constexpr (fault == Fault::kBeginsAnywhere) return {"anytime"};
    if constexpr (fault == Fault::kSkipsAPlane) return {"exhaustive"};
    return {};
  }
  explicit Grid(const Parameters&) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t,
                            Progress* progress) const override {
    if (fault == Fault::kNeedsRoom && problem.lowest_approach() == problem.highest_approach()) {
      throw InputError("the approach has no width");
    }
    ExplorationResult result;
    if (fault == Fault::kInvents && budget == 0) result.score = {0.0, 0.0};
    for (int i = 0; i < planes(problem) && !result.budget_spent; ++i) {
      visit(problem, plane_at(i, problem, budget), budget, result);
      if (fault == Fault::kOverBudget && i + 1 == planes(problem) && result.evaluations > budget)
        result.budget_spent = false;
      const double fraction = (i + 1.0) / problem.planes();
      if (progress)
        progress->advance("exploring", fault == Fault::kTellsPercent ? 100 * fraction : fraction, "");
    }
    if (fault == Fault::kMiscounts && result.budget_spent) ++result.evaluations;
    if (fault == Fault::kNeverSpent) result.budget_spent = false;
    if (fault == Fault::kMovesTheBest) result.best.approach *= 0.999;
    if (fault == Fault::kAlwaysFinds && result.evaluations > 0 && !result.score.feasible())
      result.score = {-1e9, 0.0};
    return result;
  }

 private:
  static int planes(const ExplorationProblem& problem) {
    if (fault == Fault::kLooksNowhere) return 0;
    return fault == Fault::kSkipsAPlane ? std::max(1, problem.planes() - 1) : problem.planes();
  }

  static int plane_at(int i, const ExplorationProblem& problem, std::int64_t budget) {
    return fault == Fault::kBeginsAnywhere ? static_cast<int>((i + budget) % problem.planes()) : i;
  }

  static bool better(const StationScore& a, const StationScore& b) {
    if (fault == Fault::kIgnoresSecond) return a.first > b.first;
    if (fault == Fault::kTakesTheLowest && a.feasible() && b.feasible() && a.first != b.first)
      return a.first < b.first;
    return a.better_than(b);
  }

  static std::vector<Station> stations_of(const ExplorationProblem& problem, int plane) {
    std::vector<Station> stations;
    for (const double x : problem.symbol_stations()) {
      for (const int count : problem.finger_counts()) {
        for (const double offset : problem.transverse_offsets()) {
          stations.push_back({plane, x, fault == Fault::kForgetsFingers ? 0 : count, offset});
        }
      }
    }
    return stations;
  }

  static void visit(const ExplorationProblem& problem, int plane, std::int64_t budget,
                    ExplorationResult& result) {
    auto stations = stations_of(problem, plane);
    const auto left = static_cast<std::size_t>(budget - std::min(budget, result.evaluations));
    if (stations.size() > left) {
      result.budget_spent = true;
      if (fault != Fault::kOverBudget || left == 0) stations.resize(left);
    }
    std::vector<StationScore> scores(stations.size() + (fault == Fault::kTooMuchRoom ? 1 : 0));
    try {
      problem.evaluate(stations, scores);
    } catch (const Error&) {
      if (fault != Fault::kSwallows) throw;
    }
    result.evaluations += std::ssize(stations);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (better(scores[i], result.score)) result.best = stations[i], result.score = scores[i];
    }
  }
};

/// Asks for stations drawn from the seed, one by one: another honest search.
class Lottery final : public Explorer {
 public:
  static std::vector<std::string> capabilities() { return {"anytime"}; }
  explicit Lottery(const Parameters&) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t seed,
                            Progress*) const override {
    constexpr std::int64_t kDraws = 200;
    Random random(seed);
    ExplorationResult result;
    const auto counts = problem.finger_counts();
    const auto offsets = problem.transverse_offsets();
    while (result.evaluations < std::min(budget, kDraws)) {
      const Station station{static_cast<int>(random.below(static_cast<std::uint64_t>(problem.planes()))),
                            random.uniform(problem.lowest_approach(), problem.highest_approach()),
                            counts[random.below(counts.size())], offsets[random.below(offsets.size())]};
      StationScore score;
      problem.evaluate({&station, 1}, {&score, 1});
      ++result.evaluations;
      if (score.better_than(result.score)) result.best = station, result.score = score;
    }
    result.budget_spent = budget < kDraws;
    return result;
  }
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"zoo_explorer", "1.0.0", "BSD-3-Clause", "the preshape developers", "Broken explorers"}),
    ({"explorer/good", "explorer/good_lottery", "explorer/x01_over_budget", "explorer/x02_invents",
      "explorer/x03_miscounts", "explorer/x04_forgets_fingers", "explorer/x05_moves_the_best",
      "explorer/x06_takes_the_lowest", "explorer/x07_ignores_second", "explorer/x08_never_spent",
      "explorer/x09_begins_anywhere", "explorer/x10_skips_a_plane", "explorer/x11_always_finds",
      "explorer/x12_needs_room", "explorer/x13_tells_percent", "explorer/x14_swallows",
      "explorer/x15_too_much_room", "explorer/x16_looks_nowhere"}),
    component<Grid<Fault::kNone>>("good", "The symbols' grid"),
    component<Lottery>("good_lottery", "Stations drawn by chance"),
    component<Grid<Fault::kOverBudget>>("x01_over_budget", "Ends the plane that it is in"),
    component<Grid<Fault::kInvents>>("x02_invents", "Tells a score without having asked"),
    component<Grid<Fault::kMiscounts>>("x03_miscounts", "Counts the station that it did not ask"),
    component<Grid<Fault::kForgetsFingers>>("x04_forgets_fingers", "Asks with the rules' finger count only"),
    component<Grid<Fault::kMovesTheBest>>("x05_moves_the_best", "Tells a station beside the best"),
    component<Grid<Fault::kTakesTheLowest>>("x06_takes_the_lowest", "Takes scores for costs"),
    component<Grid<Fault::kIgnoresSecond>>("x07_ignores_second", "Takes the first of equals"),
    component<Grid<Fault::kNeverSpent>>("x08_never_spent", "Never says that the budget was spent"),
    component<Grid<Fault::kBeginsAnywhere>>("x09_begins_anywhere", "Begins in another plane for each budget"),
    component<Grid<Fault::kSkipsAPlane>>("x10_skips_a_plane", "Leaves the last plane out"),
    component<Grid<Fault::kAlwaysFinds>>("x11_always_finds", "Has a number where there is no grasp"),
    component<Grid<Fault::kNeedsRoom>>("x12_needs_room", "Refuses a single approach value"),
    component<Grid<Fault::kTellsPercent>>("x13_tells_percent", "Tells its progress in percent"),
    component<Grid<Fault::kSwallows>>("x14_swallows", "Goes on where the problem failed"),
    component<Grid<Fault::kTooMuchRoom>>("x15_too_much_room", "Has room for one more score"),
    component<Grid<Fault::kLooksNowhere>>("x16_looks_nowhere", "Asks for no station"))
