#include "preshape/base/installation.h"

#include <dlfcn.h>

#include <cstdlib>
#include <string_view>

namespace preshape {

std::filesystem::path library_folder() {
  Dl_info info{};
  if (!dladdr(reinterpret_cast<const void*>(&library_folder), &info) || !info.dli_fname) return {};
  std::error_code ignored;
  return std::filesystem::canonical(info.dli_fname, ignored).parent_path();
}

std::filesystem::path user_folder() {
  if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data) return std::filesystem::path(data) / "preshape";
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::filesystem::path(home) / ".local/share/preshape";
  }
  return {};
}

std::vector<std::filesystem::path> environment_folders(const char* variable) {
  std::vector<std::filesystem::path> folders;
  const char* list = std::getenv(variable);
  std::string_view rest = list ? list : "";
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    if (const auto item = rest.substr(0, colon); !item.empty()) folders.emplace_back(item);
    rest = colon == std::string_view::npos ? std::string_view{} : rest.substr(colon + 1);
  }
  return folders;
}

}  // namespace preshape
