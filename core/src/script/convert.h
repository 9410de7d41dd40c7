#pragma once

#include <lua.hpp>

#include "preshape/base/value.h"

namespace preshape::lua {

/// The Lua value at `index` as data, by the rules that `Script` documents.
/// @param place where it stands, as far as the caller knows; a table that knows better says so
/// @throws ScriptError that names the place
Value to_value(lua_State* L, int index, const SourcePlace& place);

/// Pushes the value; tables made from it still know the places of their entries.
void push_value(lua_State* L, const Value& value);

/// Makes the table at the top of the stack one of those whose entries stand on that page of the place book.
void set_page(lua_State* L, long page);

}  // namespace preshape::lua
