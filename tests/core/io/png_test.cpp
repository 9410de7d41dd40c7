#include "preshape/io/png.h"

#include <png.h>

#include <set>

#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/io");

namespace {

/// What libpng reads of a file.
Image decoded(const std::string& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&header, file.data(), file.size()));
  header.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(header.width), static_cast<int>(header.height), {});
  REQUIRE(png_image_finish_read(&header, nullptr, image.pixels().data(), 0, nullptr));
  return image;
}

/// Two slow ramps and a little noise: thousands of colours.
Image colourful(int width, int height) {
  Image image(width, height, {});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto channel = [](int v) { return static_cast<std::uint8_t>(v & 255); };
      image.at(x, y) = {channel(255 * x / width), channel(255 * y / height), channel(7 * x * y)};
    }
  }
  return image;
}

}  // namespace

TEST_CASE("PNG: libpng reads back every pixel, of few colours and of many") {
  const Image many = colourful(97, 61);
  const Image back = decoded(png_file(many));
  CHECK(back.width() == 97);
  CHECK(back.height() == 61);
  CHECK(back.pixels() == many.pixels());
  Image few(50, 3, {250, 250, 247});
  few.at(49, 2) = {1, 2, 3};
  CHECK(decoded(png_file(few)).pixels() == few.pixels());
  const Image one(1, 1, {9, 8, 7});
  CHECK(decoded(png_file(one)).pixels() == one.pixels());
}

TEST_CASE("PNG: the same image gives the same bytes") {
  CHECK(png_file(colourful(120, 90)) == png_file(colourful(120, 90)));
}

TEST_CASE("Few colours: at most 256, large areas keep theirs, every pixel stays near its own") {
  Image many = colourful(160, 160);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 160; ++x) many.at(x, y) = {250, 250, 247};
  }
  const Image few = with_few_colours(many);
  CHECK(std::set<Rgb>(few.pixels().begin(), few.pixels().end()).size() <= 256);
  CHECK(few.at(3, 3) == Rgb{250, 250, 247});
  double sum = 0.0;
  for (std::size_t i = 0; i < many.pixels().size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) sum += std::abs(many.pixels()[i][c] - few.pixels()[i][c]);
  }
  CHECK(sum / (3.0 * static_cast<double>(many.pixels().size())) < 16.0);
  const Image simple(4, 4, {1, 2, 3});
  CHECK(with_few_colours(simple).pixels() == simple.pixels());
}

TEST_CASE("Image: a size that cannot be is refused in a sentence") {
  CHECK_THROWS_SAYING(Image(0, 5, {}), InputError,
                      "a picture of 0 x 5 pixels cannot be made; give 1 to 8192 each way");
  CHECK_THROWS_SAYING(Image(5, 8193, {}), InputError, "5 x 8193");
}

TEST_SUITE_END();
