#pragma once

#include <string_view>

#include "preshape/io/png.h"

namespace preshape {

/// Width of a letter with the gap behind it, and height of a line with its descenders, at scale 1 [px].
inline constexpr int kLetterWidth = 6, kLetterHeight = 9;

/// Writes a line of text with its upper left corner at a pixel; what is outside of the image is left out.
/// Characters that are not printable ASCII are drawn as ?, one for each of UTF-8.
/// @param scale whole, >= 1; corners are rounded from 2 on
void draw_text(Image& image, int x, int y, std::string_view words, Rgb colour, int scale);

/// Width of a line of text at a scale [px].
int text_width(std::string_view words, int scale);

/// The words in lines no wider than `width` px, broken at spaces where there are any; at most `lines`, the
/// last ends in
/// "..." where there were more words.
std::vector<std::string> wrapped(std::string_view words, int width, int scale, int lines);

}  // namespace preshape
