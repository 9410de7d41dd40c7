#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <lua.hpp>

#include "limits.h"
#include "place_book.h"
#include "preshape/script/script.h"

namespace preshape::lua {

/// Everything behind one Script: the Lua state and what the functions that Lua calls need. Their rules: read
/// arguments with lua_to* (never luaL_check*), let C++ exceptions end in `guard`, keep no C++ object alive
/// across lua_error, never catch (...).
struct Host {
  Host(std::string source_text, std::string shown_name, ScriptOptions script_options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Runs `body` protected in the state, with fresh limits when it is entered from outside.
  /// @throws ScriptError for whatever goes wrong inside
  void enter(const std::function<void(lua_State*)>& body);

  /// Compiles a file's text onto the stack, its tables marked with their places. A fault is a Lua error.
  void load(lua_State* L, std::string_view source, const std::string& shown_name);

  std::string text;
  std::string name;
  ScriptOptions options;
  std::vector<std::filesystem::path> module_roots;  ///< the script's own folder first

  MemoryLimit memory;
  InstructionLimit instructions;
  PlaceBook places;
  std::deque<HostFunction> functions;
  std::vector<HostRecord> records;
  std::vector<std::string> long_names;  ///< of files, longer than Lua shows them
  bool keeps_places = true;             ///< of tables; without, what is loaded makes tables at Lua's own speed

  std::string message;    ///< of the error that is about to be raised
  std::string traceback;  ///< of the last error
  lua_State* main = nullptr;
  lua_State* running = nullptr;  ///< the main state, or the coroutine that called into C++
  int depth = 0;                 ///< of `enter`

 private:
  std::string failure(lua_State* L, int status);
};

/// The host of a state or of one of its coroutines.
inline Host& host_of(lua_State* L) {
  return **static_cast<Host**>(lua_getextraspace(L));
}

/// Where things are kept in the registry.
enum class Anchor { kPages, kFunctions, kFunctionNumbers, kModules, kPreshape, kCount };
void push_anchor(lua_State* L, Anchor anchor);
/// Takes the value off the stack.
void set_anchor(lua_State* L, Anchor anchor);

}  // namespace preshape::lua
