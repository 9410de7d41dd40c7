// The numbers that a quality measure gives for a virtual grasp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "../contact/frames.h"
#include "preshape/base/value.h"
#include "quality.h"

namespace preshape::conformance {

namespace {

// A turned or re-ordered grasp is the same up to roundings, which a division by a small singular value makes larger.
constexpr double kTolerance = 1e-8;

/// The first of `count` numbers that differ by more than the tolerance.
std::string changed(const QualityMeasure& measure, const Grasp& before, const Grasp& now, std::size_t count, double tolerance) {
  const auto numbers = measure.numbers();
  const auto a = evaluated(measure, before), b = evaluated(measure, now);
  for (std::size_t i = 0; i < std::min(count, a.size()); ++i) {
    if (std::abs(a[i] - b[i]) <= tolerance * std::max({1.0, std::abs(a[i]), std::abs(b[i])})) continue;
    return fmt::format("'{}' was {} and became {}", numbers[i].name, number_text(a[i]), number_text(b[i]));
  }
  return "";
}

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// A property of grasps with 2, 3 and 5 contacts, each with the numbers of `more` beside it.
void for_grasps(Context& context, int count, const Block& more,
                const std::function<std::string(const GraspCase&, Case more)>& property) {
  for (const int contacts : {2, 3, 5}) {
    auto blocks = grasp_blocks(contacts);
    blocks.push_back(more);
    context.for_all(blocks, context.cases(count), [&](Case c) -> std::string {
      const GraspCase drawn = grasp_case(c, contacts);
      if (drawn.degenerate()) return "";
      return property(drawn, c.last(static_cast<std::size_t>(more.size)));
    });
  }
}
const Block kNoMore = {"none", 0};

void q01_in_range(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  for (const auto& number : measure->numbers()) {
    context.require(number.lowest < number.highest, "the range of '{}' is {} .. {}", number.name, number.lowest, number.highest);
  }
  for_grasps(context, 100, kNoMore, [&](const GraspCase& c, Case) {
    return out_of_range(measure->numbers(), evaluated(*measure, c.grasp()));
  });
}

std::string numbers_text(const QualityMeasure& measure) {
  std::string text;
  for (const auto& n : measure.numbers()) text += fmt::format("{} [{}] {} .. {} {}\n", n.name, n.unit, n.lowest, n.highest, n.higher_is_better);
  return text;
}

void q02_numbers(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  std::set<std::string> names;
  context.require(!measure->numbers().empty(), "it has no number");
  for (const auto& number : measure->numbers()) {
    context.require(!number.name.empty(), "one of its numbers has no name");
    context.require(!number.unit.empty(), "'{}' names no unit; \"-\" stands for none", number.name);
    context.require(names.insert(number.name).second, "two of its numbers are named '{}'", number.name);
  }
  const std::string before = numbers_text(*measure);
  evaluated(*measure, grasp_case(std::vector<double>(22, 0.5), 3).grasp());
  const std::string now = numbers_text(*measure), other = numbers_text(*context.create<QualityMeasure>());
  context.require(before == now, "after a grasp its numbers are\n{}and before they were\n{}", now, before);
  context.require(before == other, "another measure of it has the numbers\n{}and the first\n{}", other, before);
}

void frame_invariant(Context& context, std::size_t count) {
  const auto measure = context.create<QualityMeasure>();
  for_grasps(context, 40, rotation_block(), [&](const GraspCase& c, Case four) {
    const Eigen::Matrix3d R = rotation_of(four);
    Grasp turned = c.grasp();
    for (auto& contact : turned.contacts) contact = rotated(R, contact);
    for (auto& F : turned.F_C_O) F = F.rotated(R);
    turned.wrench_union = rotated(R, turned.wrench_union.transpose()).transpose();
    turned.resultant = turned.resultant.rotated(R);
    turned.approach_O = R * turned.approach_O;
    turned.opposition_O = R * turned.opposition_O;
    return changed(*measure, c.grasp(), turned, count, kTolerance);
  });
}
void q03_frame_invariant(Context& context) { frame_invariant(context, kAll); }
void q04_first_frame_invariant(Context& context) { frame_invariant(context, 1); }

void q05_permutation_invariant(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  for_grasps(context, 40, kNoMore, [&](const GraspCase& c, Case) {
    GraspCase reversed = c, shifted = c;
    std::reverse(reversed.contacts.begin() + 1, reversed.contacts.end());
    std::rotate(shifted.contacts.begin() + 1, shifted.contacts.end() - 1, shifted.contacts.end());
    std::string found = changed(*measure, c.grasp(), reversed.grasp(), kAll, kTolerance);
    return found.empty() ? changed(*measure, c.grasp(), shifted.grasp(), kAll, kTolerance) : found;
  });
}

void q06_force_scale_invariant(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  for_grasps(context, 40, {"factor", 1, 0.01, 100.0, {0.5, 2.0}}, [&](const GraspCase& c, Case factor) {
    Grasp scaled = c.grasp();
    for (auto& F : scaled.F_C_O) F = F * factor[0];
    scaled.wrench_union *= factor[0];
    scaled.resultant = scaled.resultant * factor[0];
    return changed(*measure, c.grasp(), scaled, kAll, kTolerance);
  });
}

void q08_writes_all(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  for_grasps(context, 30, kNoMore, [&](const GraspCase& c, Case) -> std::string {
    const auto clean = evaluated(*measure, c.grasp());
    for (const double before : {std::numeric_limits<double>::quiet_NaN(), 1e3}) {
      const auto over = evaluated(*measure, c.grasp(), before);
      for (std::size_t i = 0; i < clean.size(); ++i) {
        if (over[i] == clean[i]) continue;
        return fmt::format("'{}' is {} where there was 0 before, and {} where there was {}", measure->numbers()[i].name, clean[i], over[i], before);
      }
    }
    return "";
  });
}

void q09_length_cancels(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  // Powers of two, so that the normalised lengths are the same bit for bit.
  for_grasps(context, 40, {"octaves", 1, -10.0, 10.0, {}, true}, [&](const GraspCase& c, Case octaves) {
    Grasp enlarged = c.grasp();
    const double factor = std::exp2(octaves[0]);
    for (auto& contact : enlarged.contacts) contact.p_OC *= factor;
    enlarged.length_m *= factor;
    return changed(*measure, c.grasp(), enlarged, kAll, 1e-12);
  });
}

constexpr Check kChecks[] = {
    {"Q01", "quality", "every number is finite and in its declared range", q01_in_range},
    {"Q02", "quality", "it says which numbers it gives: each with a name of its own and a unit, always the same", q02_numbers},
    {"Q03", "quality", "rotating the grasp changes none of its numbers", q03_frame_invariant, "frame_invariant"},
    {"Q04", "quality", "rotating the grasp does not change its first number", q04_first_frame_invariant, "frame_invariant_first"},
    {"Q05", "quality", "the order of the contacts behind the thumb does not matter", q05_permutation_invariant, "permutation_invariant"},
    {"Q06", "quality", "multiplying all wrenches by a positive number changes nothing", q06_force_scale_invariant, "force_scale_invariant"},
    {"Q07", "quality", "one contact, many, several at one point or on a line get numbers in their ranges", q07_degenerate},
    {"Q08", "quality", "every number is written, whatever stood in its place", q08_writes_all},
    {"Q09", "quality", "enlarging the grasp with its characteristic length changes nothing", q09_length_cancels},
    {"Q10", "quality", "'stability' and 'manipulability' from 0 to 6 count the union's rank and the resultant's components", q10_known_counts},
};

}  // namespace

std::span<const Check> quality_checks() { return kChecks; }

}  // namespace preshape::conformance
