#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// Red, green, blue as on a screen (sRGB).
using Rgb = std::array<std::uint8_t, 3>;

/// A picture made of pixels.
class PRESHAPE_API Image {
 public:
  /// @param width, height [px], 1 .. kWidest
  /// @throws InputError on a size out of that range
  Image(int width, int height, Rgb colour);

  int width() const { return width_; }
  int height() const { return height_; }
  /// x to the right, y down, both from 0 and within the image.
  Rgb& at(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  const Rgb& at(int x, int y) const { return const_cast<Image&>(*this).at(x, y); }
  /// Row by row.
  const std::vector<Rgb>& pixels() const { return pixels_; }
  std::vector<Rgb>& pixels() { return pixels_; }

  static constexpr int kWidest = 8192;

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};

/// The image as a PNG file: 8 bits a channel, or a palette where it has 256 colours at most. The same image
/// gives the same bytes.
/// @throws Error when libpng fails
PRESHAPE_API std::string png_file(const Image& image);

/// The image with 256 colours at most, the ones that it has most of told apart best (median cut), so that its
/// file is small.
PRESHAPE_API Image with_few_colours(const Image& image);

}  // namespace preshape
