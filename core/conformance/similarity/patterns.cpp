#include "patterns.h"

#include <algorithm>

namespace preshape::conformance {

const std::vector<double> kCrispCorners = {-2.0, -1.0, -0.5, -0.1, -0.0, 0.0, 0.05, 0.1, 0.3, 0.5, 0.75, 1.0, 2.0};

const std::vector<FuzzyPartition>& partitions() {
  static const std::vector<FuzzyPartition> kAll = [] {
    std::vector<FuzzyPartition> all = {FuzzyPartition::thesis()};
    for (const int sets : {1, 2, 5, 11}) {
      Value::List list;
      for (int i = 0; i < sets; ++i) {
        const double middle = sets == 1 ? 0.0 : -1.0 + 2.0 * i / (sets - 1.0), half = sets == 1 ? 1.0 : 2.0 / (sets - 1.0);
        list.push_back(Value::table({{"name", fmt::format("set{}", i + 1)},
                                     {"triangle", Value::numbers({middle - half, middle, middle + half})}}));
      }
      all.push_back(FuzzyPartition::from_value(Value::list(std::move(list))));
    }
    return all;
  }();
  return kAll;
}

Patterns pattern_of(Case six, const FuzzyPartition& partition) {
  std::array<double, kComponents> vector;
  std::copy_n(six.begin(), kComponents, vector.begin());
  return Patterns(partition, vector);
}

RawPattern::RawPattern(Case numbers, int set_count) : memberships(numbers.begin(), numbers.end()), sets(set_count) {}

double score(const Similarity& measure, const PatternView& task, const PatternView& pattern) {
  double value = 0.0;
  measure.compare(task, pattern, {&value, 1});
  return value;
}

}  // namespace preshape::conformance
