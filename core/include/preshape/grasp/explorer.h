#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/base/progress.h"

namespace preshape {

/// A place where the hand could close: approach plane, approach value, finger count and transverse offset.
struct Station {
  int plane = 0;               ///< index into the problem's planes, from 0
  double approach = 0.0;       ///< x over the half extent of the object along a, -1..1
  int virtual_fingers = 0;     ///< 1..3, or 0: as the rules say
  double transverse = 0.0;     ///< of the thumb from the middle of the section, over the section's half width, -1..1
  bool operator==(const Station&) const = default;
};

/// How well a station would serve. `first` decides, `second` breaks ties; both are turned so that higher is
/// nearer. A station without a grasp has -infinity.
struct StationScore {
  double first = -std::numeric_limits<double>::infinity();
  double second = -std::numeric_limits<double>::infinity();
  bool feasible() const { return first > -std::numeric_limits<double>::infinity(); }
  bool better_than(const StationScore& other) const {
    return first > other.first || (first == other.first && second > other.second);
  }
};

/// What an explorer searches: it proposes stations and is told their scores, in batches.
class PRESHAPE_API ExplorationProblem {
 public:
  virtual ~ExplorationProblem();
  virtual int planes() const noexcept = 0;
  /// The stations on which a coarse search stands: the symbols' middles, -1..1, ascending.
  virtual std::span<const double> symbol_stations() const noexcept = 0;
  /// Bounds of the approach value.
  virtual double lowest_approach() const noexcept = 0;
  virtual double highest_approach() const noexcept = 0;
  /// Finger counts worth trying: {0} when the rules decide, {1, 2, 3} when they are free.
  virtual std::span<const int> finger_counts() const noexcept = 0;
  /// Transverse offsets worth trying: {0} for the thesis's searches.
  virtual std::span<const double> transverse_offsets() const noexcept = 0;
  virtual void evaluate(std::span<const Station> stations, std::span<StationScore> scores) const = 0;
};

/// The stations on which a coarse search stands: every symbol's in every plane, with every finger count at every
/// transverse offset. Plane by plane, so that a budget cuts off the last planes.
PRESHAPE_API std::vector<Station> coarse_stations(const ExplorationProblem& problem);

struct ExplorationResult {
  Station best;
  StationScore score;                ///< not feasible: no station has a grasp
  std::int64_t evaluations = 0;
  bool budget_spent = false;         ///< stopped by the budget before its own end
};

/// Kind `explorer`: the agent's problem generator (thesis secs. 3.1, 3.10). [any thread, const]
class PRESHAPE_API Explorer {
 public:
  virtual ~Explorer();
  /// @param budget most evaluations; the best so far is returned when it is spent
  /// @param seed of whatever randomness it uses; @param progress may be null
  virtual ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t seed,
                                    Progress* progress) const = 0;
  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
