#include "guard.h"

#include <cctype>

#include <fmt/format.h>

#include "host.h"

namespace preshape::lua {

bool innermost_line(lua_State* L, lua_Debug& call) {
  for (int level = 0; lua_getstack(L, level, &call); ++level) {
    lua_getinfo(L, "Sl", &call);
    if (call.currentline > 0) return true;
  }
  return false;
}

const char* source_name(const lua_Debug& call) {
  return call.source[0] == '@' || call.source[0] == '=' ? call.source + 1 : call.short_src;
}

SourcePlace innermost_place(lua_State* L) {
  lua_Debug call;
  if (!innermost_line(L, call)) return {};
  return {source_name(call), call.currentline};
}

bool has_place(std::string_view message) {
  // A file name, which has a dot, or a chunk without one; then ":<digits>: ".
  for (std::size_t colon = message.find(':'); colon != std::string_view::npos;
       colon = message.find(':', colon + 1)) {
    std::size_t end = colon + 1;
    while (end < message.size() && std::isdigit(static_cast<unsigned char>(message[end]))) ++end;
    if (end == colon + 1 || message.substr(end, 2) != ": ") continue;
    const std::string_view file = message.substr(0, colon);
    return file.starts_with("[string \"") || (file.find('.') != file.npos && file.find(": ") == file.npos);
  }
  return false;
}

std::string placed(lua_State* L, std::string_view message) {
  const SourcePlace place = innermost_place(L);
  if (!place.known() || has_place(message) || message.starts_with(place.file + ":"))
    return std::string(message);
  return fmt::format("{}: {}", place.text(), message);
}

void keep_message(lua_State* L, std::string_view message) {
  host_of(L).message = placed(L, message);
}

int raise_kept(lua_State* L) {
  const std::string& message = host_of(L).message;
  lua_pushlstring(L, message.data(), message.size());
  return lua_error(L);
}

std::string_view text_argument(lua_State* L, int index, std::string_view owner) {
  if (lua_type(L, index) != LUA_TSTRING) {
    throw ScriptError(fmt::format("{}: expected string, got {}", owner, luaL_typename(L, index)));
  }
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  return {text, size};
}

}  // namespace preshape::lua
