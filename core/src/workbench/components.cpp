#include "preshape/workbench/components.h"

#include <algorithm>

#include "preshape/base/installation.h"
#include "preshape/scripted/lua_loader.h"

namespace preshape {

namespace fs = std::filesystem;

std::vector<SearchFolder> component_folders(const Catalogue& catalogue, std::span<const fs::path> first,
                                            const fs::path& scenario) {
  std::vector<SearchFolder> folders = default_search_folders(first);
  if (!scenario.empty()) {
    const fs::path folder = scenario.has_parent_path() ? scenario.parent_path() : fs::path(".");
    folders.insert(folders.begin() + static_cast<std::ptrdiff_t>(first.size()),
                   {folder, "beside the scenario", true});
  }
  // The user's own go before what is installed, whatever they are written in.
  const auto is_installed = [](const SearchFolder& folder) { return folder.origin == "installation"; };
  for (std::size_t i = 0; i < catalogue.roots().size(); ++i) {
    const fs::path& root = catalogue.roots()[i];
    const bool last = i + 1 == catalogue.roots().size() && root != user_folder();
    const SearchFolder components{root / "scripts" / "components",
                                  last ? "installation" : "scripts/components", true};
    const auto at = last ? folders.end() : std::find_if(folders.begin(), folders.end(), is_installed);
    folders.insert(at, components);
  }
  return folders;
}

std::unique_ptr<Registry> open_registry(const Catalogue& catalogue, std::span<const fs::path> first,
                                        const fs::path& scenario) {
  std::vector<std::shared_ptr<const ComponentLoader>> loaders = {
      std::make_shared<LuaLoader>(catalogue.module_roots())};
  return std::make_unique<Registry>(component_folders(catalogue, first, scenario), std::move(loaders));
}

}  // namespace preshape
