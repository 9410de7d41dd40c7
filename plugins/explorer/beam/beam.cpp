#include <algorithm>
#include <cmath>
#include <vector>

#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ExplorationProblem;
using preshape::ExplorationResult;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::Station;
using preshape::StationScore;

/// The thesis's fuzzy explorer: a beam search (secs. 3.1, 3.10). The first generation stands on the middles of the
/// approach symbols in every plane, with every finger count and transverse offset; the best `width` stations survive, and each generation
/// after it tries their neighbours at half the step before, until the step is below `finest`.
class Beam final : public preshape::Explorer {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::integer("width", 8, 1, 1000, "stations", "stations that survive a generation"),
            ParameterDeclaration::number("first_step", 0.2, 0.001, 1.0, "1", "step of the second generation, over the half extent"),
            ParameterDeclaration::number("finest", 0.05, 0.0005, 1.0, "1", "smallest step, over the half extent")};
  }
  static std::vector<std::string> capabilities() { return {"anytime", "exhaustive"}; }

  explicit Beam(const preshape::Parameters& p)
      : width_(static_cast<std::size_t>(p.integer("width"))), first_step_(p.number("first_step")), finest_(p.number("finest")) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t,
                            Progress* progress) const override {
    Search search{problem, budget, {}, {}};
    search.generation(coarse_stations(problem), width_);
    const double generations = 1.0 + std::max(0.0, std::ceil(std::log2(first_step_ / finest_)) + 1.0);
    double done = 1.0;
    for (double step = first_step_; step >= finest_ * (1 - 1e-9) && !search.result.budget_spent; step /= 2) {
      if (progress) progress->advance("exploring", std::min(1.0, done++ / generations), "");
      search.generation(search.neighbours(step), width_);
    }
    if (progress) progress->advance("exploring", 1.0, "");
    return search.result;
  }

 private:
  struct Scored {
    Station station;
    StationScore score;
  };

  struct Search {
    const ExplorationProblem& problem;
    std::int64_t budget;
    std::vector<Scored> beam;
    ExplorationResult result;

    /// Evaluates new stations and lets the best `width` of them and of the beam survive.
    void generation(std::vector<Station> stations, std::size_t width) {
      const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, budget - result.evaluations));
      if (stations.size() > left) {
        stations.resize(left);
        result.budget_spent = true;
      }
      std::vector<StationScore> scores(stations.size());
      problem.evaluate(stations, scores);
      result.evaluations += static_cast<std::int64_t>(stations.size());
      for (std::size_t i = 0; i < stations.size(); ++i) {
        if (scores[i].feasible()) beam.push_back({stations[i], scores[i]});
      }
      std::stable_sort(beam.begin(), beam.end(),
                       [](const Scored& a, const Scored& b) { return a.score.better_than(b.score); });
      if (beam.size() > width) beam.resize(width);
      if (!beam.empty() && beam.front().score.better_than(result.score)) {
        result.best = beam.front().station;
        result.score = beam.front().score;
      }
    }

    std::vector<Station> neighbours(double step) const {
      std::vector<Station> stations;
      for (const auto& [station, score] : beam) {
        for (const double x : {station.approach - step, station.approach + step}) {
          const Station next{station.plane, std::clamp(x, problem.lowest_approach(), problem.highest_approach()),
                             station.virtual_fingers, station.transverse};
          const auto near = [&](const Station& s) {
            return s.plane == next.plane && s.virtual_fingers == next.virtual_fingers &&
                   s.transverse == next.transverse && std::abs(s.approach - next.approach) < 1e-9;
          };
          const bool known = std::any_of(stations.begin(), stations.end(), near) ||
                             std::any_of(beam.begin(), beam.end(), [&](const Scored& s) { return near(s.station); });
          if (!known) stations.push_back(next);
        }
      }
      return stations;
    }
  };

  std::size_t width_;
  double first_step_, finest_;
};

}  // namespace

PRESHAPE_PLUGIN(({"beam", "1.0.0", "BSD-3-Clause", "the preshape developers", "The fuzzy explorer's beam search"}),
                ({"explorer/beam"}),
                preshape::component<Beam>("beam", "Beam search over planes, stations and finger counts (thesis sec. 3.10)"))
