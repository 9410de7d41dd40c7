// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cmath>
#include <cstdio>

#include "preshape/grasp/explorer.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

/// Two planes; the first has no grasp, the second is best at x = 0.3.
class Hill final : public preshape::ExplorationProblem {
 public:
  int planes() const noexcept override { return 2; }
  std::span<const double> symbol_stations() const noexcept override { return symbols_; }
  double lowest_approach() const noexcept override { return -1; }
  double highest_approach() const noexcept override { return 1; }
  std::span<const int> finger_counts() const noexcept override { return counts_; }
  std::span<const double> transverse_offsets() const noexcept override { return offsets_; }
  void evaluate(std::span<const preshape::Station> stations, std::span<preshape::StationScore> scores) const override {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      scores[i] = {};
      if (stations[i].plane == 1) scores[i] = {-std::abs(stations[i].approach - 0.3), 0.0};
    }
  }

 private:
  double symbols_[3] = {-0.5, 0.0, 0.5};
  int counts_[1] = {0};
  double offsets_[1] = {0.0};
};

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const auto explorer = registry.create<Explorer>("@NAME@", Value::table({{"sections", 10}}));
  const Hill hill;

  const ExplorationResult found = explorer->explore(hill, 1000, 1, nullptr);
  check(found.best.plane == 1 && std::abs(found.best.approach - 0.3) < 0.02, "it finds the top of a hill");
  check(!found.budget_spent && found.evaluations <= 1000, "it ends by itself within a large budget");
  double before = -INFINITY;
  for (int budget = 0; budget < 60; ++budget) {
    const ExplorationResult some = explorer->explore(hill, budget, 1, nullptr);
    check(some.evaluations <= budget && some.budget_spent, "it stops where the budget is spent and says so");
    check(!(some.score.first < before), "a larger budget never gives a worse station");
    before = some.score.first;
  }
  const ExplorationResult again = explorer->explore(hill, 1000, 1, nullptr);
  check(again.best == found.best && again.score.first == found.score.first, "the same seed gives the same station");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
