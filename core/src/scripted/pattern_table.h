#pragma once

#include <lua.hpp>

#include "preshape/fuzzy/pattern.h"

namespace preshape::scripted {

/// One pattern as a script sees it: { crisp = {6 numbers}, [1..6] = {memberships} }, or six components, each
/// { crisp = number, [1..sets] = membership }. Lives on the stack, refilled for each pattern.
class PatternTable {
 public:
  /// Leaves eight tables on the stack.
  PatternTable(lua_State* L, int sets);

  /// @param only the component beside which everything is 0; -1: all stand as they are
  void fill(const PatternView& view, int only = -1) const;
  void fill_component(const PatternView& view, std::size_t k) const;

  void push_whole() const { lua_pushvalue(L_, whole_); }
  void push_component(std::size_t k) const { lua_pushvalue(L_, component(k)); }

 private:
  int component(std::size_t k) const { return whole_ + 2 + static_cast<int>(k); }

  lua_State* L_;
  std::size_t sets_;
  int whole_;
};

}  // namespace preshape::scripted
