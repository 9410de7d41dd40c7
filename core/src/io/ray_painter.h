#pragma once

#include <memory>
#include <vector>

#include "io/picture_parts.h"

namespace preshape {

/// Paints the parts of a picture into its panels by casting rays; the first part is the one that hides
/// others.
class RayPainter {
 public:
  RayPainter(std::vector<PicturePart> parts, const CollisionBackend& collision);
  ~RayPainter();

  /// One ray a pixel, and four more where its colour differs from a neighbour's. Rows are painted by several
  /// threads.
  void paint(const PicturePanel& panel, Image& image) const;

 private:
  struct Caster;
  using Colours = std::vector<Eigen::Vector3f>;
  struct Canvas;
  Colours colours(const Canvas& canvas, const std::vector<Eigen::Vector2d>& pixels) const;
  void paint_middles(Canvas& canvas, int y) const;
  void paint_row(Canvas& canvas, int y, Image& image) const;

  std::vector<Caster> casters_;
};

}  // namespace preshape
