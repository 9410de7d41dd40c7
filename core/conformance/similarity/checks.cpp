// The mathematics of similarity measures, S01 and on.
#include <algorithm>
#include <cmath>

#include "patterns.h"

namespace preshape::conformance {

namespace {

constexpr double kTolerance = 1e-12;  // of a score, over the width of its scale

/// Two crisp vectors.
std::vector<Block> two_vectors() {
  return {{"task", kComponents, -2.0, 2.0, kCrispCorners}, {"pattern", kComponents, -2.0, 2.0, kCrispCorners}};
}

void s01_stays_in_its_scale(Context& context) {
  const auto measure = context.create<Similarity>();
  for (const auto& partition : partitions()) {
    const SimilarityScale scale = measure->scale(partition.size());
    const auto [low, high] = std::minmax(scale.farthest, scale.nearest);
    context.require(std::isfinite(low) && std::isfinite(high) && low < high,
                    "its scale for {} sets is {} .. {}", partition.size(), scale.farthest, scale.nearest);
    const double slack = kTolerance * (high - low);
    const auto blocks = two_vectors();
    context.for_all(blocks, context.cases(2000), [&, lowest = low, highest = high](Case c) -> std::string {
      const double s = score(*measure, pattern_of(c.first(6), partition).view(), pattern_of(c.last(6), partition).view());
      if (s >= lowest - slack && s <= highest + slack) return "";
      return fmt::format("the score {} is outside its scale {} .. {} for {} sets", s, lowest, highest, partition.size());
    });
  }
}

void s03_symmetric(Context& context) {
  const auto measure = context.create<Similarity>();
  bool differs = false;
  const bool declared = context.declares("symmetric");
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(2000), [&](Case c) -> std::string {
    const Patterns a = pattern_of(c.first(6)), b = pattern_of(c.last(6));
    const double ab = score(*measure, a.view(), b.view()), ba = score(*measure, b.view(), a.view());
    differs = differs || ab != ba;
    return declared && ab != ba ? fmt::format("s(task, pattern) = {} and s(pattern, task) = {}", ab, ba) : "";
  });
  if (!declared && !differs) context.warn("no pair with s(a, b) != s(b, a) was found; it may promise 'symmetric'");
}

constexpr Check kChecks[] = {
    {"S01", "similarity", "every score is finite and inside the declared scale", s01_stays_in_its_scale},
    {"S03", "similarity", "declared symmetric: s(a, b) = s(b, a), bit for bit", s03_symmetric},
};

}  // namespace

std::span<const Check> similarity_checks() { return kChecks; }

}  // namespace preshape::conformance
