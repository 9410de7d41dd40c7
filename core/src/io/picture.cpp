#include "preshape/io/picture.h"

#include "io/picture_layout.h"
#include "io/picture_parts.h"
#include "io/ray_painter.h"

namespace preshape {

Image picture(const GraspScene& scene, const CollisionBackend& collision, const PictureOptions& options) {
  const auto panels = picture_panels(scene, options);
  const PictureLayout layout = layout_of(scene, options);
  const RayPainter painter(picture_parts(scene, options), collision);
  Image image(options.width, options.height, picture_ink(PictureInk::kBackground));
  for (const PicturePanel& panel : panels) {
    painter.paint(panel, image);
    if (options.words) draw_caption(image, layout, panel);
  }
  draw_words(image, layout);
  return image;
}

}  // namespace preshape
