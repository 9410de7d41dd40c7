#include <string>

#include "guard.h"
#include "host.h"
#include "sandbox.h"

// Lua runs some code with its hooks switched off, where the instruction limit cannot see it: finalizers; and,
// when a hook raised the error, as the limit does, the handler of `xpcall` and the closing of what a dead
// coroutine left open. Each of these would be a way to loop for ever.

namespace preshape::lua {

namespace {

/// Without finalizers.
int set_metatable(lua_State* L) {
  guard(L, [L] {
    if (!lua_istable(L, 2)) return 0;
    lua_pushliteral(L, "__gc");
    if (lua_rawget(L, 2) != LUA_TNIL) throw ScriptError("setmetatable: '__gc' is not there for scripts");
    lua_pop(L, 1);
    return 0;
  });
  return call_original(L);
}

/// The handler that a script gave, its upvalue; passed over once the script is stopped.
int handle_error(lua_State* L) {
  if (host_of(L).instructions.stopped) return 1;
  return call_original(L);
}

int call_with_handler(lua_State* L) {
  if (lua_isfunction(L, 2)) {
    lua_pushvalue(L, 2);
    lua_pushcclosure(L, &handle_error, 1);
    lua_replace(L, 2);
  }
  return call_original(L);
}

/// Did the limit stop the script inside this coroutine? Then its hooks stay off.
bool was_stopped(lua_State* coroutine) {
  return lua_gethookcount(coroutine) == 1;
}

/// A coroutine is charged beforehand for what it may run until its own count is first told.
int create(lua_State* L) {
  host_of(L).instructions.used += InstructionLimit::kPeriod;
  return call_original(L);
}

int close(lua_State* L) {
  guard(L, [L] {
    lua_State* const coroutine = lua_tothread(L, 1);
    if (coroutine && was_stopped(coroutine)) throw ScriptError("coroutine.close: the coroutine was stopped");
    return 0;
  });
  return call_original(L);
}

/// What `coroutine.wrap` gives; the upvalue is the coroutine. As Lua's own but for the closing of a stopped
/// one, and an error keeps the one place that it has.
int resume_wrapped(lua_State* L) {
  lua_State* const coroutine = lua_tothread(L, lua_upvalueindex(1));
  const int count = lua_gettop(L);
  if (!lua_checkstack(coroutine, count)) return luaL_error(L, "too many arguments to resume");
  lua_xmove(L, coroutine, count);
  int results = 0;
  const int status = lua_resume(coroutine, L, count, &results);
  if (status == LUA_OK || status == LUA_YIELD) {
    if (!lua_checkstack(L, results + 1)) return luaL_error(L, "too many results to resume");
    lua_xmove(coroutine, L, results);
    return results;
  }
  const int rests = lua_status(coroutine);
  if (rests != LUA_OK && rests != LUA_YIELD && !was_stopped(coroutine)) lua_resetthread(coroutine);
  lua_xmove(coroutine, L, 1);
  return lua_error(L);
}

/// Lua's own, the upvalue, is `coroutine.create` here.
int wrap(lua_State* L) {
  create(L);
  lua_pushcclosure(L, &resume_wrapped, 1);
  return 1;
}

constexpr Replacement kReplacements[] = {{"_G", "setmetatable", &set_metatable},
                                         {"_G", "xpcall", &call_with_handler},
                                         {"coroutine", "close", &close},
                                         {"coroutine", "create", &create},
                                         {"coroutine", "wrap", &wrap}};

}  // namespace

void make_stoppable(lua_State* L, const char* library) {
  if (std::string_view(library) == "coroutine") {
    lua_getfield(L, -1, "create");
    lua_setfield(L, -2, "wrap");
  }
  replace(L, library, kReplacements);
}

}  // namespace preshape::lua
