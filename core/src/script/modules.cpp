#include "modules.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "guard.h"
#include "host.h"
#include "sandbox.h"

namespace preshape::lua {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path, const std::string& what) {
  const auto fail = [&](const char* why) {
    throw InputError(fmt::format("{} '{}' cannot be read ({})", what, path.string(), why));
  };
  if (fs::is_directory(path)) fail("it is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(std::strerror(errno));
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

std::string shown_name(const fs::path& path) {
  if (!path.is_absolute()) return path.lexically_normal().string();
  std::error_code ignored;
  const fs::path inside = path.lexically_relative(fs::current_path(ignored));
  return inside.empty() || *inside.begin() == ".." ? path.lexically_normal().string() : inside.string();
}

namespace {

/// A module of a folder that was not named by the person, such as an installed one: relative to that folder.
std::string shown_module(const fs::path& root, const fs::path& file) {
  const std::string shown = shown_name(root / file);
  return fs::path(shown).is_absolute() ? file.string() : shown;
}

/// "a.b" is letters, digits and '_' with single dots between: no way up or out.
bool is_module_name(std::string_view name) {
  const bool characters = std::all_of(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; });
  return characters && !name.empty() && name.front() != '.' && name.back() != '.' &&
         name.find("..") == name.npos;
}

/// The modules that are being required, outermost first: the first argument of each call of `require` that is
/// open. Read off the calls, so that nothing has to be taken back when one fails.
std::vector<std::string> open_requires(lua_State* L) {
  std::vector<std::string> names;
  lua_Debug call;
  for (int level = 1; lua_getstack(L, level, &call); ++level) {
    lua_getinfo(L, "f", &call);
    const bool is_require = lua_tocfunction(L, -1) == &require_module;
    lua_pop(L, 1);
    if (!is_require || !lua_getlocal(L, &call, 1)) continue;
    names.emplace(names.begin(), text_argument(L, -1, "require"));
    lua_pop(L, 1);
  }
  return names;
}

void refuse_circle(lua_State* L, const std::string& name) {
  auto names = open_requires(L);
  if (std::find(names.begin(), names.end(), name) == names.end()) return;
  names.push_back(name);
  throw ScriptError(
      fmt::format("require: the modules need each other in a circle ({})", fmt::join(names, " -> ")));
}

struct Found {
  std::string text;
  std::string shown;
  std::vector<std::string> tried;
};

Found find_module(const Host& host, std::string_view name) {
  std::string file(name);
  std::replace(file.begin(), file.end(), '.', '/');
  file += ".lua";
  Found found;
  for (const auto& root : host.module_roots) {
    if (fs::is_regular_file(root / file)) {
      found.shown = shown_module(root, file);
      found.text = read_text(root / file, "module");
      return found;
    }
    found.tried.push_back(shown_name(root / file));
  }
  return found;
}

/// Leaves the module's value at the top of the stack; false when no file has its name.
bool load_module(lua_State* L, const std::string& name) {
  Host& host = host_of(L);
  const Found found = find_module(host, name);
  if (found.shown.empty()) {
    if (!lua_isnil(L, lua_upvalueindex(1))) return false;
    throw ScriptError(
        found.tried.empty()
            ? fmt::format("require: module '{}' was not found; there is no folder to search", name)
            : fmt::format("require: module '{}' was not found; tried {}", name,
                          fmt::join(found.tried, ", ")));
  }
  refuse_circle(L, name);
  host.load(L, found.text, found.shown);
  lua_pushlstring(L, name.data(), name.size());
  lua_call(L, 1, 1);
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    lua_pushboolean(L, true);
  }
  push_anchor(L, Anchor::kModules);
  lua_pushvalue(L, -2);
  lua_setfield(L, -2, name.c_str());
  lua_pop(L, 1);
  return true;
}

}  // namespace

int require_module(lua_State* L) {
  bool done = false;
  guard(L, [&] {
    const std::string name(text_argument(L, 1, "require"));
    const bool stock = !lua_isnil(L, lua_upvalueindex(1));
    if (!is_module_name(name) && !stock) {
      throw ScriptError(fmt::format("require: '{}' is no module name (letters, digits, '_', and '.' between)",
                                    name.c_str()));
    }
    lua_settop(L, 1);
    push_anchor(L, Anchor::kModules);
    done = lua_getfield(L, -1, name.c_str()) != LUA_TNIL || (is_module_name(name) && load_module(L, name));
    return 0;
  });
  if (done) return 1;
  lua_settop(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

}  // namespace preshape::lua
