#include <algorithm>
#include <string_view>
#include <vector>

#include "guard.h"
#include "sandbox.h"

namespace preshape::lua {

namespace {

/// A key of a table by which it is ordered. Points into the Lua state.
struct Key {
  enum class Kind { kNumber, kText, kBoolean, kOther } kind = Kind::kOther;
  long double number = 0;  ///< holds every integer and every float
  std::string_view text;
  lua_Integer position = 0;  ///< in the list of keys

  bool operator<(const Key& other) const {
    if (kind != other.kind) return kind < other.kind;
    return kind == Kind::kText ? text < other.text : number < other.number;
  }
};

Key key_at(lua_State* L, int index) {
  Key key;
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      key.kind = Key::Kind::kNumber;
      key.number = lua_isinteger(L, index) ? static_cast<long double>(lua_tointeger(L, index))
                                           : static_cast<long double>(lua_tonumber(L, index));
      break;
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(L, index, &size);
      key.kind = Key::Kind::kText;
      key.text = {text, size};
      break;
    }
    case LUA_TBOOLEAN:
      key.kind = Key::Kind::kBoolean;
      key.number = lua_toboolean(L, index);
      break;
    default:
      break;
  }
  return key;
}

void demand_table(lua_State* L, const char* owner) {
  if (lua_istable(L, 1)) return;
  throw ScriptError(std::string(owner) + ": expected table, got " + luaL_typename(L, 1));
}

/// Counts the keys that have no order; one is no harm.
class OtherKeys {
 public:
  void see(const Key& key) {
    if (key.kind == Key::Kind::kOther && ++count_ > 1) {
      throw ScriptError(
          "pairs: keys that are tables or functions have no order; go through a list of them instead");
    }
  }

 private:
  int count_ = 0;
};

/// Pushes the keys of the table at 1 as a list, sorted.
void push_sorted_keys(lua_State* L) {
  std::vector<Key> keys;
  OtherKeys others;
  lua_newtable(L);  // keeps the keys alive, unsorted
  const int found = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    keys.push_back(key_at(L, -2));
    others.see(keys.back());
    keys.back().position = static_cast<lua_Integer>(keys.size());
    lua_pushvalue(L, -2);
    lua_rawseti(L, found, keys.back().position);
  }
  std::sort(keys.begin(), keys.end());
  lua_createtable(L, static_cast<int>(keys.size()), 0);
  lua_Integer i = 0;
  for (const auto& key : keys) {
    lua_rawgeti(L, found, key.position);
    lua_rawseti(L, -2, ++i);
  }
  lua_remove(L, found);
}

/// The iterator: upvalues are the table, its sorted keys, and how many were given out.
int next_pair(lua_State* L) {
  lua_Integer position = lua_tointeger(L, lua_upvalueindex(3));
  lua_settop(L, 0);
  for (;;) {
    if (lua_rawgeti(L, lua_upvalueindex(2), ++position) == LUA_TNIL) return 1;
    lua_pushvalue(L, 1);
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) break;
    lua_settop(L, 0);  // taken away meanwhile
  }
  lua_pushinteger(L, position);
  lua_replace(L, lua_upvalueindex(3));
  return 2;
}

}  // namespace

int sorted_pairs(lua_State* L) {
  lua_settop(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_insert(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  return guard(L, [L] {
    demand_table(L, "pairs");
    lua_pushvalue(L, 1);
    push_sorted_keys(L);
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, &next_pair, 3);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
  });
}

int sorted_next(lua_State* L) {
  return guard(L, [L] {
    lua_settop(L, 2);
    demand_table(L, "next");
    const bool first = lua_isnil(L, 2);
    const Key from = key_at(L, 2);
    lua_pushnil(L);  // 3: the best so far
    Key best;
    OtherKeys others;
    for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
      const Key key = key_at(L, -2);
      others.see(key);
      if ((!first && !(from < key)) || (!lua_isnil(L, 3) && !(key < best))) continue;
      best = key;
      lua_pushvalue(L, -2);
      lua_replace(L, 3);
    }
    if (lua_isnil(L, 3)) return 1;
    lua_pushvalue(L, 3);
    lua_rawget(L, 1);
    return 2;
  });
}

}  // namespace preshape::lua
