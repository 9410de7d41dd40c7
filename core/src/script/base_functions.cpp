#include <cstdio>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "guard.h"
#include "host.h"
#include "sandbox.h"

namespace preshape::lua {

namespace {

/// What `tostring` gives: as Lua, but "table" instead of a table's address, which is another in every run.
void push_text(lua_State* L, int index) {
  if (luaL_callmeta(L, index, "__tostring")) return;
  switch (lua_type(L, index)) {
    case LUA_TNIL:
    case LUA_TBOOLEAN:
    case LUA_TNUMBER:
    case LUA_TSTRING:
      luaL_tolstring(L, index, nullptr);
      return;
    default:
      if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) return;
      lua_pushstring(L, luaL_typename(L, index));
  }
}

int to_text(lua_State* L) {
  lua_settop(L, 1);
  push_text(L, 1);
  return 1;
}

int print(lua_State* L) {
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    push_text(L, i);
    lua_replace(L, i);
  }
  return guard(L, [L, count] {
    std::string line;
    for (int i = 1; i <= count; ++i) line.append(i > 1 ? "\t" : "").append(text_argument(L, i, "print"));
    if (const auto& sink = host_of(L).options.print) {
      sink(line);
    } else {
      line += '\n';
      std::fwrite(line.data(), 1, line.size(), stdout);
    }
    return 0;
  });
}

/// Text only: byte code is not checked by Lua and can do anything.
int load_text(lua_State* L) {
  const bool has_environment = !lua_isnone(L, 4);
  lua_settop(L, has_environment ? 4 : 3);
  lua_pushliteral(L, "t");
  lua_replace(L, 3);
  return call_original(L);
}

int collect_garbage(lua_State* L) {
  guard(L, [L] {
    const auto option = lua_isnoneornil(L, 1) ? "collect" : text_argument(L, 1, "collectgarbage");
    if (option != "count")
      throw ScriptError(fmt::format("collectgarbage: only 'count' is there, got '{}'", option));
    return 0;
  });
  return call_original(L);
}

/// Not for sealed tables.
int raw_set(lua_State* L) {
  guard(L, [L] {
    if (!luaL_getmetafield(L, 1, "__metatable")) return 0;
    if (lua_isboolean(L, -1)) throw ScriptError("rawset: the table is read-only");
    lua_pop(L, 1);
    return 0;
  });
  return call_original(L);
}

/// string.format, with texts instead of addresses for "%s".
int format(lua_State* L) {
  int argument = 1;
  const char* at = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : "";
  while ((at = std::strchr(at, '%')) != nullptr) {
    at += 1 + std::strspn(at + 1, "-+ #0123456789.");
    if (*at == '\0') break;
    if (*at == '%') {
      ++at;
      continue;
    }
    ++argument;
    if (*at == 'p') {
      return guard(L, []() -> int {
        throw ScriptError("string.format: '%p' is not there, an address is new in every run");
      });
    }
    if (*at == 's' && argument <= lua_gettop(L) && lua_type(L, argument) >= LUA_TTABLE) {
      push_text(L, argument);
      lua_replace(L, argument);
    }
  }
  return call_original(L);
}

/// Only with a seed: the stock one without takes the time.
int random_seed(lua_State* L) {
  guard(L, [L] {
    if (lua_isnone(L, 1)) throw ScriptError("math.randomseed: expected a seed, the same for every run");
    return 0;
  });
  call_original(L);
  return 0;
}

constexpr Replacement kReplacements[] = {{"_G", "collectgarbage", &collect_garbage},
                                         {"_G", "load", &load_text},
                                         {"_G", "next", &sorted_next},
                                         {"_G", "pairs", &sorted_pairs},
                                         {"_G", "print", &print},
                                         {"_G", "rawset", &raw_set},
                                         {"_G", "tostring", &to_text},
                                         {"math", "randomseed", &random_seed},
                                         {"string", "dump", nullptr},
                                         {"string", "format", &format}};

}  // namespace

int call_original(lua_State* L) {
  const int count = lua_gettop(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, count, LUA_MULTRET);
  return lua_gettop(L);
}

void replace(lua_State* L, const char* library, std::span<const Replacement> replacements) {
  for (const auto& replacement : replacements) {
    if (std::strcmp(replacement.library, library) != 0) continue;
    if (replacement.function) {
      lua_getfield(L, -1, replacement.name);
      lua_pushcclosure(L, replacement.function, 1);
    } else {
      lua_pushnil(L);
    }
    lua_setfield(L, -2, replacement.name);
  }
}

void make_repeatable(lua_State* L, const char* library) {
  if (std::strcmp(library, "math") == 0) {
    lua_getfield(L, -1, "randomseed");
    lua_pushinteger(L, static_cast<lua_Integer>(host_of(L).options.seed));
    lua_call(L, 1, 0);
  }
  replace(L, library, kReplacements);
}

}  // namespace preshape::lua
