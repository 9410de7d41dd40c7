#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "preshape/agent/settings.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/grasp/explorer.h"
#include "preshape/grasp/task.h"
#include "preshape/spatial/wrench.h"

namespace preshape {

/// What the critic says of a wrench pattern before a task.
struct Criticism {
  double first = 0.0, second = 0.0;               ///< of the deciding and the tie-breaking measure
  std::array<double, kComponents> components{};   ///< the deciding measure, component by component
};

/// The agent's critic (thesis sec. 3.1): turns the similarity of task and resultant wrench into reward or penalty.
/// [any thread, const]
class PRESHAPE_API InternalCritic {
 public:
  /// @throws InputError when a threshold is outside the deciding measure's range
  InternalCritic(std::shared_ptr<const Similarity> first, std::shared_ptr<const Similarity> second,
                 FuzzyPartition partition, Thresholds thresholds);

  Criticism judge(const std::array<double, kComponents>& task, const std::array<double, kComponents>& pattern) const;
  /// Scores of many wrenches, turned so that higher is nearer.
  void score(const std::array<double, kComponents>& task, std::span<const Wrench> wrenches,
             std::span<StationScore> scores) const;

  /// Reward (true) or penalty in the execution modes.
  bool serves(double first) const { return scale_.reaches(first, thresholds_.estimation); }
  /// Whether a recalled pattern shows that the object is known.
  bool recognises(double first) const { return scale_.reaches(first, thresholds_.recognition); }
  /// Whether `a` is nearer to the task than `b`, the second measure deciding ties.
  bool nearer(const Criticism& a, const Criticism& b) const;

  const Thresholds& thresholds() const { return thresholds_; }
  const FuzzyPartition& partition() const { return partition_; }
  const SimilarityScale& scale() const { return scale_; }
  const SimilarityScale& second_scale() const { return second_scale_; }

 private:
  std::shared_ptr<const Similarity> first_, second_;
  FuzzyPartition partition_;
  Thresholds thresholds_;
  SimilarityScale scale_, second_scale_;
};

PRESHAPE_API std::array<double, kComponents> components(const Wrench& wrench);

}  // namespace preshape
