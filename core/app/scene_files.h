#pragma once

#include <filesystem>
#include <string>

#include "application.h"
#include "preshape/io/grasp_scene.h"

namespace preshape::app {

/// The template of the page: the first root of the catalogue that has it wins. An empty path where none has.
std::filesystem::path page_template(const Catalogue& catalogue);

/// The files of `run` that show a scene: what each is, and how they are written.
struct SceneFiles {
  std::string scene, page;  ///< paths; empty: not asked for

  void add_to(CLI::App& verb);
  /// Before anything is run: a comparison or a study has no one scene, and a page needs its template.
  /// @throws InputError
  void check(const Catalogue& catalogue, bool one_run) const;
  /// @throws InputError
  void write(const Catalogue& catalogue, const RunRecord& record, ShownTry shown) const;
};

}  // namespace preshape::app
