#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/base/parameters.h"
#include "preshape/plugin/kind.h"
#include "preshape/plugin/loader.h"
#include "preshape/plugin/manifest.h"

namespace preshape {

/// A folder in which plugins are looked for, or one plugin file, and why it is in the list.
struct SearchFolder {
  std::filesystem::path path;
  std::string origin;  ///< "--plugin-path", "PRESHAPE_PLUGIN_PATH", "user", "installation", ...
  /// Sandboxed components alone, and not from the folders below: for a folder that holds other things too.
  bool sandboxed_only = false;
};

/// The kind and name of a component.
struct ComponentKey {
  std::string kind, name;
  auto operator<=>(const ComponentKey&) const = default;
};

/// What became of a library that was found.
struct LibraryRecord {
  enum class Status { kUsable, kRefused, kShadowed };
  std::filesystem::path file;
  std::string origin;
  Status status = Status::kUsable;
  std::vector<std::string> reasons;  ///< unless usable: sentences that name both sides and the mend
  Manifest manifest{};               ///< as far as it could be read, else zero
  std::string language;              ///< "C++", "Lua"

  /// What the manifest lists; a script that fails before it says its kind has an empty one.
  PRESHAPE_API std::vector<ComponentKey> components() const;
};

/// A component that can be made, as its manifest and its declaration tell.
struct ComponentRecord {
  std::string kind, name, summary;
  std::vector<std::string> capabilities;
  ParameterSchema schema;  ///< its owner is "<kind> '<name>'"
  std::filesystem::path file;
  std::string plugin, version, licence, author, language;
};

/// Finds, checks, loads and makes plugins. Scanning reads manifests only (of a script: by running it in its
/// sandbox). A shared object is loaded when one of its components is described or made, through Boost.DLL with
/// every symbol bound at once and nothing shared; whatever is made from it keeps it loaded. [any thread]
class PRESHAPE_API Registry {
 public:
  /// Folders are looked through in order, themselves and one level below; the first component of a name wins, in
  /// one folder that of a shared object.
  /// @param loaders of files other than shared objects
  explicit Registry(std::vector<SearchFolder> folders,
                    std::vector<std::shared_ptr<const ComponentLoader>> loaders = {});
  ~Registry();
  Registry(const Registry&) = delete;
  Registry& operator=(const Registry&) = delete;

  std::span<const SearchFolder> folders() const;
  std::span<const LibraryRecord> libraries() const;
  /// Every component of the usable libraries, sorted by the order of kKinds, then by name.
  std::vector<ComponentKey> components() const;
  std::vector<std::string> names(std::string_view kind) const;
  bool has(std::string_view kind, std::string_view name) const;

  /// Loads the component's library and reads its declaration.
  /// @throws PluginError when there is no such component (with the nearest name), or its library is refused
  const ComponentRecord& describe(std::string_view kind, std::string_view name) const;

  /// A new component of T's kind.
  /// @param given nil or a table of parameters; @param place of the mistake, when `given` has none
  /// @throws PluginError as describe, or when the component cannot be made; InputError on wrong parameters
  template <class T>
  std::shared_ptr<T> create(std::string_view name, const Value& given = {}, const SourcePlace& place = {}) const {
    return std::static_pointer_cast<T>(create_erased(kind_of<T>(), name, given, place));
  }

  /// How `name` was looked for: every folder, every library that has it, what was decided and why; lines.
  std::vector<std::string> why(std::string_view kind, std::string_view name) const;

 private:
  std::shared_ptr<void> create_erased(std::string_view kind, std::string_view name, const Value& given,
                                      const SourcePlace& place) const;
  struct State;
  std::unique_ptr<State> state_;
};

/// The search path: `first` (from the command line or the scenario), PRESHAPE_PLUGIN_PATH, the user's data
/// folder, then the folder beside this library.
PRESHAPE_API std::vector<SearchFolder> default_search_folders(std::span<const std::filesystem::path> first = {});

}  // namespace preshape
