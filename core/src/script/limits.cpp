#include "limits.h"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "guard.h"
#include "host.h"

namespace preshape::lua {

namespace {

constexpr int kDeep = 10'000;  // open calls

}  // namespace

void* MemoryLimit::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  auto& memory = *static_cast<MemoryLimit*>(self);
  if (!block) old_size = 0;  // then it is a type's number
  if (new_size == 0) {
    memory.used -= old_size;
    std::free(block);
    return nullptr;
  }
  const bool grows = new_size > old_size;
  if (grows && memory.limit > 0 && memory.used - old_size + new_size > memory.limit) {
    // Lua tells nobody where memory ran out; it collects garbage and asks once more before it gives up.
    lua_Debug at;
    if (memory.main && innermost_line(memory.main, at)) {
      std::snprintf(memory.place.data(), memory.place.size(), "%s:%d: ", source_name(at), at.currentline);
      memory.deep = lua_getstack(memory.main, kDeep, &at) != 0;
    }
    return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  if (moved) memory.used += new_size - old_size;
  return moved;
}

std::string MemoryLimit::message() const {
  const bool small = limit < (1 << 20);
  return fmt::format("{}needs more than {:.4g} {}{}", place.data(),
                     static_cast<double>(limit) / (small ? 1 << 10 : 1 << 20), small ? "KiB" : "MiB",
                     deep ? " (an endless recursion?)" : "");
}

void InstructionLimit::start(lua_State* L) {
  used = 0;
  stopped = false;
  if (limit > 0) lua_sethook(L, &count, LUA_MASKCOUNT, kPeriod);
}

void InstructionLimit::count(lua_State* L, lua_Debug*) {
  auto& budget = host_of(L).instructions;
  budget.used += lua_gethookcount(L);
  if (budget.used <= budget.limit) return;
  lua_sethook(L, &count, LUA_MASKCOUNT, 1);
  guard(L, [&]() -> int {
    if (!budget.stopped) {
      budget.stopped = true;
      budget.message =
          placed(L, fmt::format("stopped after {} instructions (an endless loop?)", budget.limit));
    }
    throw ScriptError(budget.message);
  });
}

}  // namespace preshape::lua
