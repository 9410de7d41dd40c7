#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "io/picture_layout.h"
#include "io/picture_parts.h"
#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr int kRim = 8;  ///< [px] around what is drawn in a view

void check(const PictureOptions& options) {
  if (options.width < kSmallestWidth || options.height < kSmallestHeight || options.width > Image::kWidest ||
      options.height > Image::kWidest) {
    throw InputError(fmt::format("a picture of {} x {} pixels cannot be drawn; give {} x {} to {} x {}",
                                 options.width, options.height, kSmallestWidth, kSmallestHeight,
                                 Image::kWidest, Image::kWidest));
  }
  if (!(options.field_of_view >= 0.0 && options.field_of_view < std::numbers::pi / 2)) {
    throw InputError(
        fmt::format("a picture cannot have a field of view of {} rad; give 0 (orthographic) to below pi / 2",
                    options.field_of_view));
  }
}

/// x to the right, y as near to `up` as can be, z to the eye.
Eigen::Matrix3d axes_of(const PictureView& view) {
  Eigen::Matrix3d R;
  const Eigen::Vector3d right = view.direction.normalized().cross(view.up.normalized());
  if (!view.direction.allFinite() || !view.up.allFinite() || !(right.norm() > 1e-6)) {
    throw InputError(fmt::format(
        "a view along ({:g}, {:g}, {:g}) with ({:g}, {:g}, {:g}) upwards cannot be drawn; give two "
        "directions that are not parallel",
        view.direction.x(), view.direction.y(), view.direction.z(), view.up.x(), view.up.y(), view.up.z()));
  }
  R.col(0) = right.normalized();
  R.col(2) = -view.direction.normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  return R;
}

std::vector<Eigen::Vector3d> points_of(const std::vector<PicturePart>& parts) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& part : parts)
    points.insert(points.end(), part.mesh_O.vertices.begin(), part.mesh_O.vertices.end());
  return points;
}

Box box_in(const Eigen::Matrix3d& R_OE, const std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d first = R_OE.transpose() * points.front();
  Box box{first, first};
  for (const auto& p : points) {
    const Eigen::Vector3d q = R_OE.transpose() * p;
    box.lower = box.lower.cwiseMin(q);
    box.upper = box.upper.cwiseMax(q);
  }
  return box;
}

void frame_orthographic(PicturePanel& panel, const std::vector<Eigen::Vector3d>& points) {
  const Box box = box_in(panel.R_OE, points);
  const Eigen::Vector3d extents = box.extents();
  panel.pixel_m =
      std::max({extents.x() / (panel.width - 2 * kRim), extents.y() / (panel.height - 2 * kRim), 1e-9});
  panel.p_OE =
      panel.R_OE * Eigen::Vector3d(box.centre().x(), box.centre().y(), box.upper.z() + 0.1 * extents.norm());
}

/// Everything is in sight from as near as can be, in the middle of its box.
void frame_perspective(PicturePanel& panel, const std::vector<Eigen::Vector3d>& points,
                       double field_of_view) {
  panel.perspective = true;
  const int least = std::min(panel.width, panel.height) - 2 * kRim;
  panel.pixel_m = 2.0 * std::tan(0.5 * field_of_view) / least;
  const Box box = box_in(panel.R_OE, points);
  const Eigen::Vector3d middle = box.centre();
  double away = box.upper.z() + 1e-3 * box.extents().norm();
  for (const auto& p : points) {
    const Eigen::Vector3d q = panel.R_OE.transpose() * p - Eigen::Vector3d(middle.x(), middle.y(), 0.0);
    away = std::max({away, q.z() + std::abs(q.x()) / (panel.pixel_m * (0.5 * panel.width - kRim)),
                     q.z() + std::abs(q.y()) / (panel.pixel_m * (0.5 * panel.height - kRim))});
  }
  panel.p_OE = panel.R_OE * Eigen::Vector3d(middle.x(), middle.y(), away);
}

}  // namespace

PictureView picture_view(const Eigen::Vector3d& direction) {
  if (!direction.allFinite() || !(direction.norm() > 1e-9)) {
    throw InputError(
        fmt::format("a view along ({:g}, {:g}, {:g}) cannot be drawn; give a direction that is not zero",
                    direction.x(), direction.y(), direction.z()));
  }
  const Eigen::Vector3d d = direction.normalized();
  return {fmt::format("seen along ({:g}, {:g}, {:g})", direction.x(), direction.y(), direction.z()), d,
          std::abs(d.z()) < 0.99 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY()};
}

std::vector<PictureView> grasp_views(const GraspScene& scene) {
  const Eigen::Vector3d a = scene.approach_O, n = scene.opposition_O, t = n.cross(a);
  return {{"along the approach axis", a, t},
          {"along the opposition axis", n, -a},
          {"oblique", 0.75 * a + 0.45 * n - 0.8 * t, -a}};
}

std::vector<PicturePanel> picture_panels(const GraspScene& scene, const PictureOptions& options) {
  check(options);
  const auto points = points_of(picture_parts(scene, options));
  if (points.empty()) throw InputError("a picture cannot be drawn: the object has no triangles");
  const auto views = options.views.empty() ? grasp_views(scene) : options.views;
  const PictureLayout layout = layout_of(scene, options);
  const int count = static_cast<int>(views.size());
  std::vector<PicturePanel> panels;
  double pixel_m = 0.0;
  for (int i = 0; i < count; ++i) {
    PicturePanel panel;
    panel.view = views[static_cast<std::size_t>(i)];
    panel.left = i * options.width / count;
    panel.width = (i + 1) * options.width / count - panel.left;
    panel.top = layout.views_top;
    panel.height = layout.views_bottom - layout.views_top;
    if (panel.width < 4 * kRim || panel.height < 4 * kRim) {
      throw InputError(
          fmt::format("a picture of {} x {} pixels has no room for {} views and their words; make it larger",
                      options.width, options.height, count));
    }
    panel.R_OE = axes_of(panel.view);
    if (options.field_of_view > 0.0)
      frame_perspective(panel, points, options.field_of_view);
    else
      frame_orthographic(panel, points);
    pixel_m = std::max(pixel_m, panel.pixel_m);
    panels.push_back(panel);
  }
  if (options.field_of_view == 0.0) {
    for (auto& panel : panels) panel.pixel_m = pixel_m;
  }
  return panels;
}

Eigen::Vector2d PicturePanel::pixel(const Eigen::Vector3d& p_O) const {
  const Eigen::Vector3d q = R_OE.transpose() * (p_O - p_OE);
  const double size = perspective ? -q.z() * pixel_m : pixel_m;
  return {left + 0.5 * width + q.x() / size, top + 0.5 * height - q.y() / size};
}

Ray PicturePanel::ray(const Eigen::Vector2d& pixel) const {
  const double x = (pixel.x() - left - 0.5 * width) * pixel_m,
               y = -(pixel.y() - top - 0.5 * height) * pixel_m;
  if (perspective) return {p_OE, (R_OE * Eigen::Vector3d(x, y, -1.0)).normalized()};
  return {p_OE + R_OE * Eigen::Vector3d(x, y, 0.0), -R_OE.col(2)};
}

}  // namespace preshape
