#pragma once

#include <string>
#include <string_view>

#include <lua.hpp>

#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape::lua {

/// The innermost call that has a line of Lua; a function called by `pcall` has C around it. False when no Lua
/// runs.
bool innermost_line(lua_State* L, lua_Debug& call);
/// The file as messages show it, or what stands for it.
const char* source_name(const lua_Debug& call);
SourcePlace innermost_place(lua_State* L);

/// "file:line: " at the begin of a message?
bool has_place(std::string_view message);
/// The message with the innermost place in front, unless it has one.
std::string placed(lua_State* L, std::string_view message);

/// Keeps the message in the host, outside the C stack, for `raise_kept`.
void keep_message(lua_State* L, std::string_view message);
int raise_kept(lua_State* L);

/// The body of every function that Lua calls and that has C++ in it. An exception becomes a Lua error after
/// its handler has finished and every object of the body is gone. Not catch (...): Lua's C++ build throws its
/// own errors through here.
template <class Body>
int guard(lua_State* L, Body&& body) {
  try {
    return body();
  } catch (const std::exception& error) {
    keep_message(L, error.what());
  }
  return raise_kept(L);
}

/// The string at `index`, read without a conversion in place. @throws ScriptError "<owner>: expected string,
/// got nil"
std::string_view text_argument(lua_State* L, int index, std::string_view owner);

}  // namespace preshape::lua
