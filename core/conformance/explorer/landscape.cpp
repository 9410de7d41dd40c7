#include "landscape.h"

#include <algorithm>
#include <cmath>

#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// 64 bits in which every bit of the input tells (the last steps of MurmurHash3).
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
  bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return bits ^ (bits >> 33);
}

double share(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace

StationScore Terrain::score(const Station& station) const {
  // A search may come to a station by another sum of steps, so that rounding must not matter.
  const auto place = static_cast<std::uint64_t>(std::llround(1e6 * (station.approach + 2.0)));
  const std::uint64_t at = mixed(mixed(seed * 31 + static_cast<std::uint64_t>(station.plane)) + place * 7 +
                                 static_cast<std::uint64_t>(station.virtual_fingers) +
                                 static_cast<std::uint64_t>(std::llround(64 * (station.transverse + 2.0))) * 1000003);
  if (share(at) < barren) return {};
  const double first = 6.0 * share(mixed(at + 1)), second = -8.0 * share(mixed(at + 2));
  return {coarse ? std::floor(2.0 * first) / 2.0 : first, second};
}

std::vector<Station> Terrain::symbol_grid() const {
  std::vector<Station> stations;
  for (int plane = 0; plane < planes; ++plane) {
    for (const double x : symbols) {
      for (const int count : fingers) {
        for (const double offset : offsets) stations.push_back({plane, x, count, offset});
      }
    }
  }
  return stations;
}

std::vector<Block> terrain_blocks() {
  return {{"planes", 1, 1, 5, {2}, true},
          {"symbols", 1, 0, 7, {1, 2}, true},
          {"fingers", 1, 0, 2, {}, true},
          {"terrain", 1, 0, 1e6, {}, true},
          {"share without a grasp", 1, 0, 1, {0.2, 0.9}},
          {"offsets", 1, 0, 2, {}, true}};
}

Terrain terrain_of(Case numbers) {
  static const std::vector<int> kFingers[] = {{0}, {1, 2, 3}, {2}};
  static const std::vector<double> kOffsets[] = {{0.0}, {-0.5, 0.0, 0.5}, {0.25}};
  Terrain terrain;
  terrain.planes = static_cast<int>(numbers[0]);
  const int symbols = static_cast<int>(numbers[1]);
  for (int i = 0; i < symbols; ++i) {
    const double along = symbols == 1 ? 0.5 : i / (symbols - 1.0);
    terrain.symbols.push_back(std::clamp(-0.95 + 1.9 * along, terrain.lowest, terrain.highest));
  }
  terrain.fingers = kFingers[static_cast<std::size_t>(numbers[2])];
  terrain.seed = static_cast<std::uint64_t>(numbers[3]);
  terrain.barren = numbers[4];
  terrain.offsets = kOffsets[static_cast<std::size_t>(numbers[5])];
  return terrain;
}

void Landscape::evaluate(std::span<const Station> stations, std::span<StationScore> scores) const {
  const std::lock_guard lock(mutex_);
  wrong_size_ = wrong_size_ || stations.size() != scores.size();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (asked_.size() >= fail_after_) throw InputError(kFailure);
    asked_.push_back(stations[i]);
    if (i < scores.size()) scores[i] = terrain_.score(stations[i]);
  }
}

Search search(const Explorer& explorer, const Terrain& terrain, std::int64_t budget, Progress* progress) {
  const Landscape landscape(terrain);
  Search done;
  done.result = explorer.explore(landscape, budget, kSearchSeed, progress);
  done.asked = landscape.asked();
  done.wrong_size = landscape.wrong_size();
  return done;
}

std::string station_text(const Station& station) {
  return fmt::format("plane {} approach {} fingers {} transverse {}", station.plane, station.approach,
                     station.virtual_fingers, station.transverse);
}

std::string score_text(const StationScore& score) {
  return fmt::format("({}, {})", score.first, score.second);
}

}  // namespace preshape::conformance
