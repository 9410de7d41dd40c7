#include "host.h"

#include <algorithm>

#include <fmt/format.h>

#include "guard.h"
#include "sandbox.h"

namespace preshape::lua {

namespace {

constexpr char kAnchors[static_cast<std::size_t>(Anchor::kCount)] = {};

/// Lua shows a chunk's name with at most 59 characters: "..." and its end.
constexpr std::size_t kShownName = LUA_IDSIZE - 1, kShownEnd = LUA_IDSIZE - 4;

/// Puts the full names of files where Lua has cut them.
void restore_long_names(const Host& host, std::string& text) {
  for (const auto& name : host.long_names) {
    const std::string cut = "..." + name.substr(name.size() - kShownEnd) + ":";
    for (std::size_t at = text.find(cut); at != std::string::npos; at = text.find(cut, at + name.size())) {
      text.replace(at, cut.size(), name + ":");
    }
  }
}

/// What a value that was raised as an error says.
void push_error_text(lua_State* L, int index) {
  if (luaL_callmeta(L, index, "__tostring") && lua_type(L, -1) == LUA_TSTRING) return;
  if (lua_type(L, index) == LUA_TSTRING || lua_type(L, index) == LUA_TNUMBER) {
    luaL_tolstring(L, index, nullptr);
  } else {
    lua_pushfstring(L, "the error is a %s instead of a text", luaL_typename(L, index));
  }
}

/// Told each error where it arises: notes the way there and gives the message its place.
int on_error(lua_State* L) {
  push_error_text(L, 1);
  luaL_traceback(L, L, nullptr, 1);
  return guard(L, [&] {
    Host& host = host_of(L);
    host.traceback = lua_tostring(L, -1);
    restore_long_names(host, host.traceback);
    std::string message = lua_tostring(L, -2);
    restore_long_names(host, message);
    message = placed(L, message);
    lua_pushlstring(L, message.data(), message.size());
    return 1;
  });
}

int run_body(lua_State* L) {
  const auto& body = *static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  return guard(L, [&] {
    body(L);
    return 0;
  });
}

/// The host's notes on who runs, back as they were at the end of the scope.
class Entry {
 public:
  explicit Entry(Host& host) : host_(host), running_(host.running) {
    if (host_.depth++ > 0) return;
    host_.traceback.clear();
    host_.memory.place[0] = '\0';
    host_.memory.deep = false;
    host_.instructions.start(host_.main);
  }
  ~Entry() {
    --host_.depth;
    host_.running = running_;
  }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;

 private:
  Host& host_;
  lua_State* running_;
};

}  // namespace

Host::Host(std::string source_text, std::string shown_name, ScriptOptions script_options)
    : text(std::move(source_text)), name(std::move(shown_name)), options(std::move(script_options)) {
  memory.limit = options.limits.memory_bytes;
  instructions.limit = options.limits.instructions;
  main = lua_newstate(&MemoryLimit::allocate, &memory);
  if (!main) throw ScriptError(fmt::format("{}: {}", name, memory.message()));
  running = memory.main = main;
  *static_cast<Host**>(lua_getextraspace(main)) = this;
  try {
    enter([](lua_State* L) { open_sandbox(L); });
  } catch (const Error&) {
    memory.main = nullptr;
    lua_close(main);
    throw;
  }
}

Host::~Host() {
  memory.main = nullptr;
  lua_close(main);
}

void Host::enter(const std::function<void(lua_State*)>& body) {
  const Entry entry(*this);
  lua_State* L = running;
  if (!lua_checkstack(L, 4)) throw ScriptError(fmt::format("{}: calls go too deep", name));
  const int top = lua_gettop(L);
  // Nothing here allocates before the protected call.
  lua_pushcfunction(L, &on_error);
  lua_pushcfunction(L, &run_body);
  lua_pushlightuserdata(L, const_cast<void*>(static_cast<const void*>(&body)));
  const int status = lua_pcall(L, 1, 0, top + 1);
  const std::string failed = status == LUA_OK && !instructions.stopped ? "" : failure(L, status);
  lua_settop(L, top);
  if (!failed.empty()) throw ScriptError(failed);
}

std::string Host::failure(lua_State* L, int status) {
  if (instructions.stopped) return instructions.message;
  const char* told = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : nullptr;
  // A memory error that went through `pcall` and `error` is a text like another.
  if (status == LUA_ERRMEM || (told && std::string_view(told).ends_with("not enough memory"))) {
    return memory.place[0] ? memory.message() : fmt::format("{}: {}", name, memory.message());
  }
  if (status == LUA_ERRERR) return fmt::format("{}: an error arose while an error was handled", name);
  return told && *told ? told : fmt::format("{}: failed without a message", name);
}

void Host::load(lua_State* L, std::string_view source, const std::string& shown_name) {
  if (source.starts_with("\xEF\xBB\xBF")) source.remove_prefix(3);
  // "#!": the first line is not Lua; its end stays, so that the lines keep their numbers.
  if (source.starts_with("#")) source.remove_prefix(std::min(source.find('\n'), source.size()));
  if (shown_name.size() > kShownName) long_names.push_back(shown_name);
  const std::string chunk = "@" + shown_name;
  const auto compile = [&](std::string_view lua) {
    return luaL_loadbufferx(L, lua.data(), lua.size(), chunk.c_str(), "t");
  };
  // First as written, for the messages; then marked, unless that goes beyond what Lua can nest.
  if (compile(source) != LUA_OK) {
    const std::string fault = lua_tostring(L, -1);
    throw ScriptError(has_place(fault) ? fault : fmt::format("{}: {}", shown_name, fault));
  }
  if (!keeps_places) return;
  if (compile(places.add_source(shown_name, source)) == LUA_OK) {
    lua_remove(L, -2);
  } else {
    lua_pop(L, 1);
  }
}

void push_anchor(lua_State* L, Anchor anchor) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &kAnchors[static_cast<std::size_t>(anchor)]);
}

void set_anchor(lua_State* L, Anchor anchor) {
  lua_rawsetp(L, LUA_REGISTRYINDEX, &kAnchors[static_cast<std::size_t>(anchor)]);
}

}  // namespace preshape::lua
