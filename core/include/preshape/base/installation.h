#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// The folder of this shared library. Plugins are in preshape/plugins below it, shipped objects, hands and scripts in
/// ../share/preshape.
PRESHAPE_API std::filesystem::path library_folder();

/// The user's own folder: $XDG_DATA_HOME/preshape, else ~/.local/share/preshape; empty when neither is known.
PRESHAPE_API std::filesystem::path user_folder();

/// The folders of a colon-separated environment variable; empty ones are left out.
PRESHAPE_API std::vector<std::filesystem::path> environment_folders(const char* variable);

}  // namespace preshape
