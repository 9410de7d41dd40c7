#pragma once

#include <cstdint>
#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

/// Seeded random numbers (xoshiro256**), the same on every machine. Passed in, never global; the seed is
/// part of every result. `stream` derives an independent generator by name, so that one consumer's draws do
/// not shift another's.
class PRESHAPE_API Random {
 public:
  using result_type = std::uint64_t;

  explicit Random(std::uint64_t seed);

  std::uint64_t operator()();
  static constexpr std::uint64_t min() { return 0; }
  static constexpr std::uint64_t max() { return ~std::uint64_t{0}; }

  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform integer in [0, count); count >= 1.
  std::uint64_t below(std::uint64_t count);
  /// Standard normal (Box-Muller).
  double normal();

  /// An independent generator that depends on the seed and the name only.
  Random stream(std::string_view name) const;
  std::uint64_t seed() const { return seed_; }

 private:
  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace preshape
