#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "preshape/plugin/registry.h"
#include "preshape/workbench/catalogue.h"

namespace preshape {

/// Where components are looked for, in this order: `first` (from the command line), beside the scenario,
/// PRESHAPE_PLUGIN_PATH, the user's folder, the installation; and, wherever the catalogue has one, scripts/components.
/// Beside the scenario and in scripts/components only what is sandboxed counts: a shared object is not run because of
/// where it lies.
/// @param scenario a script's file, or empty
PRESHAPE_API std::vector<SearchFolder> component_folders(const Catalogue& catalogue,
                                                         std::span<const std::filesystem::path> first = {},
                                                         const std::filesystem::path& scenario = {});

/// A registry of those folders that knows shared objects and Lua.
PRESHAPE_API std::unique_ptr<Registry> open_registry(const Catalogue& catalogue,
                                                     std::span<const std::filesystem::path> first = {},
                                                     const std::filesystem::path& scenario = {});

}  // namespace preshape
