#include <algorithm>
#include <cmath>

#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ExplorationProblem;
using preshape::ParameterDeclaration;
using preshape::Station;
using preshape::StationScore;

/// Every station of a regular grid: the reference that says what there is to be found. Stations stand at the
/// multiples of `step` over the half extent and at the symbols' middles, in every plane, for every finger count and transverse offset, and
/// are evaluated plane by plane.
class Exhaustive final : public preshape::Explorer {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("step", 0.05, 0.001, 0.5, "1", "step of the grid, over the half extent")};
  }
  static std::vector<std::string> capabilities() { return {"anytime", "exhaustive"}; }

  explicit Exhaustive(const preshape::Parameters& p) : step_(p.number("step")) {}

  preshape::ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t,
                                      preshape::Progress* progress) const override {
    preshape::ExplorationResult result;
    for (int plane = 0; plane < problem.planes(); ++plane) {
      std::vector<Station> stations = grid(problem, plane);
      const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, budget - result.evaluations));
      if (stations.size() > left) {
        stations.resize(left);
        result.budget_spent = true;
      }
      std::vector<StationScore> scores(stations.size());
      problem.evaluate(stations, scores);
      result.evaluations += static_cast<std::int64_t>(stations.size());
      for (std::size_t i = 0; i < stations.size(); ++i) {
        if (scores[i].better_than(result.score)) result.best = stations[i], result.score = scores[i];
      }
      if (progress) progress->advance("exploring", (plane + 1.0) / problem.planes(), "");
      if (result.budget_spent) break;
    }
    return result;
  }

 private:
  std::vector<Station> grid(const ExplorationProblem& problem, int plane) const {
    const int low = static_cast<int>(std::ceil(problem.lowest_approach() / step_ - 1e-9));
    const int high = static_cast<int>(std::floor(problem.highest_approach() / step_ + 1e-9));
    std::vector<double> approaches;
    for (int k = low; k <= high; ++k) approaches.push_back(k * step_);
    for (const double x : problem.symbol_stations()) {
      const double k = std::round(x / step_);
      if (std::abs(x - k * step_) > 1e-9 || k < low || k > high) approaches.push_back(x);
    }
    std::sort(approaches.begin(), approaches.end());
    std::vector<Station> stations;
    for (const double x : approaches) {
      for (const int fingers : problem.finger_counts()) {
        for (const double offset : problem.transverse_offsets()) stations.push_back({plane, x, fingers, offset});
      }
    }
    return stations;
  }

  double step_;
};

}  // namespace

PRESHAPE_PLUGIN(({"exhaustive", "1.0.0", "BSD-3-Clause", "the preshape developers", "Search of a whole station grid"}),
                ({"explorer/exhaustive"}),
                preshape::component<Exhaustive>("exhaustive", "Evaluates every station of a regular grid"))
