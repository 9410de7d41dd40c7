#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace preshape::conformance {

/// What a shared object tells the dynamic loader.
struct DynamicTable {
  std::vector<std::string> exported, unique, undefined;  ///< symbols
  std::vector<std::string> needed;                       ///< libraries
  std::vector<std::string> run_paths;                    ///< folders of RPATH and RUNPATH
  bool text_relocations = false;
};

/// Reads it from a 64-bit ELF file of this machine that was found sound before.
/// @throws InputError when an offset leaves the file
DynamicTable dynamic_table(const std::filesystem::path& file);

}  // namespace preshape::conformance
