#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace preshape::lua {

/// What one table constructor of a source text says about its lines. Keys that a traceable assignment gives
/// it later (`s.contact.mu = 3`) are among its keys.
struct ConstructorLines {
  int line = 0;                                           ///< of its opening brace
  std::map<std::string, int, std::less<>> keys;           ///< line of each key
  std::vector<int> items;                                 ///< line of each positional item
  std::map<std::string, std::size_t, std::less<>> inner;  ///< constructors that stand as the value of a key
};

struct SourceMap {
  std::vector<ConstructorLines> constructors;  ///< in the order of their opening braces
  /// The last line at which a name is written as a key of a table, whatever table it is.
  std::map<std::string, int, std::less<>> last_key;
  /// The source with `{ ... }` written as `__place(ID, { ... })`, line by line the same; ID counts from the
  /// first id that was given. So every table tells at run time which constructor made it, however it
  /// travelled. The source as it was when it plays with _ENV, through which __place would be looked up.
  std::string marked;
};

/// @param source   Lua 5.4 that compiles
/// @param first_id of the first constructor
SourceMap map_source(std::string_view source, std::size_t first_id);

}  // namespace preshape::lua
