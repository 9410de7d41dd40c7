#include "preshape/io/heat_map_svg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/io/svg.h"

namespace preshape {

namespace {

constexpr double kTop = 46, kBelow = 56, kBar = 110, kText = 12, kMostWide = 760, kMostHigh = 900;  // [px]
constexpr const char* kInk = "#222222";
constexpr const char* kNone = "#e6e6e6";
constexpr const char* kHatch = "#a8a8a8";
constexpr const char* kFrame = "#d62728";

/// Where the cells are, and what their colours mean.
struct Grid {
  const HeatMap& map;
  double left, cell_width, cell_height;
  double far = 0.0, near = 1.0;  ///< scores of the darkest and the lightest colour
  std::size_t best;              ///< index of a cell; cells.size() when there is no grasp

  explicit Grid(const HeatMap& heat) : map(heat), best(heat.cells.size()) {
    std::size_t longest = 0;
    for (const auto& plane : map.planes) longest = std::max(longest, plane.size());
    left = 46 + 0.56 * kText * static_cast<double>(longest);
    cell_width =
        std::clamp(kMostWide / static_cast<double>(std::max<std::size_t>(1, map.stations.size())), 4.0, 84.0);
    cell_height =
        std::clamp(kMostHigh / static_cast<double>(std::max<std::size_t>(1, map.planes.size())), 3.0, 28.0);
    bool any = false;
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
      if (!map.cells[i].score) continue;
      const double score = *map.cells[i].score;
      if (!any || map.scale.nearer(score, near)) near = score, best = i;
      if (!any || map.scale.nearer(far, score)) far = score;
      any = true;
    }
  }
  double width() const { return cell_width * static_cast<double>(map.stations.size()); }
  double height() const { return cell_height * static_cast<double>(map.planes.size()); }
  double x(std::size_t station) const { return left + cell_width * static_cast<double>(station); }
  double y(std::size_t plane) const { return kTop + cell_height * static_cast<double>(plane); }
  double share(double score) const { return near == far ? 1.0 : (score - far) / (near - far); }
};

void draw_cell(Svg& svg, const Grid& grid, std::size_t plane, std::size_t station) {
  const HeatMap& map = grid.map;
  const auto& cell = map.at(plane, station);
  const double x = grid.x(station), y = grid.y(plane), width = grid.cell_width, height = grid.cell_height;
  const std::string where = fmt::format("plane {}, x = {:.6g}: ", map.planes[plane], map.stations[station]);
  if (!cell.score) {
    svg.rectangle(x, y, width, height, {.fill = kNone},
                  where + "no grasp" + (cell.detail.empty() ? "" : ", " + cell.detail));
    svg.hatch(x, y, width, height, 7, {.stroke = kHatch, .width = 0.7});
    return;
  }
  const double share = grid.share(*cell.score);
  constexpr double kOver = 0.4;  // onto the next cells, so that no seam shines through
  svg.rectangle(x, y, width + kOver, height + kOver, {.fill = svg_scale_colour(share)},
                where + fmt::format("{} {:.6g}", map.measure, *cell.score));
  if (width < 3.4 * kText || height < 1.3 * kText) return;
  svg.text(x + width / 2, y + height / 2 + 4, fmt::format("{:.2f}", *cell.score), SvgAnchor::kMiddle,
           kText - 1, share > 0.55 ? "#111111" : "#ffffff");
}

void draw_axes(Svg& svg, const Grid& grid) {
  const auto every = [](double cell, double room) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(room / cell)));
  };
  const std::size_t rows = every(grid.cell_height, 1.15 * kText), columns = every(grid.cell_width, 42);
  for (std::size_t p = 0; p < grid.map.planes.size(); p += rows) {
    svg.text(grid.left - 8, grid.y(p) + grid.cell_height / 2 + 4, grid.map.planes[p], SvgAnchor::kEnd, kText,
             kInk);
  }
  for (std::size_t s = 0; s < grid.map.stations.size(); s += columns) {
    svg.text(grid.x(s) + grid.cell_width / 2, grid.y(grid.map.planes.size()) + 17,
             fmt::format("{:.4g}", grid.map.stations[s]), SvgAnchor::kMiddle, kText, kInk);
  }
  svg.text(grid.left + grid.width() / 2, grid.y(grid.map.planes.size()) + 40,
           "station: approach value x over the half extent", SvgAnchor::kMiddle, kText, kInk);
  svg.text(16, kTop + grid.height() / 2, "plane", SvgAnchor::kMiddle, kText, kInk, true);
}

/// The scale of colours, near on top, and what hatching means.
void draw_bar(Svg& svg, const Grid& grid, double left, double height) {
  constexpr int kSteps = 48;
  const double step = height / kSteps;
  const bool any = grid.best < grid.map.cells.size();
  svg.text(left, kTop - 8, grid.map.measure, SvgAnchor::kStart, kText, kInk);
  for (int i = 0; any && i < kSteps; ++i) {
    const double end = kTop + std::min(height, (i + 2) * step);  // below the next one: no seams
    svg.path({{left, kTop + i * step}, {left + 16, kTop + i * step}, {left + 16, end}, {left, end}},
             {.fill = svg_scale_colour(1.0 - (i + 0.5) / kSteps)}, "");
  }
  for (const double share : {1.0, 0.5, 0.0}) {
    if (any)
      svg.text(
          left + 22, kTop + (1.0 - share) * height + 4,
          fmt::format("{:.2f}{}", grid.far + share * (grid.near - grid.far), share == 1.0 ? " nearest" : ""),
          SvgAnchor::kStart, kText, kInk);
  }
  const double y = kTop + height + 18;
  svg.path({{left, y}, {left + 16, y}, {left + 16, y + 14}, {left, y + 14}}, {.fill = kNone}, "no grasp");
  svg.hatch(left, y, 16, 14, 7, {.stroke = kHatch, .width = 0.7});
  svg.text(left + 22, y + 11, "no grasp", SvgAnchor::kStart, kText, kInk);
}

}  // namespace

std::string heat_map_svg(const HeatMap& map) {
  if (map.cells.size() != map.planes.size() * map.stations.size()) {
    throw InputError(fmt::format("a heat map of {} planes and {} stations has {} cells; give one a station",
                                 map.planes.size(), map.stations.size(), map.cells.size()));
  }
  const Grid grid(map);
  const double bar = std::clamp(grid.height() - 40, 60.0, 260.0);
  const double width =
      std::max(grid.left + grid.width() + 24 + kBar, 20 + 8.2 * static_cast<double>(map.title.size()));
  Svg svg(width, kTop + std::max(grid.height() + kBelow, bar + 44), map.title);
  svg.text(16, 24, map.title, SvgAnchor::kStart, 15, kInk);
  for (std::size_t p = 0; p < map.planes.size(); ++p) {
    for (std::size_t s = 0; s < map.stations.size(); ++s) draw_cell(svg, grid, p, s);
  }
  if (grid.best < map.cells.size()) {
    const double x = grid.x(grid.best % map.stations.size()), y = grid.y(grid.best / map.stations.size());
    svg.path({{x, y},
              {x + grid.cell_width, y},
              {x + grid.cell_width, y + grid.cell_height},
              {x, y + grid.cell_height},
              {x, y}},
             {.stroke = kFrame, .width = 3}, "nearest");
  }
  draw_axes(svg, grid);
  draw_bar(svg, grid, grid.left + grid.width() + 24, bar);
  return svg.file();
}

}  // namespace preshape
