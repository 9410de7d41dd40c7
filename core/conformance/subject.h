#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/plugin/registry.h"

namespace preshape::conformance {

/// The component that a run is about, known by its manifest alone: none of its code has run.
struct Subject {
  std::filesystem::path file;
  std::string kind, name;

  bool native() const { return file.extension() == ".so"; }
  std::string title() const { return kind + "/" + name; }
};

/// The components in one plugin file. Its folder is no matter.
/// @throws PluginError when the file is no plugin or is refused, InputError when it is not there
std::vector<Subject> subjects_in(const std::filesystem::path& file);

/// A registry that sees one plugin file only.
std::unique_ptr<Registry> registry_of(const std::filesystem::path& file);

}  // namespace preshape::conformance
