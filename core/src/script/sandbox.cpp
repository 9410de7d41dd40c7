#include "sandbox.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "guard.h"
#include "host.h"
#include "preshape/base/suggest.h"

namespace preshape::lua {

namespace {

struct Library {
  const char* name;
  lua_CFunction open;
};

constexpr Library kLibraries[] = {{"coroutine", luaopen_coroutine},
                                  {"math", luaopen_math},
                                  {"string", luaopen_string},
                                  {"table", luaopen_table},
                                  {"utf8", luaopen_utf8}};
constexpr Library kTrustedLibraries[] = {
    {"io", luaopen_io}, {"os", luaopen_os}, {"package", luaopen_package}};

/// Lua's base functions that are safe as they are, and those of which a safe form is made.
constexpr const char* kBase[] = {"_VERSION",     "assert", "collectgarbage", "error",    "getmetatable",
                                 "ipairs",       "load",   "pcall",          "rawequal", "rawget",
                                 "rawlen",       "rawset", "select",         "tonumber", "type",
                                 "setmetatable", "xpcall"};

/// The names in the table at `index`, sorted; our own marks left out.
std::vector<std::string> names_in(lua_State* L, int index) {
  std::vector<std::string> names;
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING) continue;
    std::string name = lua_tostring(L, -2);
    if (!name.starts_with("__")) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string unknown_global(const std::string& name, const std::vector<std::string>& names) {
  for (const auto& library : kTrustedLibraries) {
    if (name == library.name)
      return fmt::format("'{}' is not there unless the script is trusted (--trust)", name);
  }
  for (const char* left_out : {"debug", "dofile", "loadfile", "warn"}) {
    if (name == left_out) return fmt::format("'{}' is not there for scripts", name);
  }
  const std::string near = nearest_name(name, names);
  if (!near.empty()) return fmt::format("unknown global '{}'; did you mean '{}'?", name, near);
  return fmt::format("unknown global '{}'; a variable is made with 'local'", name);
}

/// __index of a sealed table: (table, key), reached when the table has no such key.
int unknown_name(lua_State* L) {
  return guard(L, [L]() -> int {
    const std::string owner = lua_tostring(L, lua_upvalueindex(1));
    if (lua_type(L, 2) != LUA_TSTRING) throw ScriptError(fmt::format("{}: names are texts", owner));
    const std::string name = lua_tostring(L, 2);
    const auto names = names_in(L, 1);
    if (owner == "_G") throw ScriptError(unknown_global(name, names));
    throw ScriptError(fmt::format("{}: unknown name '{}'{}", owner, name, did_you_mean(name, names)));
  });
}

/// __newindex of what scripts see of a sealed table: (view, key, value).
int read_only(lua_State* L) {
  return guard(L, [L]() -> int {
    const std::string owner = lua_tostring(L, lua_upvalueindex(1));
    const std::string name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    if (owner == "_G") throw ScriptError(fmt::format("global '{0}' cannot be set; write 'local {0}'", name));
    throw ScriptError(fmt::format("{}: '{}' cannot be set, the module is read-only", owner, name));
  });
}

/// __pairs of what scripts see: the pairs of the table behind it.
int pairs_behind(lua_State* L) {
  lua_settop(L, 0);
  lua_pushvalue(L, lua_upvalueindex(1));
  return sorted_pairs(L);
}

/// Marks a table with its page: __place(page, table) returns the table. Written by `map_source`, on every
/// `{}`.
int mark_place(lua_State* L) {
  if (lua_istable(L, 2)) {
    lua_pushvalue(L, 2);
    lua_pushvalue(L, 1);
    lua_rawset(L, lua_upvalueindex(1));
  }
  lua_settop(L, 2);
  return 1;
}

void open_anchors(lua_State* L) {
  for (const auto anchor : {Anchor::kFunctions, Anchor::kFunctionNumbers, Anchor::kModules}) {
    lua_newtable(L);
    set_anchor(L, anchor);
  }
  lua_newtable(L);  // pages of tables: gone when the table is
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "k");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  set_anchor(L, Anchor::kPages);
}

/// Pushes a copy of the table at the top: messages of Lua look the names of its functions up in the original.
void push_copy(lua_State* L) {
  lua_newtable(L);
  for (lua_pushnil(L); lua_next(L, -3) != 0;) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -4);
  }
}

/// The methods of strings, without a way to change them for everybody.
void protect_string_methods(lua_State* L, int library) {
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_pushvalue(L, library);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 2);
}

/// Into the table of globals at the top.
void open_libraries(lua_State* L) {
  for (const auto& library : kLibraries) {
    luaL_requiref(L, library.name, library.open, 0);
    push_copy(L);
    make_repeatable(L, library.name);
    make_stoppable(L, library.name);
    if (library.open == luaopen_string) protect_string_methods(L, lua_gettop(L));
    seal(L, library.name);
    lua_remove(L, -2);
    push_anchor(L, Anchor::kModules);
    lua_pushvalue(L, -2);
    lua_setfield(L, -2, library.name);
    lua_pop(L, 1);
    lua_setfield(L, -2, library.name);
  }
}

/// Into the table of globals at the top; leaves the stock `require`, or nil, above it.
void open_trusted(lua_State* L, bool trust) {
  if (!trust) return lua_pushnil(L);
  for (const auto& library : kTrustedLibraries) {
    luaL_requiref(L, library.name, library.open, 0);
    lua_setfield(L, -2, library.name);
  }
  lua_getglobal(L, "require");
}

/// The module `preshape`: the table behind it stays within reach of `add_function`.
void open_preshape(lua_State* L) {
  lua_newtable(L);
  lua_pushvalue(L, -1);
  set_anchor(L, Anchor::kPreshape);
  seal(L, "preshape");
  push_anchor(L, Anchor::kModules);
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, "preshape");
  lua_pop(L, 1);
  lua_setfield(L, -2, "preshape");
}

}  // namespace

void seal(lua_State* L, const char* name) {
  const auto set_closure = [L, name](const char* field, lua_CFunction function) {
    lua_pushstring(L, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, -2, field);
  };
  const int table = lua_gettop(L);
  lua_createtable(L, 0, 1);
  set_closure("__index", &unknown_name);
  lua_setmetatable(L, table);
  lua_newtable(L);  // what scripts see
  lua_createtable(L, 0, 5);
  lua_pushvalue(L, table);
  lua_setfield(L, -2, "__index");
  set_closure("__newindex", &read_only);
  lua_pushvalue(L, table);
  lua_pushcclosure(L, &pairs_behind, 1);
  lua_setfield(L, -2, "__pairs");
  lua_pushstring(L, name);
  lua_setfield(L, -2, "__name");
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_remove(L, table);
}

void open_sandbox(lua_State* L) {
  open_anchors(L);
  luaL_requiref(L, "_G", luaopen_base, 1);
  lua_newtable(L);  // the globals of scripts
  for (const char* name : kBase) {
    lua_getfield(L, -2, name);
    lua_setfield(L, -2, name);
  }
  make_repeatable(L, "_G");
  make_stoppable(L, "_G");
  open_libraries(L);
  open_trusted(L, host_of(L).options.trust);
  lua_pushcclosure(L, &require_module, 1);
  lua_setfield(L, -2, "require");
  open_preshape(L);
  push_anchor(L, Anchor::kPages);
  lua_pushcclosure(L, &mark_place, 1);
  lua_setfield(L, -2, "__place");
  const int globals = lua_gettop(L);
  lua_pushvalue(L, globals);
  seal(L, "_G");
  lua_pushvalue(L, -1);
  lua_setfield(L, globals, "_G");
  // What every chunk that is compiled from now on has as its _ENV.
  lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
  lua_settop(L, 0);
}

}  // namespace preshape::lua
