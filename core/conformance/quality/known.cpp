// Grasps whose numbers are known, and grasps that tempt a measure to divide by zero.
#include <algorithm>
#include <cmath>
#include <optional>

#include "../contact/frames.h"
#include "quality.h"

namespace preshape::conformance {

namespace {

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

}  // namespace

std::string out_of_range(std::span<const QualityNumber> numbers, std::span<const double> values) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double width = numbers[i].highest - numbers[i].lowest, slack = std::isfinite(width) ? 1e-12 * width : 0.0;
    if (std::isfinite(values[i]) && values[i] >= numbers[i].lowest - slack && values[i] <= numbers[i].highest + slack) continue;
    return fmt::format("'{}' is {}, outside its range {} .. {}", numbers[i].name, values[i], numbers[i].lowest, numbers[i].highest);
  }
  return "";
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

}  // namespace preshape::conformance
