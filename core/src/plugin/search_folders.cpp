#include "preshape/base/installation.h"
#include "preshape/plugin/registry.h"

namespace preshape {

std::vector<SearchFolder> default_search_folders(std::span<const std::filesystem::path> first) {
  std::vector<SearchFolder> folders;
  for (const auto& path : first) folders.push_back({path, "--plugin-path"});
  for (const auto& path : environment_folders("PRESHAPE_PLUGIN_PATH")) folders.push_back({path, "PRESHAPE_PLUGIN_PATH"});
  if (const auto user = user_folder(); !user.empty()) folders.push_back({user / "plugins", "user"});
  if (const auto library = library_folder(); !library.empty()) {
    folders.push_back({library / "preshape" / "plugins", "installation"});
  }
  return folders;
}

}  // namespace preshape
