#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "preshape/base/export.h"
#include "preshape/plugin/entry.h"
#include "preshape/plugin/manifest.h"

namespace preshape {

/// The components of one plugin file, loaded. [every call: any thread, const]
class PRESHAPE_API ComponentLibrary {
 public:
  virtual ~ComponentLibrary();

  /// In the order of the manifest; as long as the library lives.
  virtual std::span<const ComponentDeclaration> components() const noexcept = 0;

  /// A new component as a pointer to its kind's interface. Whatever it needs of the library it keeps alive.
  /// @param index of its declaration; @param parameters checked against that declaration
  /// @throws InputError or PluginError with the reason alone: who asks adds kind, name and place
  virtual std::shared_ptr<void> create(std::size_t index, const Parameters& parameters) const = 0;
};

/// One way in which components come in files: shared objects, scripts. [every call: any thread, const]
class PRESHAPE_API ComponentLoader {
 public:
  virtual ~ComponentLoader();

  /// What the files are written in, as listings show it: "C++", "Lua".
  virtual std::string_view language() const noexcept = 0;

  /// Whether what it loads is held back from files and processes, so that it may be taken from a folder that
  /// nobody named as one of plugins.
  virtual bool sandboxed() const noexcept = 0;

  /// Whether a file is its own, by the end of its name.
  virtual bool claims(const std::filesystem::path& file) const = 0;

  /// Who a file is and what it holds. Of a broken one as much of its manifest as is known; a component whose
  /// kind is not known has an empty kind: "/name".
  virtual ManifestReading read(const std::filesystem::path& file) const = 0;

  /// Loads a file whose manifest was read and is compatible.
  /// @throws PluginError in one sentence
  virtual std::shared_ptr<const ComponentLibrary> load(const std::filesystem::path& file,
                                                       const Manifest& manifest) const = 0;
};

}  // namespace preshape
