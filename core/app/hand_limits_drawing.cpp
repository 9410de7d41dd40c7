#include <algorithm>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "hand_drawing.h"

namespace preshape::app {

namespace {

/// The joints' bars stand below each other, between their names and what is told of them.
struct Bars {
  static constexpr double kRow = 20, kWidth = 430, kTop = 66, kLetter = 7;
  const HandModel& hand;
  double left = 0.0, right = 0.0;  ///< of the bars [px]
  double words = 0.0;              ///< room for what is told of a joint [px]
  SvgScale scales[2] = {};         ///< degrees; mm of joints that slide
  bool any[2] = {};

  explicit Bars(const HandModel& of) : hand(of) {
    std::size_t name = 0, said = 0;
    for (const Joint& joint : hand.joints()) {
      name = std::max(name, joint.name.size()), said = std::max(said, told(joint).size());
      SvgScale& scale = scales[joint.prismatic];
      if (!any[joint.prismatic]) scale.from = scale.to = 0.0;
      any[joint.prismatic] = true;
      scale.from = std::min(scale.from, unit(joint) * joint.lower),
      scale.to = std::max(scale.to, unit(joint) * joint.upper);
    }
    left = 34 + kLetter * static_cast<double>(name), right = left + kWidth,
    words = 28 + kLetter * static_cast<double>(said);
    for (SvgScale& scale : scales) {
      if (scale.to <= scale.from) scale.to = scale.from + 1.0;
      scale.at_from = left, scale.at_to = right;
    }
  }

  static double unit(const Joint& joint) { return joint.prismatic ? 1e3 : 180.0 / std::numbers::pi; }

  std::string told(const Joint& joint) const {
    std::string text = fmt::format("{:.4g} .. {:.4g} {}", joint.lower * unit(joint),
                                   joint.upper * unit(joint), joint.prismatic ? "mm" : "deg");
    if (joint.leader < 0) return text;
    return text + fmt::format(", {:.4g} x {}", joint.ratio,
                              hand.joints()[static_cast<std::size_t>(joint.leader)].name);
  }

  void draw(Svg& svg, int finger, const Joint& joint, double y) const {
    const SvgScale& scale = scales[joint.prismatic];
    const double from = scale(joint.lower * unit(joint)), to = scale(joint.upper * unit(joint));
    const std::string colour(svg_colour(finger));
    svg.text(left - 14, y + 12, joint.name, SvgAnchor::kEnd, 12, kInk);
    svg.rectangle(from, y + 3, std::max(1.0, to - from), kRow - 8,
                  {.stroke = colour, .fill = joint.leader < 0 ? colour : "none", .opacity = 0.75},
                  joint.name);
    svg.text(right + 14, y + 12, told(joint), SvgAnchor::kStart, 12, kInk);
  }

  /// Numbers below the bars, a row for each unit.
  void draw_ticks(Svg& svg, bool prismatic, double y, double bottom) const {
    const SvgScale& scale = scales[prismatic];
    for (const double tick : scale.ticks(9)) {
      svg.line(scale(tick), kTop, scale(tick), bottom, {.stroke = tick == 0.0 ? "#999999" : "#e4e4e4"});
      svg.text(scale(tick), y, fmt::format("{:.6g}", tick), SvgAnchor::kMiddle, 11, kInk);
    }
    svg.text(right + 14, y, prismatic ? "mm" : "deg", SvgAnchor::kStart, 11, kInk);
  }
};

}  // namespace

std::string limits_svg(const HandModel& hand, const std::string& title) {
  const Bars bars(hand);
  const double bottom = Bars::kTop + Bars::kRow * static_cast<double>(hand.joints().size()) + 4;
  Svg svg(bars.right + bars.words, bottom + (bars.any[0] && bars.any[1] ? 44 : 26), title);
  svg.text(14, 24, title, SvgAnchor::kStart, 15, kInk);
  std::vector<int> fingers(hand.fingers().size());
  std::iota(fingers.begin(), fingers.end(), 0);
  draw_names(svg, hand, fingers, 14, 46);
  if (bars.any[1]) bars.draw_ticks(svg, true, bottom + (bars.any[0] ? 34 : 16), bottom);
  if (bars.any[0]) bars.draw_ticks(svg, false, bottom + 16, bottom);
  double y = Bars::kTop;
  for (const int finger : fingers) {
    const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
    for (int j = about.first_joint; j < about.first_joint + about.joint_count; ++j, y += Bars::kRow)
      bars.draw(svg, finger, hand.joints()[static_cast<std::size_t>(j)], y);
  }
  return svg.file();
}

}  // namespace preshape::app
