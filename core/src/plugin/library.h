#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "preshape/plugin/entry.h"

namespace preshape {

/// A loaded plugin library. Whatever is made from it holds a shared_ptr to it.
class Library {
 public:
  /// Loads it, checks that the entry fits the manifest read from the file, and that loading left locale,
  /// working directory and floating-point mode as they were.
  /// @throws PluginError in one sentence
  static std::shared_ptr<const Library> load(const std::filesystem::path& file, const Manifest& manifest);

  virtual ~Library() = default;
  virtual const PluginEntry& entry() const = 0;
  std::span<const ComponentBinding> components() const;
};

}  // namespace preshape
