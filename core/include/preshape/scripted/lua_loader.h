#pragma once

#include <vector>

#include "preshape/plugin/loader.h"

namespace preshape {

/// Components written in Lua, one a file NAME.plugin.lua that returns its declaration
/// (docs/lua-components.md). Every kind but `collision`. A file is run in the sandbox of scripts to learn
/// what it declares; an object runs it once more in each thread that calls it at the same time, in a Lua
/// state of its own. A failing script is a ScriptError with file and line.
class PRESHAPE_API LuaLoader final : public ComponentLoader {
 public:
  /// @param module_roots folders that `require` searches after the file's own
  explicit LuaLoader(std::vector<std::filesystem::path> module_roots = {});
  ~LuaLoader() override;

  std::string_view language() const noexcept override { return "Lua"; }
  bool sandboxed() const noexcept override { return true; }
  bool claims(const std::filesystem::path& file) const override;
  ManifestReading read(const std::filesystem::path& file) const override;
  std::shared_ptr<const ComponentLibrary> load(const std::filesystem::path& file,
                                               const Manifest& manifest) const override;

 private:
  std::vector<std::filesystem::path> module_roots_;
};

}  // namespace preshape
