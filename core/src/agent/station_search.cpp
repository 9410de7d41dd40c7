#include "preshape/agent/station_search.h"

#include <algorithm>
#include <cmath>

namespace preshape {

std::vector<double> station_grid(double step) {
  std::vector<double> grid;
  // A multiple that is the reach but for a rounding is on the grid.
  const int most = static_cast<int>(std::floor(ApproachSymbols::kReach / step + 1e-9));
  for (int k = -most; k <= most; ++k) grid.push_back(k * step);
  return grid;
}

StationSearch::StationSearch(const PreshapeAnalyser& analyser, const InternalCritic& critic, const SensedObject& object,
                             const std::array<double, kComponents>& task, Reachable reachable)
    : analyser_(analyser), critic_(critic), object_(object), task_(task),
      finger_counts_(analyser.settings().free_virtual_fingers ? std::vector<int>{1, 2, 3} : std::vector<int>{0}),
      reachable_(std::move(reachable)) {
  // In the universe of half extents every plane has the same stations; in the other the widest plane's do.
  std::size_t widest = 0;
  for (std::size_t i = 1; i < object.half_extent_a_m.size(); ++i) {
    if (object.half_extent_a_m[i] > object.half_extent_a_m[widest]) widest = i;
  }
  symbol_stations_ = analyser.symbols().fractions(object.half_extent_a_m[widest], object.length_m);
}

int StationSearch::planes() const noexcept { return static_cast<int>(analyser_.planes().size()); }

void StationSearch::evaluate(std::span<const Station> stations, std::span<StationScore> scores) const {
  std::vector<VirtualGrasp> grasps(stations.size());
  analyser_.analyse(object_, stations, grasps, false);
  std::vector<Wrench> wrenches;
  for (const auto& grasp : grasps) wrenches.push_back(grasp.resultant);
  critic_.score(task_, wrenches, scores);
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    if (!grasps[i].is_grasp()) scores[i] = {};
  }
  if (reachable_) leave_reachable(grasps, scores);
}

void StationSearch::leave_reachable(std::span<const VirtualGrasp> grasps, std::span<StationScore> scores) const {
  for (;;) {
    const auto best = std::max_element(scores.begin(), scores.end(), [](const auto& a, const auto& b) { return b.better_than(a); });
    if (best == scores.end() || !best->feasible() || reachable_(grasps[static_cast<std::size_t>(best - scores.begin())])) return;
    *best = {};
  }
}

std::optional<Station> StationSearch::best_in_plane(int plane, double x0, double window) const {
  std::vector<Station> stations;
  for (const double x : station_grid(analyser_.settings().station_step)) {
    if (std::abs(x - x0) > window + 1e-12) continue;
    for (const int fingers : finger_counts_) {
      for (const double offset : transverse_offsets()) stations.push_back({plane, x, fingers, offset});
    }
  }
  std::vector<StationScore> scores(stations.size());
  evaluate(stations, scores);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (scores[i].feasible() && (!best || scores[i].better_than(scores[*best]))) best = i;
  }
  return best ? std::optional(stations[*best]) : std::nullopt;
}

}  // namespace preshape
