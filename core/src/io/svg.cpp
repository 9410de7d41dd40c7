#include "preshape/io/svg.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace preshape {

namespace {

/// Text of XML: the marks of its grammar escaped, control characters left out.
std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    switch (c) {
      case '&': text += "&amp;"; break;
      case '<': text += "&lt;"; break;
      case '>': text += "&gt;"; break;
      case '"': text += "&quot;"; break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) text += c;
    }
  }
  return text;
}

/// Hundredths of a pixel are enough.
std::string number(double x) {
  std::string text = fmt::format("{:.2f}", x);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string attributes(const SvgStyle& style) {
  std::string text = fmt::format("fill=\"{}\"", escaped(style.fill));
  if (style.stroke != "none") {
    text += fmt::format(" stroke=\"{}\" stroke-width=\"{}\"", escaped(style.stroke), number(style.width));
    if (!style.dash.empty()) text += fmt::format(" stroke-dasharray=\"{}\"", escaped(style.dash));
  }
  if (style.opacity != 1.0) text += fmt::format(" opacity=\"{}\"", number(style.opacity));
  return text;
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                        "role=\"img\" font-family=\"sans-serif\">\n<title>{2}</title>\n",
                        number(width), number(height), escaped(title))) {
  rectangle(0, 0, width, height, {.fill = "#ffffff"});
}

void Svg::rectangle(double x, double y, double width, double height, const SvgStyle& style, std::string_view name) {
  text_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}", number(x), number(y), number(width),
                       number(height), attributes(style));
  text_ += name.empty() ? "/>\n" : fmt::format("><title>{}</title></rect>\n", escaped(name));
}

void Svg::hatch(double x, double y, double width, double height, double step, const SvgStyle& style) {
  std::string course;
  for (double d = step / 2; d < width + height; d += step) {  // lines on which across + up is d
    const double right = std::min(d, width), left = std::max(0.0, d - height);
    course += fmt::format("{}M{} {} L{} {}", course.empty() ? "" : " ", number(x + left), number(y + height - (d - left)),
                          number(x + right), number(y + height - (d - right)));
  }
  text_ += fmt::format("<path d=\"{}\" {}/>\n", course, attributes(style));
}

void Svg::line(double x1, double y1, double x2, double y2, const SvgStyle& style) {
  text_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(x1), number(y1), number(x2), number(y2),
                       attributes(style));
}

void Svg::path(const std::vector<Eigen::Vector2d>& points, const SvgStyle& style, std::string_view name) {
  std::string course;
  for (const auto& p : points) course += fmt::format("{}{} {}", course.empty() ? "M" : " L", number(p.x()), number(p.y()));
  text_ += fmt::format("<path d=\"{}\" {} stroke-linejoin=\"round\"><title>{}</title></path>\n", course, attributes(style),
                       escaped(name));
}

void Svg::text(double x, double y, std::string_view words, SvgAnchor anchor, double size, std::string_view colour, bool turned) {
  const char* where = anchor == SvgAnchor::kStart ? "start" : anchor == SvgAnchor::kMiddle ? "middle" : "end";
  const std::string turn = turned ? fmt::format(" transform=\"rotate(-90 {} {})\"", number(x), number(y)) : "";
  text_ += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n", number(x),
                       number(y), where, number(size), escaped(colour), turn, escaped(words));
}

std::string Svg::file() const { return text_ + "</svg>\n"; }

std::string_view svg_colour(int i) {
  static constexpr std::string_view kColours[] = {"#1f5f99", "#b84a00", "#00795a", "#9c4380",
                                                  "#7a5c00", "#3b3b3b", "#a3262a", "#4a4fb0"};
  return kColours[static_cast<std::size_t>(i) % std::size(kColours)];
}

std::string svg_scale_colour(double share) {
  static constexpr int kAnchors[][3] = {{0, 32, 77},     {0, 51, 111},    {57, 72, 107},   {87, 92, 109},  {112, 113, 115},
                                        {138, 135, 121}, {166, 157, 117}, {196, 181, 108}, {228, 207, 91}, {255, 234, 70}};
  const double at = std::clamp(share, 0.0, 1.0) * (std::size(kAnchors) - 1);
  const auto below = std::min(static_cast<std::size_t>(at), std::size(kAnchors) - 2);
  const auto channel = [&](int c) {
    return static_cast<int>(std::lround(kAnchors[below][c] + (at - static_cast<double>(below)) * (kAnchors[below + 1][c] - kAnchors[below][c])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

std::vector<double> SvgScale::ticks(int count) const {
  const double rough = (to - from) / std::max(1, count - 1), power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double round : {1.0, 2.0, 2.5, 5.0}) {
    if (round * power >= rough * (1 - 1e-9)) {
      step = round * power;
      break;
    }
  }
  std::vector<double> ticks;
  const double first = std::ceil(from / step - 1e-9);
  for (int i = 0; i < count && (first + i) * step <= to + 1e-9 * step; ++i) {
    const double tick = (first + i) * step + 0.0;  // no negative zero
    if (ticks.empty() || tick > ticks.back()) ticks.push_back(tick);  // else rounding has no finer numbers there
  }
  return ticks;
}

}  // namespace preshape
