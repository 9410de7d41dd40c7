#pragma once

#include <filesystem>
#include <memory>

#include "preshape/plugin/registry.h"
#include "preshape/scripted/lua_loader.h"

namespace preshape::test {

/// The plugins of this build, found where the build puts them, and the components in Lua of the source tree.
inline const Registry& registry() {
  static const Registry registry({{std::filesystem::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins", "build"},
                                  {std::filesystem::path(PRESHAPE_SOURCE_DIR) / "scripts/components", "source", true}},
                                 {std::make_shared<LuaLoader>()});
  return registry;
}

}  // namespace preshape::test
