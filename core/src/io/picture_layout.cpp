#include "io/picture_layout.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/bitmap_font.h"
#include "io/scene_marks.h"

namespace preshape {

namespace {

constexpr Rgb kInk = {34, 34, 38}, kFaint = {96, 96, 100};
constexpr int kWide = 900;  ///< [px] from here on letters are twice as large

bool any_moment(const GraspScene& scene) {
  return std::any_of(scene.F_C_O.begin(), scene.F_C_O.end(),
                     [](const Wrench& w) { return w.moment().norm() > 0.0; });
}

std::vector<PictureLayout::Entry> entries_of(const GraspScene& scene, const PictureOptions& options) {
  std::vector<PictureLayout::Entry> entries = {{PictureInk::kObject, "object"}};
  if (!scene.links.empty() && options.hand_opacity > 0.0) {
    entries.push_back({PictureInk::kHand, options.frame == 0 && scene.frames > 1 ? "open hand" : "hand"});
    const std::string colliding = colliding_links(scene);
    if (!colliding.empty()) entries.push_back({PictureInk::kCollision, "collides: " + colliding});
  }
  if (!options.marks || scene.contacts.empty()) return entries;
  entries.push_back({PictureInk::kContact, "contact"});
  entries.push_back({PictureInk::kNormal, "inward normal"});
  entries.push_back({PictureInk::kForce, "contact force"});
  if (any_moment(scene)) entries.push_back({PictureInk::kMoment, "contact moment"});
  entries.push_back({PictureInk::kAxis, "opposition axis"});
  entries.push_back({PictureInk::kResultant, "resultant force at O"});
  entries.push_back({PictureInk::kResultantMoment, "resultant moment"});
  entries.push_back({PictureInk::kPlane, "approach plane"});
  if (scene.approach_volume) {
    entries.push_back({PictureInk::kVolume, "approach volume"});
    entries.push_back({PictureInk::kEntrance, "entrance"});
  }
  return entries;
}

/// Sets the legend in rows from the bottom; returns how high it is.
int place_legend(PictureLayout& layout, int width, int height) {
  const int patch = layout.line() + 4, gap = 2 * kLetterWidth * layout.scale;
  std::vector<int> row_of;
  int x = PictureLayout::kMargin, row = 0;
  for (auto& entry : layout.legend) {
    const int wide = patch + text_width(entry.name, layout.scale) + gap;
    if (x > PictureLayout::kMargin && x + wide - gap > width - PictureLayout::kMargin)
      x = PictureLayout::kMargin, ++row;
    entry.x = x;
    row_of.push_back(row);
    x += wide;
  }
  const int step = layout.line() + 4, high = (row + 1) * step + PictureLayout::kMargin / 2;
  for (std::size_t i = 0; i < layout.legend.size(); ++i)
    layout.legend[i].y = height - high + row_of[i] * step;
  return high;
}

void fill(Image& image, int x, int y, int width, int height, Rgb colour) {
  for (int v = std::max(0, y); v < std::min(image.height(), y + height); ++v) {
    for (int u = std::max(0, x); u < std::min(image.width(), x + width); ++u) image.at(u, v) = colour;
  }
}

/// The longest of 1, 2, 5 times a power of ten that is no longer than `most` [m].
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= most) return times * power;
  }
  return power;
}

}  // namespace

PictureLayout layout_of(const GraspScene& scene, const PictureOptions& options) {
  PictureLayout layout;
  layout.views_bottom = options.height;
  if (!options.words) return layout;
  layout.scale = options.width >= kWide ? 2 : 1;
  const int width = options.width - 2 * PictureLayout::kMargin;
  layout.title = wrapped(scene.title, width, layout.scale, 1);
  layout.verdict = wrapped(scene.verdict, width, layout.scale, 2);
  layout.legend = entries_of(scene, options);
  const int lines = static_cast<int>(layout.title.size() + layout.verdict.size());
  layout.views_top = PictureLayout::kMargin + lines * layout.line();
  layout.views_bottom =
      options.height - place_legend(layout, options.width, options.height) - 2 * layout.line();
  return layout;
}

void draw_words(Image& image, const PictureLayout& layout) {
  int y = PictureLayout::kMargin;
  for (const auto& text : layout.title)
    draw_text(image, PictureLayout::kMargin, y, text, kInk, layout.scale), y += layout.line();
  for (const auto& text : layout.verdict)
    draw_text(image, PictureLayout::kMargin, y, text, kFaint, layout.scale), y += layout.line();
  for (const auto& entry : layout.legend) {
    fill(image, entry.x, entry.y, layout.line(), 7 * layout.scale, picture_ink(entry.ink));
    draw_text(image, entry.x + layout.line() + 4, entry.y, entry.name, kInk, layout.scale);
  }
}

void draw_caption(Image& image, const PictureLayout& layout, const PicturePanel& panel) {
  const int y = layout.views_bottom + layout.line() / 3, left = panel.left + PictureLayout::kMargin;
  const auto name = wrapped(panel.view.name, panel.width - 2 * PictureLayout::kMargin, layout.scale, 1);
  int right = left;
  for (const auto& text : name)
    draw_text(image, left, y, text, kInk, layout.scale), right += text_width(text, layout.scale);
  if (panel.perspective) return;
  const int end = panel.left + panel.width - PictureLayout::kMargin;
  double length_m = round_length(0.25 * panel.width * panel.pixel_m);
  std::string words;
  int bar = 0, begin = 0;
  for (int shorter = 0;; ++shorter, length_m = round_length(0.9 * length_m)) {
    if (shorter == 3) return;
    words = fmt::format("{:g} mm", length_m * 1e3);
    bar = static_cast<int>(std::lround(length_m / panel.pixel_m));
    begin = end - bar - 6 - text_width(words, layout.scale);
    if (begin >= right + kLetterWidth * layout.scale) break;
  }
  fill(image, end - bar, y + 3 * layout.scale, bar, layout.scale, kInk);
  for (const int x : {end - bar, end - layout.scale})
    fill(image, x, y + layout.scale, layout.scale, 5 * layout.scale, kInk);
  draw_text(image, begin, y, words, kInk, layout.scale);
}

}  // namespace preshape
