#include "run_pictures.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "preshape/base/error.h"
#include "preshape/io/fuzzy_matrix_svg.h"
#include "preshape/io/picture.h"

namespace preshape::app {

namespace {

std::pair<int, int> parsed_size(const std::string& text) {
  int width = 0, height = 0, read = 0;
  const bool two = std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &read) == 2 &&
                   read == static_cast<int>(text.size());
  if (!two || width < kSmallestWidth || height < kSmallestHeight || width > Image::kWidest ||
      height > Image::kWidest) {
    throw CLI::ValidationError(
        "--picture-size", fmt::format("'{}' is no size of a picture; give WIDTHxHEIGHT, {}x{} to {}x{}", text,
                                      kSmallestWidth, kSmallestHeight, Image::kWidest, Image::kWidest));
  }
  return {width, height};
}

std::vector<double> parsed_view(const std::string& text) {
  double x = 0.0, y = 0.0, z = 0.0;
  int read = 0;
  const bool three = std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &x, &y, &z, &read) == 3 &&
                     read == static_cast<int>(text.size());
  const double norm = std::sqrt(x * x + y * y + z * z);
  if (!three || !(norm > 1e-6) || !(norm < 1e6)) {
    throw CLI::ValidationError(
        "--view", fmt::format("'{}' is no way to look; give X,Y,Z, not all zero, such as -1,-2,-1", text));
  }
  return {x, y, z};
}

/// The rays are cast by what cast those of the run.
std::shared_ptr<CollisionBackend> backend_of(Application& application, const RunRecord& record) {
  const auto use = std::find_if(record.components.begin(), record.components.end(),
                                [](const ComponentUse& c) { return c.kind == "collision"; });
  if (use == record.components.end())
    throw InputError("--picture: the run has no collision backend to cast rays with");
  return application.registry().create<CollisionBackend>(use->name, use->parameters);
}

}  // namespace

void RunPictures::add_to(CLI::App& verb) {
  auto* file =
      verb.add_option("--picture", picture, "also draw object, hand and grasp as PNG")->type_name("FILE.png");
  verb.add_option_function<std::string>(
          "--view", [this](const std::string& text) { view = parsed_view(text); },
          "one view along this way in the object's frame, instead of three")
      ->type_name("X,Y,Z")
      ->needs(file);
  verb.add_option_function<std::string>(
          "--picture-size", [this](const std::string& text) { size = parsed_size(text); },
          "of the whole picture in pixels [1440x620]")
      ->type_name("WxH")
      ->needs(file);
  verb.add_option_function<std::string>(
          "--posture", [this](const std::string& text) { open = text == "open"; },
          "the hand as it holds the object (grasp), or as it comes (open) [grasp]")
      ->type_name("open|grasp")
      ->check(CLI::IsMember({"open", "grasp"}))
      ->needs(file);
  verb.add_flag("--picture-palette", palette, "draw with 256 colours at most, for a smaller file")
      ->needs(file);
  verb.add_option("--matrices", matrices, "also draw the fuzzy matrices of task and wrench as SVG")
      ->type_name("FILE.svg");
}

void RunPictures::check(bool one_run) const {
  if (!asked() || one_run) return;
  throw InputError(fmt::format("{} draws one run, not a comparison or a study; run one scenario",
                               picture.empty() ? "--matrices" : "--picture"));
}

void RunPictures::write(Application& application, const RunRecord& record, ShownTry shown) const {
  if (!picture.empty()) {
    PictureOptions options;
    std::tie(options.width, options.height) = size;
    if (!view.empty()) options.views = {picture_view({view[0], view[1], view[2]})};
    options.frame = open ? 0 : -1;
    const Image image =
        preshape::picture(grasp_scene(record, shown), *backend_of(application, record), options);
    write_file(picture, png_file(palette ? with_few_colours(image) : image));
  }
  if (!matrices.empty()) write_file(matrices, fuzzy_matrix_svg(fuzzy_matrices(record)));
}

}  // namespace preshape::app
