#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <lua.hpp>

namespace preshape::lua {

/// The memory of one state, and where in the script it last ran out.
struct MemoryLimit {
  std::size_t limit = 0;  ///< 0: none
  std::size_t used = 0;
  lua_State* main = nullptr;
  std::array<char, 512> place{};  ///< "file:line: " or ""; fixed, for it is filled where nothing may fail
  bool deep = false;              ///< so many calls were open then that a recursion is likely the reason

  /// A lua_Alloc; `self` is a MemoryLimit.
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  /// "scenario.lua:7: needs more than 64 MiB"
  std::string message() const;
};

/// The instructions of one state, all its coroutines together. A count hook adds them up. Once they are used
/// up the script is stopped for good: every instruction that any coroutine still tries raises the error
/// again, so that no loop around `pcall` outlives it.
struct InstructionLimit {
  static constexpr int kPeriod = 100;  ///< of the hook; what a new coroutine is charged beforehand

  std::int64_t limit = 0;  ///< 0: none
  std::int64_t used = 0;
  bool stopped = false;
  std::string message;  ///< "scenario.lua:7: stopped after 200000000 instructions (an endless loop?)"

  /// Counts anew.
  void start(lua_State* L);
  /// A lua_Hook.
  static void count(lua_State* L, lua_Debug*);
};

}  // namespace preshape::lua
