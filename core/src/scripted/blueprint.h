#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "preshape/base/parameters.h"
#include "script/host.h"

namespace preshape::scripted {

/// The text of a component's file, as it was when it was read.
struct ComponentSource {
  std::filesystem::path file;
  std::string text;
  std::string shown;  ///< in messages
  std::vector<std::filesystem::path> module_roots;

  /// @throws InputError when the file cannot be read
  static ComponentSource read(const std::filesystem::path& file,
                              std::vector<std::filesystem::path> module_roots);
};

/// A new Lua state that has run nothing yet.
/// @param keeps_places so that data out of it knows its lines
std::unique_ptr<lua::Host> open_host(const ComponentSource& source, bool keeps_places);

/// Runs the file and leaves the table that it returns on the stack. Inside of Host::enter.
void push_component(lua_State* L, const ComponentSource& source);

/// What an object is made from: file, declared identity, parameters.
struct Blueprint {
  ComponentSource source;
  std::string kind, name;
  Parameters parameters;

  /// "similarity 'cosine'"
  std::string owner() const;
};

/// Calls `new` with the parameters and leaves the table that it returns on the stack. Inside of Host::enter.
/// @returns where `new` is written
SourcePlace push_instance(lua_State* L, const Blueprint& blueprint);

/// The table that `new` returns, as data that knows its lines. Its functions can be told, not called.
Value inspect(const Blueprint& blueprint);

/// Where the function at `index` begins.
SourcePlace definition(lua_State* L, int index);

}  // namespace preshape::scripted
