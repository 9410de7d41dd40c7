#include "preshape/io/membership_svg.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "preshape/io/svg.h"

namespace preshape {

namespace {

constexpr double kWidth = 900, kLeft = 60, kRight = 20, kPlotHeight = 260, kBelow = 50, kTitle = 34, kRow = 16;
constexpr double kText = 12;           // [px]
constexpr double kLetter = 0.62 * kText;  // a wide letter of a plain face
constexpr double kHalfPixel = 0.5 / kPlotHeight;
constexpr const char* kInk = "#222222";
constexpr const char* kGrid = "#dddddd";
constexpr const char* kGapShade = "#f7d9d9";

/// Where a label stands: rows count upwards from the plot.
struct Label {
  double x = 0.0;
  int row = 0;
};

/// Labels above their tops, in as few rows as keep them apart.
std::vector<Label> labels_of(const FuzzyPartition& partition, const SvgScale& across) {
  std::vector<Label> labels;
  std::vector<double> taken;  // the end of each row's last label
  std::vector<int> order(static_cast<std::size_t>(partition.size()));
  for (int i = 0; i < partition.size(); ++i) order[static_cast<std::size_t>(i)] = i;
  const auto middle = [&](int i) {
    const double half = 0.5 * kLetter * static_cast<double>(partition[i].name.size());
    return std::clamp(across(std::clamp(partition[i].top_middle(), across.from, across.to)),
                      std::min(across.at_from + half, 0.5 * kWidth), std::max(across.at_to - half, 0.5 * kWidth));
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return middle(a) < middle(b); });
  labels.resize(order.size());
  for (const int i : order) {
    const double half = 0.5 * kLetter * static_cast<double>(partition[i].name.size()) + 4;
    const auto free = std::find_if(taken.begin(), taken.end(), [&](double end) { return end <= middle(i) - half; });
    labels[static_cast<std::size_t>(i)] = {middle(i), static_cast<int>(free - taken.begin())};
    if (free == taken.end()) taken.push_back(middle(i) + half);
    else *free = middle(i) + half;
  }
  return labels;
}

/// Where a set's line is drawn through: evenly, and on both sides of its corners, where it may jump; not along the axis,
/// where it would hide the others.
std::vector<double> course_of(const Membership& set, const Interval& universe) {
  constexpr int kEven = 300;
  std::vector<double> xs;
  for (int i = 0; i <= kEven; ++i) xs.push_back(universe.from + universe.width() * i / kEven);
  if (set.shape <= Membership::Shape::kTriangle) {
    xs = {universe.from, universe.to};
    for (const double x : set.points) xs.insert(xs.end(), {std::nextafter(x, -INFINITY), x, std::nextafter(x, INFINITY)});
  }
  xs.push_back(set.top_middle());
  xs.push_back(std::nextafter(set.top_middle(), -INFINITY)), xs.push_back(std::nextafter(set.top_middle(), INFINITY));
  const Interval above = alpha_cut(set, kHalfPixel);
  const Interval seen = intersection(universe, {std::nextafter(above.from, -INFINITY), std::nextafter(above.to, INFINITY)});
  if (!seen.empty()) xs.insert(xs.end(), {seen.from, seen.to});
  std::erase_if(xs, [&](double x) { return x < seen.from || x > seen.to; });
  std::sort(xs.begin(), xs.end());
  return xs;
}

/// Leaves out points on the straight way between their neighbours.
std::vector<Eigen::Vector2d> without_needless(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> kept;
  for (const auto& p : points) {
    if (!kept.empty() && (p - kept.back()).norm() < 1e-6) continue;
    if (kept.size() >= 2) {
      const Eigen::Vector2d a = kept.back() - kept[kept.size() - 2], b = p - kept.back();
      if (std::abs(a.x() * b.y() - a.y() * b.x()) < 1e-6 && a.dot(b) > 0) kept.pop_back();
    }
    kept.push_back(p);
  }
  return kept;
}

void draw_axes(Svg& svg, const SvgScale& across, const SvgScale& up, double bound) {
  for (const double degree : up.ticks(6)) {
    svg.line(across.at_from, up(degree), across.at_to, up(degree), {.stroke = kGrid});
    svg.text(across.at_from - 8, up(degree) + 4, fmt::format("{:g}", degree), SvgAnchor::kEnd, kText, kInk);
  }
  for (const double x : across.ticks(13)) {
    svg.line(across(x), up.at_from, across(x), up.at_from + 5, {.stroke = kInk});
    svg.text(across(x), up.at_from + 19, fmt::format("{:.6g}", x), SvgAnchor::kMiddle, kText, kInk);
  }
  svg.line(across.at_from, up(bound), across.at_to, up(bound), {.stroke = "#888888", .dash = "5 4"});
  svg.line(across.at_from, up.at_from, across.at_to, up.at_from, {.stroke = kInk});
  svg.line(across.at_from, up.at_from, across.at_from, up.at_to, {.stroke = kInk});
  svg.text((across.at_from + across.at_to) / 2, up.at_from + 40, "x", SvgAnchor::kMiddle, kText, kInk);
  svg.text(18, (up.at_from + up.at_to) / 2, "degree of membership", SvgAnchor::kMiddle, kText, kInk, true);
}

}  // namespace

std::string membership_svg(const FuzzyPartition& partition, const PartitionFindings& findings, const std::string& title) {
  const SvgScale across{findings.universe.from, findings.universe.to, kLeft, kWidth - kRight};
  const auto labels = labels_of(partition, across);
  int rows = 0;
  for (const Label& label : labels) rows = std::max(rows, label.row + 1);
  const double top = kTitle + rows * kRow + 8, height = top + kPlotHeight + kBelow;
  const SvgScale up{0.0, 1.0, top + kPlotHeight, top};
  Svg svg(kWidth, height, title);
  svg.text(kWidth / 2, 22, title, SvgAnchor::kMiddle, 15, kInk);
  for (const Gap& gap : findings.gaps) {
    const double x = across(gap.where.from), width = std::max(1.0, across(gap.where.to) - x);
    svg.rectangle(x, up.at_to, width, kPlotHeight, {.fill = kGapShade});
  }
  draw_axes(svg, across, up, findings.bound);
  for (int i = 0; i < partition.size(); ++i) {
    std::vector<Eigen::Vector2d> points;
    for (const double x : course_of(partition[i], findings.universe)) points.emplace_back(across(x), up(partition[i](x)));
    const SvgStyle style{.stroke = std::string(svg_colour(i)), .width = 2, .dash = i < 8 ? "" : i < 16 ? "7 4" : "2 3"};
    svg.path(without_needless(points), style, partition[i].name);
    const Label& label = labels[static_cast<std::size_t>(i)];
    svg.text(label.x, top - 8 - label.row * kRow, partition[i].name, SvgAnchor::kMiddle, kText, svg_colour(i));
  }
  return svg.file();
}

}  // namespace preshape
