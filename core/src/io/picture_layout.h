#pragma once

#include <string>
#include <vector>

#include "preshape/io/picture.h"

namespace preshape {

/// Where the words of a picture stand, and what they leave to the views.
struct PictureLayout {
  struct Entry {
    PictureInk ink;
    std::string name;
    int x = 0, y = 0;  ///< upper left corner of its patch of colour [px]
  };
  int scale = 1;  ///< of letters
  std::vector<std::string> title, verdict;
  std::vector<Entry> legend;
  int views_top = 0, views_bottom = 0;  ///< rows of the views [px]; their names stand below

  int line() const { return 12 * scale; }  ///< from a line of text to the next [px]
  static constexpr int kMargin = 10;
};

/// Letters are twice as large where the picture is wide enough for them.
PictureLayout layout_of(const GraspScene& scene, const PictureOptions& options);

/// Title, verdict and legend.
void draw_words(Image& image, const PictureLayout& layout);
/// The view's name under it, and a scale of a round length where it is orthographic.
void draw_caption(Image& image, const PictureLayout& layout, const PicturePanel& panel);

}  // namespace preshape
