#include "hand_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "preshape/geometry/solid_mesh.h"

namespace preshape::app {

namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr const char* kPalmColour = "#6f7680";
constexpr const char* kTargetColour = "#c41830";

/// How a view looks at H: which of its axes go to the right and upwards, and which way is towards the eye.
struct View {
  int across, up;
  Eigen::Vector3d to_eye;
  const char* words;

  Eigen::Vector2d operator()(const Eigen::Vector3d& p_H) const { return {p_H[across], p_H[up]}; }
};
const std::array<View, 3> kViews = {
    View{1, 2, Eigen::Vector3d::UnitX(), "from the side: Y (opposition) across, Z (approach) up"},
    View{0, 2, -Eigen::Vector3d::UnitY(), "from the thumb's side: X across, Z (approach) up"},
    View{0, 1, Eigen::Vector3d::UnitZ(), "against the approach: X across, Y (opposition) up"}};

const std::string& name_of(const HandModel& hand, int finger) {
  return hand.fingers()[static_cast<std::size_t>(finger)].name;
}

/// The outline of what is convex: the hull of its corners, by Andrew's monotone chains.
Points hull_of(Points points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  Points hull;
  const auto add = [&hull](const Eigen::Vector2d& p, std::size_t fixed) {
    const auto turns_left = [&] {
      const Eigen::Vector2d a = hull.back() - hull[hull.size() - 2], b = p - hull.back();
      return a.x() * b.y() - a.y() * b.x() > 0.0;
    };
    while (hull.size() > fixed && !turns_left()) hull.pop_back();
    hull.push_back(p);
  };
  for (const auto& p : points) add(p, 1);
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  return hull;
}

/// What a view shows: a solid's outline, with how near it is to the eye.
struct Outline {
  int finger = -1;
  TriangleMesh mesh_H;
  Eigen::Vector3d middle_H;
};

/// A hand in one posture: outlines of its links and the ways from joint to joint.
struct Drawn {
  std::vector<Outline> outlines;
  std::vector<std::vector<Pose>> chains;  ///< one a finger that is drawn

  Drawn(const HandModel& hand, const Posture& posture, std::span<const int> fingers) {
    for (const int finger : fingers) chains.push_back(finger_poses(hand, finger, posture));
    for (const LinkSolid& solid : hand.solids()) {
      const auto shown = std::find(fingers.begin(), fingers.end(), solid.finger);
      if (solid.finger >= 0 && shown == fingers.end()) continue;
      Pose X_HS = solid.X_LS;
      if (solid.finger >= 0) {
        const auto& chain = chains[static_cast<std::size_t>(shown - fingers.begin())];
        X_HS = chain[static_cast<std::size_t>(solid.link)] * X_HS;
      }
      outlines.push_back({solid.finger, transformed(solid_mesh(solid.solid, 24), X_HS), X_HS.p});
    }
  }

  Box box(const std::optional<Eigen::Vector3d>& target) const {
    Box box{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const auto take = [&box](const Eigen::Vector3d& p) {
      box.lower = box.lower.cwiseMin(p), box.upper = box.upper.cwiseMax(p);
    };
    for (const auto& outline : outlines)
      std::for_each(outline.mesh_H.vertices.begin(), outline.mesh_H.vertices.end(), take);
    for (const auto& chain : chains) {
      for (const Pose& X : chain) take(X.p);
    }
    if (target) take(*target);
    return box;
  }
};

Points ring(const Eigen::Vector2d& middle, double radius) {
  Points points;
  for (int i = 0; i <= 16; ++i) {
    const double angle = i * std::numbers::pi / 8;
    points.emplace_back(middle + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// One view of a hand: where H lies in the drawing, and its scale.
struct Panel {
  const View& view;
  Eigen::Vector2d origin;  ///< of H [px]
  double pixels = 1.0;     ///< a metre

  Eigen::Vector2d at(const Eigen::Vector3d& p_H) const {
    const Eigen::Vector2d p = pixels * view(p_H);
    return origin + Eigen::Vector2d(p.x(), -p.y());
  }

  void draw_outlines(Svg& svg, const HandModel& hand, std::vector<Outline> outlines) const {
    std::stable_sort(outlines.begin(), outlines.end(), [&](const Outline& a, const Outline& b) {
      return a.middle_H.dot(view.to_eye) < b.middle_H.dot(view.to_eye);
    });
    for (const Outline& outline : outlines) {
      Points points;
      for (const auto& p : outline.mesh_H.vertices) points.push_back(at(p));
      const std::string colour(outline.finger < 0 ? kPalmColour : svg_colour(outline.finger));
      points = hull_of(std::move(points));
      svg.path(points, {.stroke = colour, .fill = colour, .width = 0.8, .opacity = 0.28},
               outline.finger < 0 ? "palm" : name_of(hand, outline.finger));
    }
  }

  void draw_chain(Svg& svg, const std::vector<Pose>& chain, const std::string& name,
                  std::string_view colour) const {
    Points way;
    for (const Pose& X : chain) way.push_back(at(X.p));
    svg.path(way, {.stroke = std::string(colour), .width = 2.0}, name);
    for (std::size_t k = 1; k + 1 < way.size(); ++k)
      svg.path(ring(way[k], 2.5), {.stroke = std::string(colour), .fill = "#ffffff", .width = 1.5},
               fmt::format("{} link {}", name, k));
    svg.path(ring(way.back(), 4.0), {.fill = std::string(colour)}, name + " tip");
  }

  void draw_target(Svg& svg, const Eigen::Vector3d& target_H) const {
    const Eigen::Vector2d p = at(target_H);
    svg.path(ring(p, 8.0), {.stroke = kTargetColour, .width = 1.5}, "asked for");
    svg.line(p.x() - 12, p.y(), p.x() + 12, p.y(), {.stroke = kTargetColour});
    svg.line(p.x(), p.y() - 12, p.x(), p.y() + 12, {.stroke = kTargetColour});
  }
};

}  // namespace

void draw_names(Svg& svg, const HandModel& hand, std::span<const int> fingers, double left, double y) {
  for (const int finger : fingers) {
    svg.text(left, y, name_of(hand, finger), SvgAnchor::kStart, 13, svg_colour(finger));
    left += 30.0 + 8.0 * static_cast<double>(name_of(hand, finger).size());
  }
}

std::string posture_svg(const HandModel& hand, const Posture& posture, std::span<const int> fingers,
                        const std::string& title, const std::optional<Eigen::Vector3d>& target_H) {
  constexpr double kPanel = 380, kMargin = 30, kHead = 60, kFoot = 40;
  const Drawn drawn(hand, posture, fingers);
  const Box box = drawn.box(target_H);
  const double pixels = (kPanel - 2 * kMargin) / std::max(1e-3, box.extents().maxCoeff());
  Svg svg(3 * kPanel, kHead + kPanel + kFoot, title);
  svg.text(kMargin, 24, title, SvgAnchor::kStart, 15, kInk);
  draw_names(svg, hand, fingers, kMargin, 46);
  for (std::size_t v = 0; v < kViews.size(); ++v) {
    const View& view = kViews[v];
    const Eigen::Vector2d middle(kPanel * (static_cast<double>(v) + 0.5), kHead + 0.5 * kPanel),
        m = pixels * view(box.centre());
    const Panel panel{view, middle + Eigen::Vector2d(-m.x(), m.y()), pixels};
    const double left = kPanel * static_cast<double>(v) + kMargin, right = left + kPanel - 2 * kMargin;
    svg.line(left, panel.origin.y(), right, panel.origin.y(), {.stroke = "#999999", .dash = "4 3"});
    svg.line(panel.origin.x(), kHead + kMargin, panel.origin.x(), kHead + kPanel - kMargin,
             {.stroke = "#999999", .dash = "4 3"});
    panel.draw_outlines(svg, hand, drawn.outlines);
    for (std::size_t i = 0; i < fingers.size(); ++i)
      panel.draw_chain(svg, drawn.chains[i], name_of(hand, fingers[i]), svg_colour(fingers[i]));
    if (target_H) panel.draw_target(svg, *target_H);
    svg.text(left, kHead + kPanel + 8, view.words, SvgAnchor::kStart, 12, kInk);
  }
  const double bar = 0.05 * pixels;
  svg.line(kMargin, kHead + kPanel + 28, kMargin + bar, kHead + kPanel + 28, {.stroke = kInk, .width = 2});
  svg.text(kMargin + bar + 8, kHead + kPanel + 32, "50 mm", SvgAnchor::kStart, 12, kInk);
  if (drawn.outlines.empty()) {
    svg.text(3 * kPanel - kMargin, kHead + kPanel + 32,
             "the description has no geometry of links: joints and tips alone", SvgAnchor::kEnd, 12, kInk);
  }
  return svg.file();
}

std::string workspace_svg(const HandModel& hand, std::span<const int> fingers,
                          const std::vector<FingerWorkspace>& all, const std::string& title) {
  constexpr double kWidth = 860, kHeight = 480, kMargin = 50, kHead = 66;
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
  for (const auto& workspace : all)
    low = low.cwiseMin(workspace.box_H.lower), high = high.cwiseMax(workspace.box_H.upper);
  const double span = std::max(1e-3, (high - low).maxCoeff());
  const double pixels = (kHeight - kHead - kMargin) / span;
  Svg svg(kWidth, kHeight, title);
  svg.text(kMargin, 24, title, SvgAnchor::kStart, 15, kInk);
  for (std::size_t v = 0; v < 2; ++v) {
    const double left = kMargin + static_cast<double>(v) * (kWidth / 2);
    const Panel panel{
        kViews[v], {left - kViews[v](low).x() * pixels, kHeight - kMargin + low.z() * pixels}, pixels};
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::set<std::pair<long, long>> seen;
      const double edge = all[i].cell_m;
      for (const auto& p_H : all[i].cells_H) {
        const Eigen::Vector2d p = panel.view(p_H);
        if (!seen.insert({std::lround(p.x() / edge), std::lround(p.y() / edge)}).second) continue;
        const Eigen::Vector2d corner = panel.at(p_H) - Eigen::Vector2d::Constant(0.5 * edge * pixels);
        svg.rectangle(corner.x(), corner.y(), edge * pixels, edge * pixels,
                      {.fill = std::string(svg_colour(fingers[i])), .opacity = 0.3});
      }
    }
    const Eigen::Vector2d from = panel.at(low), to = panel.at(high);
    svg.line(from.x(), panel.origin.y(), to.x(), panel.origin.y(), {.stroke = "#888888", .dash = "4 3"});
    svg.line(panel.origin.x(), from.y(), panel.origin.x(), to.y(), {.stroke = "#888888", .dash = "4 3"});
    svg.text(left, kHeight - 14, panel.view.words, SvgAnchor::kStart, 12, kInk);
  }
  draw_names(svg, hand, fingers, kMargin, 46);
  const double bar = 0.05 * pixels, right = kWidth - kMargin;
  svg.line(right - bar, kHeight - 18, right, kHeight - 18, {.stroke = kInk, .width = 2});
  svg.text(right - bar - 8, kHeight - 14, "50 mm", SvgAnchor::kEnd, 12, kInk);
  return svg.file();
}

}  // namespace preshape::app
