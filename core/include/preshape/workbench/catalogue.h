#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// The objects, hands and scripts that are found by name: folders with objects/NAME/object.lua, hands/NAME/hand.lua
/// and scripts/ in them. The first folder that has a name wins.
class PRESHAPE_API Catalogue {
 public:
  explicit Catalogue(std::vector<std::filesystem::path> roots);
  /// PRESHAPE_DATA_PATH, the user's folder, then the installation's.
  static Catalogue standard();

  const std::vector<std::filesystem::path>& roots() const { return roots_; }
  std::vector<std::string> objects() const { return names("objects", "object.lua"); }
  std::vector<std::string> hands() const { return names("hands", "hand.lua"); }
  /// The description file of a name.
  /// @throws InputError with the nearest name
  std::filesystem::path object(std::string_view name) const { return find("objects", "object.lua", name); }
  std::filesystem::path hand(std::string_view name) const { return find("hands", "hand.lua", name); }
  /// A script below scripts/, such as "pretrain/cube.lua".
  /// @throws InputError
  std::filesystem::path script(std::string_view name) const;
  /// Folders in which scripts' `require` looks.
  std::vector<std::filesystem::path> module_roots() const;

 private:
  std::vector<std::string> names(const char* folder, const char* file) const;
  std::filesystem::path find(const char* folder, const char* file, std::string_view name) const;

  std::vector<std::filesystem::path> roots_;
};

}  // namespace preshape
