#include "preshape/fuzzy/additive_similarity.h"

#include "preshape/base/require.h"

namespace preshape {

AdditiveSimilarity::~AdditiveSimilarity() = default;

void AdditiveSimilarity::compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const {
  require_size("scores", static_cast<std::size_t>(patterns.count), scores.size());
  for (int i = 0; i < patterns.count; ++i) {
    double components[kComponents];
    component_scores(task, patterns[i], components);
    double sum = 0.0;
    for (const double c : components) sum += c;
    scores[static_cast<std::size_t>(i)] = sum;
  }
}

}  // namespace preshape
