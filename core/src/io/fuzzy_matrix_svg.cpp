#include "preshape/io/fuzzy_matrix_svg.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "preshape/io/svg.h"

namespace preshape {

namespace {

constexpr double kTop = 92, kCellHeight = 30, kName = 44, kCrisp = 66, kGap = 34, kLast = 96,
                 kText = 12;  // [px]
constexpr const char* kInk = "#222222";
constexpr const char* kLine = "#c8c8c8";

/// White to dark blue, which keeps its order in grey.
std::string degree_colour(double degree) {
  const double d = std::clamp(degree, 0.0, 1.0);
  const auto mix = [d](double none, double all) {
    return static_cast<int>(std::lround(none + d * (all - none)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(252, 24), mix(252, 70), mix(252, 130));
}

/// One 6 x sets matrix with its crisp numbers to the left.
struct MatrixDrawing {
  const FuzzyPartition& partition;
  double cell_width;

  double width() const { return kName + kCrisp + cell_width * partition.size(); }

  void draw(Svg& svg, double left, const std::string& heading,
            const std::array<const char*, kComponents>& names,
            const std::array<double, kComponents>* vector) const {
    const double cells = left + kName + kCrisp;
    svg.text(cells, 52, heading, SvgAnchor::kStart, kText + 1, kInk);
    for (int s = 0; s < partition.size(); ++s) {
      svg.text(cells + (s + 0.5) * cell_width, kTop - 10, partition[s].name, SvgAnchor::kMiddle, kText - 1,
               kInk);
    }
    std::vector<double> degrees(static_cast<std::size_t>(partition.size()));
    for (int c = 0; c < kComponents; ++c) {
      const auto component = static_cast<std::size_t>(c);
      const double y = kTop + c * kCellHeight;
      svg.text(left + kName - 8, y + 19, names[component], SvgAnchor::kEnd, kText, kInk);
      if (!vector) {
        svg.rectangle(cells, y, cell_width * partition.size(), kCellHeight,
                      {.stroke = kLine, .fill = "#e6e6e6"}, "no grasp");
        svg.hatch(cells, y, cell_width * partition.size(), kCellHeight, 9,
                  {.stroke = "#a8a8a8", .width = 0.7});
        continue;
      }
      svg.text(left + kName + kCrisp - 10, y + 19, fmt::format("{:.4f}", (*vector)[component]),
               SvgAnchor::kEnd, kText, kInk);
      partition.fuzzify((*vector)[component], degrees);
      for (int s = 0; s < partition.size(); ++s) {
        const double degree = degrees[static_cast<std::size_t>(s)], x = cells + s * cell_width;
        svg.rectangle(x, y, cell_width, kCellHeight, {.stroke = kLine, .fill = degree_colour(degree)},
                      fmt::format("{} {}: {:.6g}", names[component], partition[s].name, degree));
        svg.text(x + cell_width / 2, y + 19, fmt::format("{:.2f}", degree), SvgAnchor::kMiddle, kText - 1,
                 degree > 0.5   ? "#ffffff"
                 : degree > 0.0 ? kInk
                                : "#999999");
      }
    }
  }
};

constexpr std::array<const char*, kComponents> kTaskNames = {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
constexpr std::array<const char*, kComponents> kWrenchNames = {"fx", "fy", "fz", "mx", "my", "mz"};

void draw_scores(Svg& svg, double left, const FuzzyMatrices& matrices) {
  svg.text(left, kTop - 10, matrices.measure, SvgAnchor::kStart, kText, kInk);
  if (!matrices.compared) return;
  for (int c = 0; c < kComponents; ++c) {
    svg.text(left, kTop + c * kCellHeight + 19,
             fmt::format("{:.4f}", matrices.compared->components[static_cast<std::size_t>(c)]),
             SvgAnchor::kStart, kText, kInk);
  }
  svg.line(left, kTop + kComponents * kCellHeight + 2, left + 60, kTop + kComponents * kCellHeight + 2,
           {.stroke = kInk});
  svg.text(left, kTop + kComponents * kCellHeight + 20,
           fmt::format("{:.4f} in all", matrices.compared->score), SvgAnchor::kStart, kText, kInk);
}

}  // namespace

FuzzyMatrices fuzzy_matrices(const RunRecord& record) {
  FuzzyMatrices matrices;
  const Report& report = record.report;
  matrices.title =
      fmt::format("Task {} and the grasp of {}", report.task.name.empty() ? "as given" : report.task.name,
                  record.object->object.name);
  matrices.measure = record.measure;
  matrices.partition = record.partition;
  matrices.task = report.task.screw;
  if (report.result && report.result->grasp.is_grasp()) {
    matrices.compared = {components(report.result->grasp.resultant), report.result->criticism.components,
                         report.result->criticism.first};
  }
  return matrices;
}

std::string fuzzy_matrix_svg(const FuzzyMatrices& matrices) {
  std::size_t longest = 5;
  for (const Membership& set : matrices.partition.sets()) longest = std::max(longest, set.name.size());
  const MatrixDrawing drawing{matrices.partition,
                              std::clamp(7.2 * static_cast<double>(longest) + 8, 44.0, 120.0)};
  const double second = 10 + drawing.width() + kGap, scores = second + drawing.width() + kGap / 2;
  Svg svg(scores + kLast, kTop + kComponents * kCellHeight + 36, matrices.title);
  svg.text(16, 26, matrices.title, SvgAnchor::kStart, 15, kInk);
  drawing.draw(svg, 10, "task", kTaskNames, &matrices.task);
  drawing.draw(svg, second, matrices.compared ? "resultant wrench of the grasp" : "no grasp", kWrenchNames,
               matrices.compared ? &matrices.compared->wrench : nullptr);
  draw_scores(svg, scores, matrices);
  return svg.file();
}

}  // namespace preshape
