#include "scene_files.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "preshape/base/error.h"
#include "preshape/io/gltf.h"
#include "preshape/io/page.h"

namespace preshape::app {

std::filesystem::path page_template(const Catalogue& catalogue) {
  for (const auto& root : catalogue.roots()) {
    const auto file = root / "page" / "template.html";
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) return file;
  }
  return {};
}

void SceneFiles::add_to(CLI::App& verb) {
  verb.add_option("--scene", scene, "also write the scene as glTF binary (.glb), with the hand's motion")
      ->type_name("FILE");
  verb.add_option("--page", page, "also write one HTML page with the scene, the numbers and the plots")
      ->type_name("FILE");
}

void SceneFiles::check(const Catalogue& catalogue, bool one_run) const {
  if (!one_run && !(scene.empty() && page.empty())) {
    throw InputError(fmt::format(
        "{} shows one run, and this is a comparison or a study; choose one combination with --set",
        scene.empty() ? "--page" : "--scene"));
  }
  if (!page.empty() && page_template(catalogue).empty()) {
    throw InputError(
        "this build has no page template, so --page cannot be served; install node and npm, build again where "
        "the npm registry can be reached, or use --scene");
  }
}

void SceneFiles::write(const Catalogue& catalogue, const RunRecord& record, ShownTry shown) const {
  if (scene.empty() && page.empty()) return;
  const std::string glb = gltf_binary(grasp_scene(record, shown));
  if (!scene.empty()) write_file(scene, glb);
  if (!page.empty()) write_file(page, page_html(read_page_template(page_template(catalogue)), record, glb));
}

}  // namespace preshape::app
