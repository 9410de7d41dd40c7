// The numbers that a quality measure gives for a virtual grasp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "../contact/frames.h"
#include "grasps.h"
#include "preshape/base/value.h"

namespace preshape::conformance {

namespace {

// A turned or re-ordered grasp is the same up to roundings, which a division by a small singular value makes larger.
constexpr double kTolerance = 1e-8;

/// "" when all values are finite and in the declared ranges.
std::string out_of_range(std::span<const QualityNumber> numbers, std::span<const double> values) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double width = numbers[i].highest - numbers[i].lowest, slack = std::isfinite(width) ? 1e-12 * width : 0.0;
    if (std::isfinite(values[i]) && values[i] >= numbers[i].lowest - slack && values[i] <= numbers[i].highest + slack) continue;
    return fmt::format("'{}' is {}, outside its range {} .. {}", numbers[i].name, values[i], numbers[i].lowest, numbers[i].highest);
  }
  return "";
}

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

ContactFrame frame(double x, double y, double z, const Eigen::Vector3d& n) {
  return ContactFrame::at({x, y, z}, n, std::abs(n.z()) > 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ());
}

struct NamedGrasp {
  const char* what;
  std::vector<ContactFrame> contacts;
};

std::vector<NamedGrasp> degenerate_grasps() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  std::vector<NamedGrasp> all = {{"one contact", {frame(0.1, 0.2, 0.3, x)}},
                                 {"one contact at the origin", {frame(0, 0, 0, x)}},
                                 {"two contacts at one point", {frame(0.1, 0, 0, x), frame(0.1, 0, 0, x)}},
                                 {"two that press on each other", {frame(-0.1, 0, 0, x), frame(0.1, 0, 0, -x)}},
                                 {"three on a line", {frame(-0.1, 0, 0, y), frame(0, 0, 0, y), frame(0.1, 0, 0, -y)}},
                                 {"three at one point", {frame(0, 0.1, 0, x), frame(0, 0.1, 0, y), frame(0, 0.1, 0, -x)}},
                                 {"forty", {}}};
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.7 * i;
    all.back().contacts.push_back(frame(std::cos(angle), std::sin(angle), 0.01 * i, {-std::cos(angle), -std::sin(angle), 0.0}));
  }
  return all;
}

void q07_degenerate(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  for (const auto& [what, contacts] : degenerate_grasps()) {
    for (const Transmits transmits : {Transmits::kNormal, Transmits::kForce, Transmits::kForceAndSpin}) {
      Grasp grasp = grasp_of(contacts, transmits);
      for (const bool at_rest : {false, true}) {
        if (at_rest) grasp.resultant = Wrench();
        const std::string found = out_of_range(measure->numbers(), evaluated(*measure, grasp));
        context.require(found.empty(), "of {}, {} unit wrenches each{}, {}", what, static_cast<int>(transmits),
                        at_rest ? " and no resultant" : "", found);
      }
    }
  }
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

/// The measure's number of that name when it counts from 0 to 6.
std::optional<std::size_t> count_named(const QualityMeasure& measure, std::string_view name) {
  const auto numbers = measure.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].name == name && numbers[i].lowest == 0.0 && numbers[i].highest == 6.0) return i;
  }
  return std::nullopt;
}

struct KnownRank {
  const char* what;
  std::vector<ContactFrame> contacts;
  Transmits transmits;
  int rank;
};

std::vector<KnownRank> known_ranks() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  const double half = 0.5, root = std::sqrt(3.0) / 2.0;
  const std::vector<ContactFrame> one = {frame(0.1, 0.2, 0.3, x)}, opposed = {frame(-0.1, 0, 0, x), frame(0.1, 0, 0, -x)},
                                  point = {frame(0.1, 0, 0, x), frame(0.1, 0, 0, y)},
                                  line = {frame(-0.1, 0, 0, y), frame(0, 0, 0, y), frame(0.1, 0, 0, y)},
                                  star = {frame(0.1, 0, 0, -x), frame(-half * 0.1, root * 0.1, 0, {half, -root, 0}),
                                          frame(-half * 0.1, -root * 0.1, 0, {half, root, 0})};
  using enum Transmits;
  return {{"one contact without friction", one, kNormal, 1}, {"one point contact with friction", one, kForce, 3},
          {"one soft finger", one, kForceAndSpin, 4},        {"two opposed contacts without friction", opposed, kNormal, 1},
          {"two opposed point contacts", opposed, kForce, 5}, {"two opposed soft fingers", opposed, kForceAndSpin, 6},
          {"two point contacts at one point", point, kForce, 3}, {"three point contacts on a line", line, kForce, 5},
          {"three contacts without friction whose normals meet", star, kNormal, 2},
          {"three point contacts", star, kForce, 6}};
}

void q10_known_counts(Context& context) {
  const auto measure = context.create<QualityMeasure>();
  const auto stability = count_named(*measure, "stability"), manipulability = count_named(*measure, "manipulability");
  if (!stability && !manipulability) context.skip("it has no number 'stability' or 'manipulability' from 0 to 6");
  for (const auto& known : known_ranks()) {
    if (!stability) break;
    const double value = evaluated(*measure, grasp_of(known.contacts, known.transmits))[*stability];
    context.require(value == known.rank, "the wrenches of {} have the rank {}, but 'stability' is {}", known.what, known.rank, value);
  }
  for (unsigned pattern = 0; manipulability && pattern < 64; ++pattern) {
    Grasp grasp = grasp_of({frame(0.1, 0.2, 0.3, Eigen::Vector3d::UnitX())}, Transmits::kForceAndSpin);
    Eigen::Matrix<double, 6, 1> resultant = Eigen::Matrix<double, 6, 1>::Zero();
    int count = 0;
    for (int i = 0; i < 6; ++i) {
      if (!(pattern >> i & 1u)) continue;
      resultant[i] = i % 2 ? -20.0 : 20.0;  // beyond any limit that a measure may be set to
      ++count;
    }
    grasp.resultant = Wrench::from_vector(resultant);
    const double value = evaluated(*measure, grasp)[*manipulability];
    context.require(value == count, "the resultant {} has {} components, but 'manipulability' is {}", wrench_text(resultant), count, value);
  }
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
