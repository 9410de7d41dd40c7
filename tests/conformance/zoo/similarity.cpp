// One broken similarity for each S check, and the good one.
#include <algorithm>

#include "measure.h"

namespace {

using namespace zoo;

struct Good final : Measure {
  using Measure::Measure;
  static auto capabilities() {
    return promises("symmetric", "additive", "reflexive", "separating", "monotone", "continuous", "metric", "crisp_complement",
                    "permutation_invariant");
  }
};

struct LeavesScale final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override { return 1.5 * Measure::one(task, pattern); }
};

struct PrefersOthers final : Measure {
  using Measure::Measure;
  double component(Degrees q, Degrees w) const override { return 1.0 - Measure::component(q, w); }
};

struct Asymmetric : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("symmetric"); }
  double component(Degrees q, Degrees w) const override {
    double missing = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) missing += std::max(0.0, q[i] - w[i]);
    return 1.0 - missing / static_cast<double>(q.size());
  }
};

struct Coarse final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("separating"); }
  double component(Degrees q, Degrees w) const override { return std::min(1.0, Measure::component(q, w) + 1e-3); }
};

struct NotMonotone final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("monotone"); }
  // The mean difference folded back: what is far becomes near again.
  double component(Degrees q, Degrees w) const override { return std::abs(2.0 * Measure::component(q, w) - 1.0); }
};

struct MildComplement final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("crisp_complement"); }
  double component(Degrees q, Degrees w) const override { return 0.5 + 0.5 * Measure::component(q, w); }
};

struct Weighted final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("permutation_invariant"); }
  double one(const PatternView& task, const PatternView& pattern) const override {
    double parts[kComponents];
    component_scores(task, pattern, parts);
    return 2.0 * parts[0] + 0.8 * (parts[1] + parts[2] + parts[3] + parts[4] + parts[5]);
  }
};

struct Steps final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("continuous"); }
  double one(const PatternView& task, const PatternView& pattern) const override { return std::floor(Measure::one(task, pattern)); }
};

struct SquaredDistance final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("metric"); }
  double component(Degrees q, Degrees w) const override {
    double squares = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) squares += (q[i] - w[i]) * (q[i] - w[i]);
    return 1.0 - squares / static_cast<double>(q.size());
  }
};

struct NotTheFormula final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("formula_tfvadi"); }
};

struct NoInclusion final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("inclusion"); }
};

struct KnowsLength final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("scale_invariant"); }
  double one(const PatternView& task, const PatternView& pattern) const override {
    double distance = 0.0;
    for (int k = 0; k < kComponents; ++k) distance += std::abs(task.crisp[k] - pattern.crisp[k]);
    return 6.0 / (1.0 + distance);
  }
};

struct PartsDoNotAddUp final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("additive"); }
  double one(const PatternView& task, const PatternView& pattern) const override { return 0.9 * Measure::one(task, pattern); }
};

}  // namespace

PRESHAPE_PLUGIN(({"zoo.similarity", "1.0.0", "BSD-3-Clause", "the preshape developers", "Similarities broken on purpose"}),
                ({"similarity/good", "similarity/s01_leaves_scale", "similarity/s02_prefers_others", "similarity/s03_asymmetric",
                  "similarity/s04_coarse", "similarity/s05_not_monotone", "similarity/s07_mild_complement", "similarity/s08_weighted",
                  "similarity/s11_steps", "similarity/s12_squared_distance", "similarity/s14_not_the_formula",
                  "similarity/s15_no_inclusion", "similarity/s17_knows_length", "similarity/s18_parts_do_not_add_up"}),
                preshape::component<Good>("good", "without a fault"),
                preshape::component<LeavesScale>("s01_leaves_scale", "scores beyond its scale"),
                preshape::component<PrefersOthers>("s02_prefers_others", "nearest to what differs most"),
                preshape::component<Asymmetric>("s03_asymmetric", "promises symmetry"),
                preshape::component<Coarse>("s04_coarse", "takes near ones for equal"),
                preshape::component<NotMonotone>("s05_not_monotone", "near again when far away"),
                preshape::component<MildComplement>("s07_mild_complement", "half way to the complement"),
                preshape::component<Weighted>("s08_weighted", "one component counts more"),
                preshape::component<Steps>("s11_steps", "whole numbers only"),
                preshape::component<SquaredDistance>("s12_squared_distance", "a square is no metric"),
                preshape::component<NotTheFormula>("s14_not_the_formula", "says it is TFVADI"),
                preshape::component<NoInclusion>("s15_no_inclusion", "promises inclusion"),
                preshape::component<KnowsLength>("s17_knows_length", "promises to look at directions alone"),
                preshape::component<PartsDoNotAddUp>("s18_parts_do_not_add_up", "a tenth is lost"))
