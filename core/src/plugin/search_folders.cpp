#include <dlfcn.h>

#include <cstdlib>

#include "preshape/plugin/registry.h"

namespace preshape {

namespace {

void add_path_list(const char* list, const std::string& origin, std::vector<SearchFolder>& folders) {
  if (!list) return;
  std::string_view rest = list;
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    const auto item = rest.substr(0, colon);
    if (!item.empty()) folders.push_back({std::filesystem::path(item), origin});
    rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 1);
  }
}

std::filesystem::path user_data_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data) return std::filesystem::path(data) / "preshape";
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::filesystem::path(home) / ".local/share/preshape";
  }
  return {};
}

/// The folder of this shared library.
std::filesystem::path library_folder() {
  Dl_info info{};
  if (!dladdr(reinterpret_cast<const void*>(&host_fingerprint), &info) || !info.dli_fname) return {};
  std::error_code ignored;
  return std::filesystem::canonical(info.dli_fname, ignored).parent_path();
}

}  // namespace

std::vector<SearchFolder> default_search_folders(std::span<const std::filesystem::path> first) {
  std::vector<SearchFolder> folders;
  for (const auto& path : first) folders.push_back({path, "--plugin-path"});
  add_path_list(std::getenv("PRESHAPE_PLUGIN_PATH"), "PRESHAPE_PLUGIN_PATH", folders);
  if (const auto user = user_data_folder(); !user.empty()) folders.push_back({user / "plugins", "user"});
  if (const auto library = library_folder(); !library.empty()) {
    folders.push_back({library / "preshape" / "plugins", "installation"});
  }
  return folders;
}

}  // namespace preshape
