#include "preshape/fuzzy/partition_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "partition_walk.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr double kNarrowestGap = 1e-9;  ///< of the universe: cuts that should touch miss each other by rounding
constexpr int kHalvings = 60;           ///< of 0 .. 1, to rounding

/// The greatest degree of 0 .. 1 for which something holds that holds for every lesser one; 0 when it holds for none.
template <class Holds>
double greatest_degree(Holds&& holds) {
  if (holds(1.0)) return 1.0;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low < 1e-12 ? 0.0 : low;
}

/// The parts of an interval in which no set reaches a degree.
std::vector<Interval> uncovered(const FuzzyPartition& partition, const Interval& whole, double degree, double narrowest) {
  std::vector<Interval> cuts, gaps;
  for (const Membership& set : partition.sets()) {
    const Interval cut = intersection(alpha_cut(set, degree), whole);
    if (!cut.empty()) cuts.push_back(cut);
  }
  std::sort(cuts.begin(), cuts.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  double reached = whole.from;
  const auto add_until = [&](double next) {
    if (next - reached > narrowest) gaps.push_back({reached, next});
  };
  for (const Interval& cut : cuts) {
    add_until(cut.from);
    reached = std::max(reached, cut.to);
  }
  add_until(whole.to);
  return gaps;
}

std::vector<Gap> gaps_of(const FuzzyPartition& partition, const Interval& universe, double bound) {
  const double narrowest = kNarrowestGap * universe.width();
  std::vector<Gap> gaps;
  for (const Interval& where : uncovered(partition, universe, bound, narrowest)) {
    gaps.push_back({where, greatest_degree([&](double degree) {
                      return uncovered(partition, where, degree, kNarrowestGap * where.width()).empty();
                    })});
  }
  return gaps;
}

Interval common_cut(const FuzzyPartition& partition, const Interval& universe, int first, int second, double degree) {
  return intersection(universe, intersection(alpha_cut(partition[first], degree), alpha_cut(partition[second], degree)));
}

/// More than the single point at which two crisp intervals touch.
bool share_a_top(const FuzzyPartition& partition, const Interval& universe, int first, int second) {
  return common_cut(partition, universe, first, second, 1.0).width() > kNarrowestGap * universe.width();
}

/// Both cuts have a point in common up to the height at which the sets cross.
Crossing crossing_of(const FuzzyPartition& partition, const Interval& universe, int first, int second) {
  const auto common = [&](double degree) { return common_cut(partition, universe, first, second, degree); };
  Crossing crossing{first, second, greatest_degree([&](double degree) { return !common(degree).empty(); }),
                    std::numeric_limits<double>::quiet_NaN()};
  if (crossing.height > 0.0) {
    const Interval where = common(crossing.height);
    crossing.x = where.from / 2 + where.to / 2;
  }
  return crossing;
}

}  // namespace

PartitionFindings findings_of(const FuzzyPartition& partition, const Interval& universe, double bound) {
  if (!(bound > 0.0 && bound <= 1.0)) throw InputError(fmt::format("the bound of completeness is above 0 and at most 1, got {}", bound));
  if (!(universe.width() > 0.0 && std::isfinite(universe.width()))) {
    throw InputError(fmt::format("the universe of fuzzy sets is an interval of a finite width, got {} .. {}", universe.from, universe.to));
  }
  PartitionFindings found;
  found.universe = universe;
  found.bound = bound;
  found.gaps = gaps_of(partition, universe, bound);
  for (int second = 1; second < partition.size(); ++second) {
    for (int first = 0; first < second; ++first) {
      const Crossing crossing = crossing_of(partition, universe, first, second);
      const bool neighbours = first + 1 == second;
      if (neighbours) found.crossings.push_back(crossing);
      if (neighbours ? share_a_top(partition, universe, first, second) : crossing.height >= bound)
        found.crowded.push_back(crossing);
    }
    if (partition[second].top_middle() <= partition[second - 1].top_middle()) found.out_of_order.push_back(second);
  }
  const Interval sums = sums_of(partition, universe);
  found.least_sum = sums.from, found.most_sum = sums.to;
  found.never_best = never_best(partition, universe);
  return found;
}

std::vector<std::string> sentences(const PartitionFindings& findings, const FuzzyPartition& partition) {
  std::vector<std::string> told;
  for (const Gap& gap : findings.gaps) {
    told.push_back(fmt::format("between {:.6g} and {:.6g} no set reaches {:g}; the best one's degree falls to {:.3g} there",
                               gap.where.from, gap.where.to, findings.bound, gap.lowest));
  }
  for (const Crossing& crossing : findings.crowded) {
    const auto &first = partition[crossing.first].name, &second = partition[crossing.second].name;
    if (crossing.first + 1 == crossing.second) {
      told.push_back(fmt::format("'{}' and '{}' are both 1 at {:.6g}; the first of them counts there", first, second, crossing.x));
    } else {
      told.push_back(fmt::format("'{}' and '{}', which are no neighbours, both reach {:.3g} at {:.6g}", first, second,
                                 crossing.height, crossing.x));
    }
  }
  for (const int set : findings.never_best) told.push_back(fmt::format("'{}' is nowhere the best set", partition[set].name));
  for (const int set : findings.out_of_order) {
    told.push_back(fmt::format("'{}' comes after '{}' but its top is not above that one's; list the sets from low to high",
                               partition[set].name, partition[set - 1].name));
  }
  return told;
}

}  // namespace preshape
