#pragma once

#include <filesystem>

#include "preshape/plugin/registry.h"

namespace preshape::test {

/// The plugins of this build, found where the build puts them.
inline const Registry& registry() {
  static const Registry registry({{std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", "build"}});
  return registry;
}

}  // namespace preshape::test
