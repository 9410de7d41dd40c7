#include "preshape/agent/internal_critic.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {

void check_threshold(const char* name, double value, const SimilarityScale& scale) {
  const auto [low, high] = std::minmax(scale.farthest, scale.nearest);
  if (!(value >= low && value <= high)) {  // so that NaN is refused too
    throw InputError(fmt::format("thresholds: '{}' is {}, but the similarity measure goes from {} to {}; choose a value in "
                                 "that range",
                                 name, number_text(value), number_text(low), number_text(high)));
  }
}

}  // namespace

std::array<double, kComponents> components(const Wrench& wrench) {
  const auto v = wrench.vector();
  return {v[0], v[1], v[2], v[3], v[4], v[5]};
}

InternalCritic::InternalCritic(std::shared_ptr<const Similarity> first, std::shared_ptr<const Similarity> second,
                               FuzzyPartition partition, Thresholds thresholds)
    : first_(std::move(first)), second_(std::move(second)), partition_(std::move(partition)), thresholds_(thresholds),
      scale_(first_->scale(partition_.size())), second_scale_(second_->scale(partition_.size())) {
  check_threshold("estimation", thresholds_.estimation, scale_);
  check_threshold("recognition", thresholds_.recognition, scale_);
}

Criticism InternalCritic::judge(const std::array<double, kComponents>& task,
                                const std::array<double, kComponents>& pattern) const {
  const Patterns q(partition_, task), w(partition_, pattern);
  Criticism criticism;
  first_->compare(q.view(), w.view(), {&criticism.first, 1});
  second_->compare(q.view(), w.view(), {&criticism.second, 1});
  first_->component_scores(q.view(), w.view(), criticism.components);
  return criticism;
}

void InternalCritic::score(const std::array<double, kComponents>& task, std::span<const Wrench> wrenches,
                           std::span<StationScore> scores) const {
  const Patterns q(partition_, task);
  Patterns patterns(partition_);
  for (const auto& wrench : wrenches) patterns.add(components(wrench));
  std::vector<double> first(wrenches.size()), second(wrenches.size());
  first_->compare(q.view(), patterns.view(), first);
  second_->compare(q.view(), patterns.view(), second);
  const double sign = scale_.higher_is_nearer() ? 1.0 : -1.0, second_sign = second_scale_.higher_is_nearer() ? 1.0 : -1.0;
  for (std::size_t i = 0; i < wrenches.size(); ++i) scores[i] = {sign * first[i], second_sign * second[i]};
}

bool InternalCritic::nearer(const Criticism& a, const Criticism& b) const {
  if (a.first != b.first) return scale_.nearer(a.first, b.first);
  return second_scale_.nearer(a.second, b.second);
}

}  // namespace preshape
