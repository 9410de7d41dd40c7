#pragma once

#include <fstream>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "preshape/plugin/registry.h"
#include "preshape/scripted/lua_loader.h"
#include "support/data.h"

namespace preshape::test {

inline void write_component(const std::filesystem::path& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / (name + ".plugin.lua")) << text;
}

/// A file's text that declares a component of that kind and name; `inside` is the body of `new`, from line 4 on.
inline std::string component_text(const std::string& kind, const std::string& name, const std::string& inside,
                                  const std::string& more = "") {
  return fmt::format("return {{ kind = \"{}\", name = \"{}\", version = \"1.0.0\", licence = \"MIT\",\n"
                     "  author = \"A. Author\", summary = \"One line\", {}\n"
                     "  new = function(p)\n{}\n  end }}\n",
                     kind, name, more, inside);
}

inline std::vector<std::shared_ptr<const ComponentLoader>> lua_loaders() { return {std::make_shared<LuaLoader>()}; }

/// One component in a folder of its own, found by its name.
class OneComponent {
 public:
  OneComponent(const std::string& kind, const std::string& name, const std::string& inside, const std::string& more = "")
      : OneComponent(name, component_text(kind, name, inside, more)) {}
  OneComponent(const std::string& name, const std::string& text) {
    write_component(folder_.path(), name, text);
    registry_ = std::make_unique<Registry>(std::vector<SearchFolder>{{folder_.path(), "test"}}, lua_loaders());
  }
  const Registry& operator*() const { return *registry_; }
  const Registry* operator->() const { return registry_.get(); }

 private:
  TemporaryDirectory folder_;
  std::unique_ptr<Registry> registry_;
};

}  // namespace preshape::test
