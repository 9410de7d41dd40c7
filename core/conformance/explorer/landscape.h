#pragma once

#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "../context.h"
#include "preshape/grasp/explorer.h"

namespace preshape::conformance {

/// What an explorer may search and how good each station is: a number drawn anew for each, from the seed
/// alone.
struct Terrain {
  int planes = 3;
  std::vector<double> symbols;
  double lowest = -0.95, highest = 0.95;
  std::vector<int> fingers = {0};
  std::vector<double> offsets = {0.0};  ///< transverse
  std::uint64_t seed = 1;
  double barren = 0.2;  ///< share of the stations without a grasp
  bool coarse = true;   ///< `first` has few values, so that ties are common

  StationScore score(const Station& station) const;
  /// Every symbol's station in every plane, with every finger count and transverse offset.
  std::vector<Station> symbol_grid() const;
};

/// The numbers that describe a terrain, and the terrain of such numbers.
std::vector<Block> terrain_blocks();
Terrain terrain_of(Case numbers);
inline constexpr std::size_t kTerrainNumbers = 6;

/// A terrain as a problem, which notes what it is asked. [any thread]
class Landscape final : public ExplorationProblem {
 public:
  explicit Landscape(Terrain terrain)
      : terrain_(std::move(terrain)), symbols_(terrain_.symbols), fingers_(terrain_.fingers) {}
  /// With symbols and finger counts in memory of the caller's.
  Landscape(Terrain terrain, std::span<const double> symbols, std::span<const int> fingers)
      : terrain_(std::move(terrain)), symbols_(symbols), fingers_(fingers) {}
  Landscape(const Landscape&) = delete;
  Landscape& operator=(const Landscape&) = delete;

  int planes() const noexcept override { return terrain_.planes; }
  std::span<const double> symbol_stations() const noexcept override { return symbols_; }
  double lowest_approach() const noexcept override { return terrain_.lowest; }
  double highest_approach() const noexcept override { return terrain_.highest; }
  std::span<const int> finger_counts() const noexcept override { return fingers_; }
  std::span<const double> transverse_offsets() const noexcept override { return terrain_.offsets; }
  /// A wrong size is noted only. @throws InputError after `fail_after` stations
  void evaluate(std::span<const Station> stations, std::span<StationScore> scores) const override;

  /// The next calls throw once that many stations have been asked.
  void fail_after(std::size_t count) { fail_after_ = count; }
  const std::vector<Station>& asked() const { return asked_; }
  bool wrong_size() const { return wrong_size_; }
  const Terrain& terrain() const { return terrain_; }
  static constexpr const char* kFailure = "the landscape fails on purpose";

 private:
  Terrain terrain_;
  std::span<const double> symbols_;
  std::span<const int> fingers_;
  std::size_t fail_after_ = std::numeric_limits<std::size_t>::max();
  mutable std::mutex mutex_;
  mutable std::vector<Station> asked_;
  mutable bool wrong_size_ = false;
};

/// A search that is over, with what it asked.
struct Search {
  ExplorationResult result;
  std::vector<Station> asked;
  bool wrong_size = false;
};
Search search(const Explorer& explorer, const Terrain& terrain, std::int64_t budget,
              Progress* progress = nullptr);

inline constexpr std::uint64_t kSearchSeed = 12345;  ///< of a search's own randomness

/// A budget that no shipped search spends on these terrains.
inline constexpr std::int64_t kAmple = 50000;

inline bool same(const StationScore& a, const StationScore& b) {
  return a.first == b.first && a.second == b.second;
}
std::string station_text(const Station& station);
std::string score_text(const StationScore& score);

}  // namespace preshape::conformance
