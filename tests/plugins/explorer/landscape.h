#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/grasp/explorer.h"
#include "support/near.h"
#include "support/registry.h"

namespace preshape::test {

using Score = std::function<StationScore(const Station&)>;

/// A problem with any score, which notes every station that it is asked about.
class Landscape final : public ExplorationProblem {
 public:
  explicit Landscape(Score score, std::vector<int> fingers = {0},
                     std::vector<double> symbols = {-0.95, -0.65, -0.25, 0.0, 0.25, 0.65, 0.95})
      : score_(std::move(score)), fingers_(std::move(fingers)), symbols_(std::move(symbols)) {}
  int planes() const noexcept override { return 4; }
  std::span<const double> symbol_stations() const noexcept override { return symbols_; }
  double lowest_approach() const noexcept override { return -0.95; }
  double highest_approach() const noexcept override { return 0.95; }
  std::span<const int> finger_counts() const noexcept override { return fingers_; }
  std::span<const double> transverse_offsets() const noexcept override { return offsets; }
  void evaluate(std::span<const Station> stations, std::span<StationScore> scores) const override {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      scores[i] = score_(stations[i]);
      asked.push_back(stations[i]);
    }
  }

  std::vector<double> offsets = {0.0};
  mutable std::vector<Station> asked;

 private:
  Score score_;
  std::vector<int> fingers_;
  std::vector<double> symbols_;
};

/// A rough landscape without any structure: a number drawn anew for each station, a fifth of them without a
/// grasp.
inline Score rough(std::uint64_t seed) {
  return [seed](const Station& s) {
    const auto cell = static_cast<std::uint64_t>(std::lround(1e4 * (s.approach + 1)) * 64 + s.plane * 8 +
                                                 s.virtual_fingers);
    Random random(seed * 1000003 + cell);
    if (random.uniform() < 0.2) return StationScore{};
    const double first = std::floor(random.uniform(0, 12)) / 2;  // coarse, so that ties are common
    return StationScore{first, random.uniform(-8, 0)};
  };
}

/// One smooth hill in one plane.
inline Score hill(int plane, double top) {
  return [=](const Station& s) {
    const double off = s.approach - top;
    return StationScore{-off * off - (s.plane == plane ? 0.0 : 10.0), 0.0};
  };
}

inline std::shared_ptr<Explorer> explorer(const char* name, const Value& parameters = {}) {
  return registry().create<Explorer>(name, parameters);
}

inline StationScore best_of(const Landscape& landscape, std::span<const Station> stations,
                            Station* which = nullptr) {
  std::vector<StationScore> scores(stations.size());
  landscape.evaluate(stations, scores);
  StationScore best;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i].better_than(best)) continue;
    best = scores[i];
    if (which) *which = stations[i];
  }
  return best;
}

inline bool same(const StationScore& a, const StationScore& b) {
  return a.first == b.first && a.second == b.second;
}

}  // namespace preshape::test
