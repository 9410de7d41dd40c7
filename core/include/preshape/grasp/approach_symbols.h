#pragma once

#include <vector>

#include "preshape/fuzzy/partition.h"

namespace preshape {

/// The approach value as a fuzzy attribute: symbols 1..n of a partition, read over a universe (spec section 7).
class PRESHAPE_API ApproachSymbols {
 public:
  enum class Universe {
    kHalfExtent,  ///< x over the object's half extent along a: every symbol names a reachable station
    kNormalised,  ///< x over the characteristic length L, as the thesis's tables
  };
  /// Defuzzified fractions are clipped to +-kReach, so that the outer symbols stay on the object.
  static constexpr double kReach = 0.95;

  ApproachSymbols(FuzzyPartition partition, Universe universe)
      : partition_(std::move(partition)), universe_(universe) {}

  int count() const { return partition_.size(); }
  const std::string& name(int symbol) const { return partition_[symbol - 1].name; }

  /// The fraction of the half extent that a symbol stands for: the middle of its top.
  /// @param half_extent_m along a; @param length_m L
  double fraction(int symbol, double half_extent_m, double length_m) const;
  /// The symbol of a fraction of the half extent.
  int symbol(double fraction, double half_extent_m, double length_m) const;
  /// All symbols' fractions, ascending, without repetition.
  std::vector<double> fractions(double half_extent_m, double length_m) const;

 private:
  FuzzyPartition partition_;
  Universe universe_;
};

}  // namespace preshape
