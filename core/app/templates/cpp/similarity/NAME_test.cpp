// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cmath>
#include <cstdio>
#include <vector>

#include "preshape/fuzzy/similarity.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const auto measure = registry.create<Similarity>("@NAME@");
  const FuzzyPartition sets = FuzzyPartition::thesis();
  const Patterns task(sets, {1.0, 0.1, 0.1, 0.8, 0.05, 0.05});
  Patterns wrenches(sets, {1.0, 0.1, 0.1, 0.8, 0.05, 0.05});
  wrenches.add({-1.0, 0.1, 0.1, 0.8, 0.05, 0.05});

  std::vector<double> scores(2);
  measure->compare(task.view(), wrenches.view(), scores);
  check(scores[0] == measure->scale(sets.size()).nearest, "a pattern is as near to itself as can be");
  check(scores[1] < scores[0], "a pattern pushed the other way is farther");

  // J({.2, .4}, {.4, .4}) = .6 / .8, in the first component; the others are empty on both sides.
  const double crisp[6] = {};
  double q[12] = {0.2, 0.4}, w[12] = {0.4, 0.4}, components[6];
  measure->component_scores({1, 2, crisp, q}, {1, 2, crisp, w}, components);
  check(std::abs(components[0] - 0.75) < 1e-15, "the index is the share of the common membership");
  check(components[1] == 1.0, "two empty fuzzy vectors are equal");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
