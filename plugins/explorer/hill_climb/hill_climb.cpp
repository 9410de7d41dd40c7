#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/grasp/explorer.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::ExplorationProblem;
using preshape::ExplorationResult;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::Random;
using preshape::Station;
using preshape::StationScore;

struct Scored {
  Station station;
  StationScore score;
};

bool better(const Scored& a, const Scored& b) {
  return a.score.better_than(b.score);
}

/// The search so far. It asks for no station twice, and never for more than the budget.
class Search {
 public:
  Search(const ExplorationProblem& problem, std::int64_t budget) : problem_(problem), budget_(budget) {}

  /// The scores of the stations, in their order; without those that the budget does not reach.
  std::vector<Scored> look(const std::vector<Station>& stations) {
    ask(stations);
    std::vector<Scored> found;
    for (const Station& station : stations) {
      if (const auto known = known_.find(place(station)); known != known_.end())
        found.push_back(known->second);
    }
    return found;
  }

  bool over() const { return result_.budget_spent; }
  const ExplorationResult& result() const { return result_; }

 private:
  using Place = std::tuple<int, long long, int, double>;
  /// A climb may come to a station by another sum of steps, so that rounding must not matter.
  static Place place(const Station& s) {
    return {s.plane, std::llround(s.approach * 1e9), s.virtual_fingers, s.transverse};
  }

  void ask(const std::vector<Station>& stations) {
    std::map<Place, Station> unknown;
    std::vector<Station> asked;
    for (const Station& station : stations) {
      if (!known_.contains(place(station)) && unknown.emplace(place(station), station).second)
        asked.push_back(station);
    }
    const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, budget_ - result_.evaluations));
    if (asked.size() > left) {
      asked.resize(left);
      result_.budget_spent = true;
    }
    std::vector<StationScore> scores(asked.size());
    problem_.evaluate(asked, scores);
    result_.evaluations += static_cast<std::int64_t>(asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
      known_[place(asked[i])] = {asked[i], scores[i]};
      if (!scores[i].better_than(result_.score)) continue;
      result_.best = asked[i];
      result_.score = scores[i];
    }
  }

  const ExplorationProblem& problem_;
  std::int64_t budget_;
  std::map<Place, Scored> known_;
  ExplorationResult result_;
};

/// Hill climbing by steepest ascent, with restarts [RussellNorvig1995, sec. 4.4]; the thesis names it beside
/// the beam search (sec. 3.10). The symbols' stations of all planes and finger counts are looked at first, in
/// an order drawn from the seed; from each of the best `restarts` of them it climbs: to the best neighbour
/// while that is better, else on with half the step, until the step is below `finest`.
class HillClimb final : public preshape::Explorer {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::integer("restarts", 8, 1, 10000, "-",
                                          "starts that are climbed from, the best first"),
            ParameterDeclaration::number("first_step", 0.2, 0.001, 1.0, "1",
                                         "first step of a climb, over the half extent"),
            ParameterDeclaration::number("finest", 0.05, 0.0005, 1.0, "1",
                                         "smallest step, over the half extent")};
  }
  static std::vector<std::string> capabilities() { return {"anytime", "exhaustive"}; }

  explicit HillClimb(const preshape::Parameters& p)
      : restarts_(static_cast<std::size_t>(p.integer("restarts"))),
        first_step_(p.number("first_step")),
        finest_(p.number("finest")) {}

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t seed,
                            Progress* progress) const override {
    Search search(problem, budget);
    std::vector<Scored> starts = search.look(shuffled(coarse_stations(problem), Random(seed)));
    std::stable_sort(starts.begin(), starts.end(), better);
    if (starts.size() > restarts_) starts.resize(restarts_);
    for (std::size_t i = 0; i < starts.size() && !search.over(); ++i) {
      if (progress)
        progress->advance("exploring",
                          (static_cast<double>(i) + 1.0) / (static_cast<double>(starts.size()) + 1.0), "");
      climb(problem, search, starts[i]);
    }
    if (progress) progress->advance("exploring", 1.0, "");
    return search.result();
  }

 private:
  void climb(const ExplorationProblem& problem, Search& search, Scored here) const {
    double step = first_step_;
    while (step >= finest_ * (1 - 1e-9) && !search.over()) {
      const std::vector<Scored> near = search.look(neighbours(problem, here.station, step));
      const auto best = std::min_element(near.begin(), near.end(), better);
      if (best != near.end() && better(*best, here))
        here = *best;
      else
        step /= 2;
    }
  }

  /// A step forwards and backwards, and the other finger counts and transverse offsets at the same place.
  static std::vector<Station> neighbours(const ExplorationProblem& problem, const Station& here,
                                         double step) {
    std::vector<Station> stations;
    for (const double x : {here.approach - step, here.approach + step}) {
      stations.push_back({here.plane, std::clamp(x, problem.lowest_approach(), problem.highest_approach()),
                          here.virtual_fingers, here.transverse});
    }
    for (const int fingers : problem.finger_counts()) {
      if (fingers != here.virtual_fingers) stations.push_back({here.plane, here.approach, fingers, here.transverse});
    }
    for (const double offset : problem.transverse_offsets()) {
      if (offset != here.transverse) stations.push_back({here.plane, here.approach, here.virtual_fingers, offset});
    }
    return stations;
  }

  static std::vector<Station> shuffled(std::vector<Station> stations, Random random) {
    for (std::size_t i = stations.size(); i > 1; --i) std::swap(stations[i - 1], stations[random.below(i)]);
    return stations;
  }

  std::size_t restarts_;
  double first_step_, finest_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"hill_climb", "1.0.0", "BSD-3-Clause", "the preshape developers", "Steepest ascent with restarts"}),
    ({"explorer/hill_climb"}),
    preshape::component<HillClimb>(
        "hill_climb", "Steepest ascent from the best of the symbols' stations (thesis sec. 3.10)"))
