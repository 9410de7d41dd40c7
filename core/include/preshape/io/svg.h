#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "preshape/base/export.h"

namespace preshape {

/// How a line or an area of a drawing looks; colours as in CSS.
struct SvgStyle {
  std::string stroke = "none", fill = "none";
  double width = 1.0;   ///< of the stroke [px]
  std::string dash = "";  ///< such as "4 3"; solid when empty
  double opacity = 1.0;
};

/// Where a text stands to its place.
enum class SvgAnchor { kStart, kMiddle, kEnd };

/// A drawing in pixels, x to the right and y down, on a light background, in one file without references to others.
class PRESHAPE_API Svg {
 public:
  /// @param title told by viewers and to those who cannot see it
  Svg(double width, double height, std::string_view title);

  /// `name` is told when it is pointed at.
  void rectangle(double x, double y, double width, double height, const SvgStyle& style, std::string_view name = "");
  /// Slanted lines across a rectangle, `step` px apart.
  void hatch(double x, double y, double width, double height, double step, const SvgStyle& style);
  void line(double x1, double y1, double x2, double y2, const SvgStyle& style);
  /// A path through points; `name` is told when it is pointed at.
  void path(const std::vector<Eigen::Vector2d>& points, const SvgStyle& style, std::string_view name);
  /// @param turned by a quarter, to be read from below upwards
  void text(double x, double y, std::string_view words, SvgAnchor anchor, double size, std::string_view colour,
            bool turned = false);

  /// The whole file. Any text may hold any characters; those that XML does not allow are left out.
  std::string file() const;

 private:
  std::string text_;
};

/// A colour that tells the i-th of several things from the others on a light background, also for the colour-blind; they
/// come again after eight.
PRESHAPE_API std::string_view svg_colour(int i);

/// A colour of a scale from dark blue (0) to light yellow (1) whose lightness ascends evenly, so that it is read in grey and by
/// the colour-blind as well: cividis [NunezAndertonRenslow2018].
PRESHAPE_API std::string svg_scale_colour(double share);

/// A scale of a drawing: numbers along it, and where they are.
struct PRESHAPE_API SvgScale {
  double from = 0.0, to = 1.0;        ///< numbers
  double at_from = 0.0, at_to = 1.0;  ///< [px]

  double operator()(double number) const { return at_from + (number - from) / (to - from) * (at_to - at_from); }
  /// Round numbers on it, `count` at most.
  std::vector<double> ticks(int count) const;
};

}  // namespace preshape
