// The mathematics of similarity measures, S01 and on.
#include <algorithm>
#include <cmath>

#include "formulas.h"
#include "patterns.h"

namespace preshape::conformance {

namespace {

constexpr double kTolerance = 1e-12;  // of a score, over the width of its scale

/// A measure with its scale for the patterns of a check.
struct Measured {
  std::shared_ptr<Similarity> measure;
  SimilarityScale scale;
  double slack;  ///< of two scores that should be equal

  Measured(Context& context, int sets = 7)
      : measure(context.create<Similarity>()), scale(measure->scale(sets)),
        slack(kTolerance * std::abs(scale.nearest - scale.farthest)) {}

  double operator()(const PatternView& task, const PatternView& pattern) const { return score(*measure, task, pattern); }
  double operator()(Case task, Case pattern) const {
    return (*this)(pattern_of(task).view(), pattern_of(pattern).view());
  }
  /// a is nearer than b by more than rounding.
  bool clearly_nearer(double a, double b) const { return scale.nearer(a, b) && std::abs(a - b) > slack; }
};

/// Two crisp vectors.
std::vector<Block> two_vectors() {
  return {{"task", kComponents, -2.0, 2.0, kCrispCorners}, {"pattern", kComponents, -2.0, 2.0, kCrispCorners}};
}

constexpr int kSets = 7, kDegrees = kComponents * kSets;

Block memberships(const char* name) { return {name, kDegrees, 0.0, 1.0, {0.0, 1.0, 0.5}}; }

void s01_stays_in_its_scale(Context& context) {
  for (const auto& partition : partitions()) {
    const Measured s(context, partition.size());
    const auto [low, high] = std::minmax(s.scale.farthest, s.scale.nearest);
    context.require(std::isfinite(low) && std::isfinite(high) && low < high,
                    "its scale for {} sets is {} .. {}", partition.size(), s.scale.farthest, s.scale.nearest);
    const auto blocks = two_vectors();
    context.for_all(blocks, context.cases(2000), [&, lowest = low, highest = high](Case c) -> std::string {
      const double value = s(pattern_of(c.first(6), partition).view(), pattern_of(c.last(6), partition).view());
      if (value >= lowest - s.slack && value <= highest + s.slack) return "";
      return fmt::format("the score {} is outside its scale {} .. {} for {} sets", value, lowest, highest, partition.size());
    });
  }
}

void s02_nothing_is_nearer_than_itself(Context& context) {
  const Measured s(context);
  const bool reflexive = context.declares("reflexive");
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(2000), [&](Case c) -> std::string {
    const double self = s(c.first(6), c.first(6)), other = s(c.first(6), c.last(6));
    if (reflexive && std::abs(self - s.scale.nearest) > s.slack) {
      return fmt::format("s(task, task) = {}, though the nearest is {}", self, s.scale.nearest);
    }
    return s.clearly_nearer(other, self) ? fmt::format("the pattern ({}) is nearer to the task than the task itself ({})", other, self) : "";
  });
}

void s03_symmetric(Context& context) {
  const Measured s(context);
  bool differs = false;
  const bool declared = context.declares("symmetric");
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(2000), [&](Case c) -> std::string {
    const double ab = s(c.first(6), c.last(6)), ba = s(c.last(6), c.first(6));
    differs = differs || ab != ba;
    return declared && ab != ba ? fmt::format("s(task, pattern) = {} and s(pattern, task) = {}", ab, ba) : "";
  });
  if (!declared && !differs) context.warn("no pair with s(a, b) != s(b, a) was found; it may promise 'symmetric'");
}

void s04_separating(Context& context) {
  const Measured s(context);
  const Block blocks[] = {memberships("memberships"), {"changed", 1, 0, kDegrees - 1, {}, true}};
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    const RawPattern a(c.first(kDegrees), kSets);
    RawPattern b = a;
    const auto i = static_cast<std::size_t>(c.back());
    b.memberships[i] += b.memberships[i] > 0.5 ? -1e-6 : 1e-6;
    b.crisp[i / kSets] += 1e-6;
    const double self = s(a.view(), a.view()), other = s(a.view(), b.view());
    return s.scale.nearer(self, other) ? "" : fmt::format("a membership that differs by 1e-6 gives {}, equal ones {}", other, self);
  });
}

void s05_monotone(Context& context) {
  const Measured s(context);
  const Block blocks[] = {memberships("A"), memberships("B_above_A"), memberships("C_above_B")};
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    std::vector<double> b(kDegrees), top(kDegrees);
    for (std::size_t i = 0; i < kDegrees; ++i) {
      b[i] = c[i] + (1.0 - c[i]) * c[kDegrees + i];
      top[i] = b[i] + (1.0 - b[i]) * c[2 * kDegrees + i];
    }
    const RawPattern A(c.first(kDegrees), kSets), B(b, kSets), C(top, kSets);
    const double ac = s(A.view(), C.view()), ab = s(A.view(), B.view()), bc = s(B.view(), C.view());
    if (!s.clearly_nearer(ac, ab) && !s.clearly_nearer(ac, bc)) return "";
    return fmt::format("for A <= B <= C, s(A, C) = {} is nearer than s(A, B) = {} or s(B, C) = {}", ac, ab, bc);
  });
}

void s07_crisp_complement(Context& context) {
  const Measured s(context);
  const Block blocks[] = {{"belongs", kDegrees, 0.0, 1.0, {}, true}};
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    std::vector<double> complement(c.begin(), c.end());
    for (double& degree : complement) degree = 1.0 - degree;
    const RawPattern a(c, kSets), b(complement, kSets);
    const double value = s(a.view(), b.view());
    return std::abs(value - s.scale.farthest) <= s.slack ? "" : fmt::format("s(D, 1 - D) = {}, though the farthest is {}", value, s.scale.farthest);
  });
}

void s08_permutation(Context& context) {
  const Measured s(context);
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    const auto rotated = [](Case six) {
      std::vector<double> turned(six.begin(), six.end());
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      return turned;
    };
    const double plain = s(c.first(6), c.last(6)), turned = s(rotated(c.first(6)), rotated(c.last(6)));
    return std::abs(plain - turned) <= s.slack ? "" : fmt::format("with the components moved by one place the score is {} instead of {}", turned, plain);
  });
}

/// The largest change of the score over a step of that size along a segment, walked in `steps`.
double largest_step(const Measured& s, const RawPattern& task, Case from, Case to, int steps) {
  double largest = 0.0, before = 0.0;
  for (int k = 0; k <= steps; ++k) {
    std::vector<double> degrees(kDegrees);
    RawPattern pattern(degrees, kSets);
    for (std::size_t i = 0; i < kDegrees; ++i) pattern.memberships[i] = from[i] + (to[i] - from[i]) * k / steps;
    for (std::size_t i = 0; i < kComponents; ++i) pattern.crisp[i] = from[i] + (to[i] - from[i]) * k / steps;
    const double now = s(task.view(), pattern.view());
    if (k > 0) largest = std::max(largest, std::abs(now - before));
    before = now;
  }
  return largest;
}

void s11_continuous(Context& context) {
  const Measured s(context);
  const Block blocks[] = {memberships("task"), memberships("from"), memberships("to")};
  const double width = std::abs(s.scale.nearest - s.scale.farthest);
  context.for_all(blocks, context.cases(10), [&](Case c) -> std::string {
    const RawPattern task(c.first(kDegrees), kSets);
    // A jump stays when the step shrinks; a slope, even that of a root, shrinks with it.
    const double coarse = largest_step(s, task, c.subspan(kDegrees, kDegrees), c.last(kDegrees), 100);
    const double fine = largest_step(s, task, c.subspan(kDegrees, kDegrees), c.last(kDegrees), 4000);
    if (fine <= 0.01 * width || fine <= 0.5 * coarse) return "";
    return fmt::format("between two patterns a step of 1/4000 of the way changes the score by {}", fine);
  });
}

void s12_metric(Context& context) {
  const Measured s(context);
  const Block blocks[] = {memberships("a"), memberships("b"), memberships("c"), {"b_is_between", 1, 0, 1, {}, true}};
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    std::vector<double> b(c.begin() + kDegrees, c.begin() + 2 * kDegrees);
    // On the straight way the triangle has no slack.
    for (std::size_t i = 0; i < kDegrees && c.back() == 1.0; ++i) b[i] = 0.5 * (c[i] + c[2 * kDegrees + i]);
    const RawPattern p(c.first(kDegrees), kSets), q(b, kSets), r(c.subspan(2 * kDegrees, kDegrees), kSets);
    const auto distance = [&](const RawPattern& x, const RawPattern& y) { return std::abs(s(x.view(), y.view()) - s.scale.nearest); };
    const double pq = distance(p, q), qr = distance(q, r), pr = distance(p, r);
    return pr <= pq + qr + 2 * s.slack ? "" : fmt::format("the way from a to c ({}) is longer than that by b ({} + {})", pr, pq, qr);
  });
}

void s14_formula(Context& context) {
  const Formula* formula = nullptr;
  for (const auto& capability : context.record().capabilities) {
    if (const Formula* named = formula_named(capability)) formula = named;
  }
  if (!formula) context.skip("it does not say which published formula it is");
  const Measured s(context);
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(2000), [&](Case c) -> std::string {
    const Patterns task = pattern_of(c.first(6)), pattern = pattern_of(c.last(6));
    const double expected = formula->score(task.view(), pattern.view()), value = s(task.view(), pattern.view());
    return std::abs(value - expected) <= 1e-10 * std::max(1.0, std::abs(expected))
               ? "" : fmt::format("the score is {}, by {} it is {}", value, formula->source, expected);
  });
}

void s15_inclusion(Context& context) {
  const Measured s(context);
  const Block blocks[] = {memberships("task"), memberships("above")};
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    std::vector<double> more(kDegrees);
    for (std::size_t i = 0; i < kDegrees; ++i) more[i] = c[i] + (1.0 - c[i]) * c[kDegrees + i];
    const RawPattern task(c.first(kDegrees), kSets), pattern(more, kSets);
    const double value = s(task.view(), pattern.view());
    return std::abs(value - s.scale.nearest) <= s.slack ? "" : fmt::format("a pattern that includes the task scores {}, though the nearest is {}", value, s.scale.nearest);
  });
}

void s17_scale_invariant(Context& context) {
  const Measured s(context);
  const Block blocks[] = {{"task", 6, -2.0, 2.0, kCrispCorners}, {"pattern", 6, -2.0, 2.0, kCrispCorners}, {"factor", 1, 0.01, 100.0, {0.5, 2.0}}};
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    std::vector<double> scaled(c.begin() + 6, c.begin() + 12);
    for (double& x : scaled) x *= c[12];
    const double plain = s(c.first(6), c.subspan(6, 6)), now = s(c.first(6), scaled);
    return std::abs(plain - now) <= 10 * s.slack ? "" : fmt::format("the pattern times {} scores {} instead of {}", c[12], now, plain);
  });
}

void s18_components(Context& context) {
  const Measured s(context);
  const bool additive = context.declares("additive");
  const auto blocks = two_vectors();
  context.for_all(blocks, context.cases(1000), [&](Case c) -> std::string {
    const Patterns task = pattern_of(c.first(6)), pattern = pattern_of(c.last(6));
    std::array<double, kComponents> parts;
    s.measure->component_scores(task.view(), pattern.view(), parts);
    double sum = 0.0;
    for (const double part : parts) sum += part;
    const double whole = s(task.view(), pattern.view());
    if (!std::isfinite(sum)) return "a component's score is not finite";
    return !additive || std::abs(sum - whole) <= 10 * s.slack ? "" : fmt::format("the components' scores add up to {}, the score is {}", sum, whole);
  });
}

constexpr Check kChecks[] = {
    {"S01", "similarity", "every score is finite and inside the declared scale", s01_stays_in_its_scale},
    {"S02", "similarity", "no pattern is nearer to a task than the task itself, which is as near as can be if promised", s02_nothing_is_nearer_than_itself},
    {"S03", "similarity", "s(a, b) = s(b, a) bit for bit if promised", s03_symmetric},
    {"S04", "similarity", "patterns that differ are farther than equal ones", s04_separating, "separating"},
    {"S05", "similarity", "of nested memberships the outermost is no nearer than those between", s05_monotone, "monotone"},
    {"S07", "similarity", "a crisp pattern and its complement are as far as can be", s07_crisp_complement, "crisp_complement"},
    {"S08", "similarity", "the order of the components does not matter", s08_permutation, "permutation_invariant"},
    {"S11", "similarity", "the score makes no jumps", s11_continuous, "continuous"},
    {"S12", "similarity", "distances obey the triangle inequality", s12_metric, "metric"},
    {"S14", "similarity", "it is the published formula that it says it is", s14_formula},
    {"S15", "similarity", "a pattern that includes the task is as near as can be", s15_inclusion, "inclusion"},
    {"S17", "similarity", "the length of the pattern's vector does not matter", s17_scale_invariant, "scale_invariant"},
    {"S18", "similarity", "the components' scores are finite and add up to the score if promised", s18_components},
};

}  // namespace

std::span<const Check> similarity_checks() { return kChecks; }

}  // namespace preshape::conformance
