#pragma once

#include <span>

#include <lua.hpp>

namespace preshape::lua {

/// Fills a new state: the libraries that a script may use, sealed; the strict globals; our `require`,
/// `pairs`, `next`, `print`; the empty module `preshape`.
void open_sandbox(lua_State* L);

/// Takes the table of a module off the stack and pushes what scripts see of it: read-only, and an unknown
/// name is an error with the nearest right one. `name` is "preshape", "math", ...; "_G" for the globals.
void seal(lua_State* L, const char* name);

/// A function of Lua that scripts see in another form; Lua's own becomes its upvalue.
struct Replacement {
  const char* library;
  const char* name;
  lua_CFunction function;  ///< nullptr: taken away
};

/// Replaces those of `library` ("_G" for the base functions) in the table at the top of the stack.
void replace(lua_State* L, const char* library, std::span<const Replacement> replacements);
/// For the body of a replacement: Lua's own function with the arguments as they now are.
int call_original(lua_State* L);

/// Replaces what shows addresses, takes the time, or lets code in that is no text.
void make_repeatable(lua_State* L, const char* library);
/// Replaces what runs code out of reach of the instruction limit.
void make_stoppable(lua_State* L, const char* library);

/// `pairs` and `next` in sorted order: numbers, texts, false, true.
int sorted_pairs(lua_State* L);
int sorted_next(lua_State* L);

/// `require`; the stock one, or nil, is its upvalue.
int require_module(lua_State* L);

}  // namespace preshape::lua
