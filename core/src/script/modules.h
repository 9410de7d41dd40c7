#pragma once

#include <filesystem>
#include <string>

namespace preshape::lua {

/// The text of a file. @throws InputError "<what> 'x.lua' cannot be read (No such file or directory)"
std::string read_text(const std::filesystem::path& path, const std::string& what);

/// How messages show the file that a person named: as given, or relative to the current folder when it is
/// absolute and inside it.
std::string shown_name(const std::filesystem::path& path);

}  // namespace preshape::lua
