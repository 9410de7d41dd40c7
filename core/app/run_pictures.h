#pragma once

#include <string>

#include "application.h"
#include "preshape/io/grasp_scene.h"

namespace CLI {
class App;
}

namespace preshape::app {

/// Options of `run` that draw its result.
struct RunPictures {
  std::string picture, matrices;
  std::vector<double> view;
  std::pair<int, int> size = {1440, 620};
  bool palette = false, open = false;  ///< few colours; the hand as it comes, not as it holds

  void add_to(CLI::App& verb);
  bool asked() const { return !picture.empty() || !matrices.empty(); }
  /// @throws InputError when there is no one run to draw
  void check(bool one_run) const;
  /// Draws what was asked for of a run.
  void write(Application& application, const RunRecord& record, ShownTry shown) const;
};

}  // namespace preshape::app
