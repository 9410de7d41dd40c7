#include "preshape/workbench/catalogue.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/installation.h"
#include "preshape/base/suggest.h"

namespace preshape {

namespace fs = std::filesystem;

Catalogue::Catalogue(std::vector<fs::path> roots) : roots_(std::move(roots)) {}

Catalogue Catalogue::standard() {
  std::vector<fs::path> roots = environment_folders("PRESHAPE_DATA_PATH");
  if (const auto user = user_folder(); !user.empty()) roots.push_back(user);
  if (const auto library = library_folder(); !library.empty()) {
    roots.push_back((library / ".." / "share" / "preshape").lexically_normal());
  }
  return Catalogue(std::move(roots));
}

std::vector<std::string> Catalogue::names(const char* folder, const char* file) const {
  std::vector<std::string> names;
  for (const auto& root : roots_) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root / folder, error)) {
      if (fs::exists(entry.path() / file, error)) names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

fs::path Catalogue::find(const char* folder, const char* file, std::string_view name) const {
  for (const auto& root : roots_) {
    std::error_code error;
    const fs::path path = root / folder / name / file;
    if (!name.empty() && fs::exists(path, error)) return path;
  }
  const std::string_view what = std::string_view(folder).substr(0, std::string_view(folder).size() - 1);
  const auto known = names(folder, file);
  throw InputError(fmt::format("there is no {} '{}'{}", what, name,
                               known.empty() ? "; no folder of them was found, see 'preshape doctor'" : did_you_mean(name, known)));
}

fs::path Catalogue::script(std::string_view name) const {
  for (const auto& root : roots_) {
    std::error_code error;
    const fs::path path = root / "scripts" / name;
    if (fs::is_regular_file(path, error)) return path;
  }
  throw InputError(fmt::format("there is no script '{}' in the installation; see 'preshape doctor'", name));
}

std::vector<fs::path> Catalogue::module_roots() const {
  std::vector<fs::path> roots;
  for (const auto& root : roots_) roots.push_back(root / "scripts");
  return roots;
}

}  // namespace preshape
