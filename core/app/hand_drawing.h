#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "preshape/hand/workspace.h"
#include "preshape/io/svg.h"

namespace preshape::app {

/// Drawings of a hand, each one SVG file. Lengths are millimetres, angles degrees, fingers have a colour
/// each.

inline constexpr const char* kInk = "#333333";

/// Names of fingers side by side, each in its colour.
void draw_names(Svg& svg, const HandModel& hand, std::span<const int> fingers, double left, double y);

/// A bar for each joint from its lower to its upper limit, with what it follows.
std::string limits_svg(const HandModel& hand, const std::string& title);

/// Links and fingertips in a posture, seen from the side, from the thumb's side and against the approach
/// axis.
/// @param fingers those that are drawn
/// @param target_H a point that is marked
std::string posture_svg(const HandModel& hand, const Posture& posture, std::span<const int> fingers,
                        const std::string& title, const std::optional<Eigen::Vector3d>& target_H);

/// What fingertips reach, seen from the side and from the thumb's side.
/// @param all one for each of `fingers`
std::string workspace_svg(const HandModel& hand, std::span<const int> fingers,
                          const std::vector<FingerWorkspace>& all, const std::string& title);

}  // namespace preshape::app
