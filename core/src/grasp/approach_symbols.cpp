#include "preshape/grasp/approach_symbols.h"

#include <algorithm>

namespace preshape {

double ApproachSymbols::fraction(int symbol, double half_extent_m, double length_m) const {
  const double middle = partition_[symbol - 1].top_middle();
  const double fraction = universe_ == Universe::kHalfExtent ? middle : middle * length_m / half_extent_m;
  return std::clamp(fraction, -kReach, kReach);
}

int ApproachSymbols::symbol(double fraction, double half_extent_m, double length_m) const {
  return partition_.best(universe_ == Universe::kHalfExtent ? fraction : fraction * half_extent_m / length_m) + 1;
}

std::vector<double> ApproachSymbols::fractions(double half_extent_m, double length_m) const {
  std::vector<double> fractions;
  for (int symbol = 1; symbol <= count(); ++symbol) fractions.push_back(fraction(symbol, half_extent_m, length_m));
  std::sort(fractions.begin(), fractions.end());
  fractions.erase(std::unique(fractions.begin(), fractions.end()), fractions.end());
  return fractions;
}

}  // namespace preshape
