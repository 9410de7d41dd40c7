#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "preshape/base/require.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/plugin/entry.h"

namespace zoo {

using namespace preshape;

/// A measure without a fault, to be broken in one place: one minus the mean difference of the memberships, summed
/// over the components. Scale 0 .. 6.
class Measure : public Similarity {
 public:
  explicit Measure(const Parameters&) {}

  SimilarityScale scale(int) const noexcept override { return {0.0, kComponents}; }

  void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const override {
    require_size("scores", static_cast<std::size_t>(patterns.count), scores.size());
    for (int i = 0; i < patterns.count; ++i) scores[static_cast<std::size_t>(i)] = one(task, patterns[i]);
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    for (std::size_t k = 0; k < kComponents; ++k) {
      const auto first = k * static_cast<std::size_t>(task.sets);
      scores[k] = component({task.memberships + first, static_cast<std::size_t>(task.sets)},
                            {pattern.memberships + first, static_cast<std::size_t>(task.sets)});
    }
  }

 protected:
  using Degrees = std::span<const double>;

  virtual double one(const PatternView& task, const PatternView& pattern) const {
    double parts[kComponents], sum = 0.0;
    component_scores(task, pattern, parts);
    for (const double part : parts) sum += part;
    return sum;
  }

  virtual double component(Degrees q, Degrees w) const {
    double difference = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) difference += std::abs(q[i] - w[i]);
    return 1.0 - difference / static_cast<double>(q.size());
  }
};

/// What a broken measure promises: the one thing that it breaks.
template <class... Names>
std::vector<std::string> promises(Names... names) {
  return {names...};
}

}  // namespace zoo
