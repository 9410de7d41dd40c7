#include "convert.h"
#include "host.h"
#include "preshape/base/error.h"

namespace preshape::lua {

void set_page(lua_State* L, long page) {
  push_anchor(L, Anchor::kPages);
  lua_pushvalue(L, -2);
  lua_pushinteger(L, page);
  lua_rawset(L, -3);
  lua_pop(L, 1);
}

namespace {

void push_function(lua_State* L, Value::Function function) {
  push_anchor(L, Anchor::kFunctions);
  if (lua_rawgeti(L, -1, function.reference) != LUA_TFUNCTION) {
    throw ScriptError("the function belongs to another script");
  }
  lua_remove(L, -2);
}

void push_list(lua_State* L, const Value::List& items) {
  lua_createtable(L, static_cast<int>(items.size()), 0);
  lua_Integer i = 0;
  for (const auto& item : items) {
    push_value(L, item);
    lua_rawseti(L, -2, ++i);
  }
}

void push_table(lua_State* L, const Value::Table& entries) {
  lua_createtable(L, 0, static_cast<int>(entries.size()));
  for (const auto& [key, entry] : entries) {
    lua_pushlstring(L, key.data(), key.size());
    push_value(L, entry);
    lua_rawset(L, -3);
  }
}

}  // namespace

void push_value(lua_State* L, const Value& value) {
  if (!lua_checkstack(L, 8)) throw ScriptError("tables in tables too deep");
  if (value.is_nil()) return lua_pushnil(L);
  if (value.is_boolean()) return lua_pushboolean(L, value.boolean());
  if (value.is_function()) return push_function(L, value.function());
  if (value.is_string()) return void(lua_pushlstring(L, value.string().data(), value.string().size()));
  if (value.is_number()) {
    // 3.0 stays a float, as the host meant it.
    const bool whole = value.is_integer() && value == Value(value.integer());
    return whole ? lua_pushinteger(L, value.integer()) : lua_pushnumber(L, value.number());
  }
  value.is_list() ? push_list(L, value.items()) : push_table(L, value.entries());
  if (const long page = host_of(L).places.page_of(value); page >= 0) set_page(L, page);
}

}  // namespace preshape::lua
