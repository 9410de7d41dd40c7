// Explorers that misuse the person who is told their progress.
#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

/// The symbols' stations of every plane, one at a time.
class Plain : public Explorer {
 public:
  explicit Plain(const Parameters&) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t,
                            Progress* progress) const override {
    ExplorationResult result;
    for (int plane = 0; plane < problem.planes(); ++plane) {
      tell(progress, static_cast<double>(plane) / problem.planes());
      for (const Station& station : coarse_stations(problem)) {
        if (station.plane == plane) look(problem, station, budget - spared(progress), result);
      }
    }
    return result;
  }

 protected:
  virtual void tell(Progress* progress, double fraction) const {
    if (progress) progress->advance("exploring", fraction, "");
  }
  virtual std::int64_t spared(Progress*) const { return 0; }

 private:
  static void look(const ExplorationProblem& problem, const Station& station, std::int64_t budget, ExplorationResult& result) {
    if (result.evaluations >= budget) {
      result.budget_spent = true;
      return;
    }
    StationScore score;
    problem.evaluate({&station, 1}, {&score, 1});
    ++result.evaluations;
    if (score.better_than(result.score)) result.best = station, result.score = score;
  }
};

struct Distracted final : Plain {
  using Plain::Plain;
  // Who is watched is in a hurry.
  std::int64_t spared(Progress* progress) const override { return progress ? 1000000 : 0; }
};

struct Unstoppable final : Plain {
  using Plain::Plain;
  void tell(Progress* progress, double fraction) const override {
    try {
      Plain::tell(progress, fraction);
    } catch (const Error&) {
    }
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"zoo.progress", "1.0.0", "BSD-3-Clause", "the preshape developers", "Explorers broken on purpose"}),
                ({"explorer/good_plain", "explorer/g29_distracted", "explorer/g30_unstoppable"}),
                preshape::component<Plain>("good_plain", "without a fault"),
                preshape::component<Distracted>("g29_distracted", "gives up early when watched"),
                preshape::component<Unstoppable>("g30_unstoppable", "keeps the exception to itself"))
