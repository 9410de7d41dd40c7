#include "pattern_table.h"

#include "preshape/base/error.h"
#include "stack.h"

namespace preshape::scripted {

namespace {

constexpr auto kCount = static_cast<std::size_t>(kComponents);

}  // namespace

PatternTable::PatternTable(lua_State* L, int sets)
    : L_(L), sets_(static_cast<std::size_t>(sets)), whole_(lua_gettop(L) + 1) {
  if (!lua_checkstack(L, 20)) throw ScriptError("calls go too deep");
  lua_createtable(L, static_cast<int>(kCount), 1);
  lua_createtable(L, static_cast<int>(kCount), 0);
  for (std::size_t k = 0; k < kCount; ++k) lua_createtable(L, sets, 1);
}

void PatternTable::fill(const PatternView& view, int only) const {
  double crisp[kCount];
  for (std::size_t k = 0; k < kCount; ++k) {
    const bool shown = only < 0 || only == static_cast<int>(k);
    crisp[k] = shown ? view.crisp[k] : 0.0;
    for (std::size_t i = 0; i < sets_; ++i) {
      lua_pushnumber(L_, shown ? view.memberships[k * sets_ + i] : 0.0);
      lua_rawseti(L_, component(k), static_cast<lua_Integer>(i + 1));
    }
    lua_pushvalue(L_, component(k));
    lua_rawseti(L_, whole_, static_cast<lua_Integer>(k + 1));
  }
  refill(L_, whole_ + 1, crisp);
  lua_pushliteral(L_, "crisp");
  lua_pushvalue(L_, whole_ + 1);
  lua_rawset(L_, whole_);
}

void PatternTable::fill_component(const PatternView& view, std::size_t k) const {
  refill(L_, component(k), std::span(view.memberships + k * sets_, sets_));
  lua_pushliteral(L_, "crisp");
  lua_pushnumber(L_, view.crisp[k]);
  lua_rawset(L_, component(k));
}

}  // namespace preshape::scripted
