#pragma once

#include <functional>
#include <optional>

#include "preshape/agent/internal_critic.h"
#include "preshape/agent/preshape_analyser.h"

namespace preshape {

/// The problem that explorers solve here: stations of one object, scored by the critic before one task.
class PRESHAPE_API StationSearch final : public ExplorationProblem {
 public:
  /// Whether the hand can carry a grasp out.
  using Reachable = std::function<bool(const VirtualGrasp& grasp)>;

  /// All three must outlive the search.
  /// @param reachable when given, a station of whose grasp it says no has none. Asking is dear: of each batch the best
  /// stations are asked until one is reachable, so that the best of all batches always is
  StationSearch(const PreshapeAnalyser& analyser, const InternalCritic& critic, const SensedObject& object,
                const std::array<double, kComponents>& task, Reachable reachable = {});

  int planes() const noexcept override;
  std::span<const double> symbol_stations() const noexcept override { return symbol_stations_; }
  double lowest_approach() const noexcept override { return -ApproachSymbols::kReach; }
  double highest_approach() const noexcept override { return ApproachSymbols::kReach; }
  std::span<const int> finger_counts() const noexcept override { return finger_counts_; }
  std::span<const double> transverse_offsets() const noexcept override { return analyser_.settings().transverse_offsets; }
  void evaluate(std::span<const Station> stations, std::span<StationScore> scores) const override;

  /// Mode 1: the best of the station grid in one plane with |x - x0| <= window, both over the half extent, at every
  /// transverse offset.
  std::optional<Station> best_in_plane(int plane, double x0, double window) const;

 private:
  void leave_reachable(std::span<const VirtualGrasp> grasps, std::span<StationScore> scores) const;

  const PreshapeAnalyser& analyser_;
  const InternalCritic& critic_;
  const SensedObject& object_;
  std::array<double, kComponents> task_;
  std::vector<double> symbol_stations_;
  std::vector<int> finger_counts_;
  Reachable reachable_;
};

/// Fractions of the half extent at multiples of `step` within +-ApproachSymbols::kReach, ascending.
PRESHAPE_API std::vector<double> station_grid(double step);

}  // namespace preshape
