#include "preshape/io/png.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <png.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr std::size_t kMostColours = 256;

/// Writes by libpng's simplified interface, which returns instead of jumping when something fails.
std::string written(png_image& image, const void* pixels, const void* palette) {
  const auto check = [&](int done) {
    if (!done)
      throw Error(fmt::format("libpng cannot write a picture of {} x {} pixels: {}", image.width,
                              image.height, image.message));
  };
  png_alloc_size_t size = 0;
  check(png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, palette));
  std::string file(size, '\0');
  check(png_image_write_to_memory(&image, file.data(), &size, 0, pixels, 0, palette));
  file.resize(size);
  return file;
}

/// Every colour of the image with how many pixels have it.
std::map<Rgb, std::size_t> colours_of(const Image& image) {
  std::map<Rgb, std::size_t> colours;
  auto last = colours.end();
  for (const Rgb& pixel : image.pixels()) {
    if (last == colours.end() || last->first != pixel) last = colours.try_emplace(pixel, 0).first;
    ++last->second;
  }
  return colours;
}

/// Colours that become one: a box of the colour cube.
struct Cut {
  std::vector<std::pair<Rgb, std::size_t>> colours;
  std::size_t channel = 0;  ///< of the widest side
  double worth = 0.0;       ///< what splitting it would better

  void measure() {
    int widest = 0;
    double pixels = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [low, high] =
          std::minmax_element(colours.begin(), colours.end(),
                              [c](const auto& a, const auto& b) { return a.first[c] < b.first[c]; });
      const int width = high->first[c] - low->first[c];
      if (width > widest) widest = width, channel = c;
    }
    for (const auto& [colour, count] : colours) pixels += static_cast<double>(count);
    worth = widest * widest * std::sqrt(pixels);
  }

  /// Splits at the middle of the pixels along the widest side.
  Cut split() {
    std::sort(colours.begin(), colours.end(), [this](const auto& a, const auto& b) {
      return a.first[channel] != b.first[channel] ? a.first[channel] < b.first[channel] : a.first < b.first;
    });
    std::size_t all = 0, lower = 0, at = 0;
    for (const auto& [colour, count] : colours) all += count;
    while (at + 1 < colours.size() && (at == 0 || 2 * (lower + colours[at].second) <= all))
      lower += colours[at++].second;
    Cut upper;
    upper.colours.assign(colours.begin() + static_cast<std::ptrdiff_t>(at), colours.end());
    colours.resize(at);
    measure();
    upper.measure();
    return upper;
  }

  /// The colour that has most pixels of it: large areas keep theirs.
  Rgb colour() const {
    return std::max_element(colours.begin(), colours.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }
};

}  // namespace

Image::Image(int width, int height, Rgb colour) : width_(width), height_(height) {
  if (width < 1 || height < 1 || width > kWidest || height > kWidest) {
    throw InputError(fmt::format("a picture of {} x {} pixels cannot be made; give 1 to {} each way", width,
                                 height, kWidest));
  }
  pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), colour);
}

std::string png_file(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  const auto colours = colours_of(image);
  if (colours.size() > kMostColours) {
    header.format = PNG_FORMAT_RGB;
    return written(header, image.pixels().data(), nullptr);
  }
  std::vector<Rgb> palette;
  for (const auto& [colour, count] : colours) palette.push_back(colour);
  std::vector<std::uint8_t> indices;
  for (const Rgb& pixel : image.pixels()) {
    indices.push_back(
        static_cast<std::uint8_t>(std::lower_bound(palette.begin(), palette.end(), pixel) - palette.begin()));
  }
  header.format = PNG_FORMAT_RGB_COLORMAP;
  header.colormap_entries = static_cast<png_uint_32>(palette.size());
  return written(header, indices.data(), palette.data());
}

Image with_few_colours(const Image& image) {
  const auto colours = colours_of(image);
  if (colours.size() <= kMostColours) return image;
  std::vector<Cut> cuts(1);
  cuts.front().colours.assign(colours.begin(), colours.end());
  cuts.front().measure();
  while (cuts.size() < kMostColours) {
    const auto widest = std::max_element(cuts.begin(), cuts.end(),
                                         [](const auto& a, const auto& b) { return a.worth < b.worth; });
    Cut upper = widest->split();
    cuts.push_back(std::move(upper));
  }
  std::map<Rgb, Rgb> becomes;
  for (const Cut& cut : cuts) {
    for (const auto& [colour, count] : cut.colours) becomes[colour] = cut.colour();
  }
  Image few = image;
  for (Rgb& pixel : few.pixels()) pixel = becomes.at(pixel);
  return few;
}

}  // namespace preshape
