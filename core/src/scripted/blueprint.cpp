#include "blueprint.h"

#include <cstdio>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "script/convert.h"
#include "script/guard.h"
#include "script/modules.h"

namespace preshape::scripted {

namespace {

/// A component does not write into the output of whoever uses it.
void print_aside(const std::string& file, std::string_view line) {
  fmt::print(stderr, "{}: {}\n", file, line);
}

bool holds_function(const Value& value) {
  if (value.is_list()) {
    for (const Value& item : value.items()) {
      if (holds_function(item)) return true;
    }
  } else if (value.is_table()) {
    for (const auto& [key, entry] : value.entries()) {
      if (holds_function(entry)) return true;
    }
  }
  return value.is_function();
}

}  // namespace

ComponentSource ComponentSource::read(const std::filesystem::path& file,
                                      std::vector<std::filesystem::path> module_roots) {
  module_roots.insert(module_roots.begin(), file.has_parent_path() ? file.parent_path() : ".");
  return {file, lua::read_text(file, "component"), lua::shown_name(file), std::move(module_roots)};
}

std::unique_ptr<lua::Host> open_host(const ComponentSource& source, bool keeps_places) {
  ScriptOptions options;
  options.print = [file = source.shown](std::string_view line) { print_aside(file, line); };
  auto host = std::make_unique<lua::Host>("", source.shown, std::move(options));
  host->module_roots = source.module_roots;
  host->keeps_places = keeps_places;
  return host;
}

void push_component(lua_State* L, const ComponentSource& source) {
  lua::host_of(L).load(L, source.text, source.shown);
  lua_call(L, 0, 1);
  if (lua_istable(L, -1)) return;
  throw ScriptError(fmt::format("{}: a component's file returns its declaration, a table, got {}",
                                source.shown, luaL_typename(L, -1)));
}

std::string Blueprint::owner() const {
  return fmt::format("{} '{}'", kind, name);
}

SourcePlace push_instance(lua_State* L, const Blueprint& blueprint) {
  push_component(L, blueprint.source);
  lua_pushliteral(L, "new");
  if (lua_rawget(L, -2) != LUA_TFUNCTION) {
    throw ScriptError(fmt::format("{}: 'new' is no function any more", blueprint.source.shown));
  }
  lua_remove(L, -2);
  const SourcePlace place = definition(L, -1);
  for (const auto& [name, value] : blueprint.parameters.values()) {
    if (holds_function(value)) throw InputError(fmt::format("'{}' holds a function; give data alone", name));
  }
  lua::push_value(L, Value::table(blueprint.parameters.values()));
  lua_call(L, 1, 1);
  if (!lua_istable(L, -1)) {
    throw ScriptError(
        fmt::format("{}: 'new' must return a table, got {}", place.text(), luaL_typename(L, -1)));
  }
  return place;
}

Value inspect(const Blueprint& blueprint) {
  const auto host = open_host(blueprint.source, true);
  Value instance;
  host->enter([&](lua_State* L) {
    const SourcePlace place = push_instance(L, blueprint);
    instance = lua::to_value(L, -1, place);
    if (!instance.place().known()) instance.at(place);
  });
  return instance;
}

SourcePlace definition(lua_State* L, int index) {
  lua_Debug function;
  lua_pushvalue(L, index);
  lua_getinfo(L, ">S", &function);
  return {lua::source_name(function), function.linedefined};
}

}  // namespace preshape::scripted
