#include "preshape/script/script.h"

#include <algorithm>

#include <fmt/format.h>

#include "convert.h"
#include "guard.h"
#include "host.h"
#include "modules.h"
#include "preshape/base/assert.h"

namespace preshape {

namespace lua {

namespace {

/// What Lua calls for every function of the module `preshape`; the upvalue is its number.
int call_host_function(lua_State* L) {
  return guard(L, [L] {
    Host& host = host_of(L);
    const SourcePlace caller = innermost_place(L);
    std::vector<Value> arguments;
    for (int i = 1; i <= lua_gettop(L); ++i) arguments.push_back(to_value(L, i, caller));
    lua_State* const before = std::exchange(host.running, L);
    const auto number = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(1)));
    // Left as it is when this throws: whoever calls into C++ next sets it, and `enter` puts it back at its
    // end.
    const Value result = host.functions[number](arguments, caller);
    host.running = before;
    push_value(L, result);
    return 1;
  });
}

}  // namespace

}  // namespace lua

namespace {

bool has_record(std::span<const HostRecord> records, const std::string& name) {
  return std::any_of(records.begin(), records.end(), [&](const auto& record) { return record.name == name; });
}

}  // namespace

Script::Script(std::unique_ptr<lua::Host> host) : host_(std::move(host)) {}

Script::Script(const std::filesystem::path& path, ScriptOptions options) {
  host_ =
      std::make_unique<lua::Host>(lua::read_text(path, "script"), lua::shown_name(path), std::move(options));
  auto& roots = host_->module_roots;
  roots = host_->options.module_roots;
  roots.insert(roots.begin(), path.has_parent_path() ? path.parent_path() : ".");
}

Script Script::from_text(std::string text, std::string name, ScriptOptions options) {
  auto host = std::make_unique<lua::Host>(std::move(text), std::move(name), std::move(options));
  host->module_roots = host->options.module_roots;
  return Script(std::move(host));
}

Script::Script(Script&&) noexcept = default;
Script& Script::operator=(Script&&) noexcept = default;
Script::~Script() = default;

void Script::add_function(std::string name, std::string signature, std::string text, HostFunction function) {
  PRESHAPE_DEMAND(!has_record(host_->records, name));
  const auto number = static_cast<lua_Integer>(host_->functions.size());
  host_->functions.push_back(std::move(function));
  host_->enter([&](lua_State* L) {
    lua::push_anchor(L, lua::Anchor::kPreshape);
    lua_pushinteger(L, number);
    lua_pushcclosure(L, &lua::call_host_function, 1);
    lua_setfield(L, -2, name.c_str());
  });
  host_->records.push_back({std::move(name), std::move(signature), std::move(text)});
}

void Script::add_constant(std::string name, std::string text, const Value& value) {
  PRESHAPE_DEMAND(!has_record(host_->records, name));
  host_->enter([&](lua_State* L) {
    lua::push_anchor(L, lua::Anchor::kPreshape);
    lua::push_value(L, value);
    lua_setfield(L, -2, name.c_str());
  });
  host_->records.push_back({std::move(name), std::string(value.kind()), std::move(text)});
}

const std::vector<HostRecord>& Script::records() const {
  return host_->records;
}

Value Script::run() {
  Value result;
  host_->enter([&](lua_State* L) {
    host_->load(L, host_->text, host_->name);
    lua_call(L, 0, 1);
    result = lua::to_value(L, -1, {host_->name, 0});
  });
  return result;
}

Value Script::call(Value::Function function, std::span<const Value> arguments) {
  Value result;
  host_->enter([&](lua_State* L) {
    if (!lua_checkstack(L, static_cast<int>(arguments.size()) + 4)) throw ScriptError("too many arguments");
    lua::push_value(L, function);
    for (const auto& argument : arguments) lua::push_value(L, argument);
    lua_Debug definition;
    lua_pushvalue(L, 1);
    lua_getinfo(L, ">S", &definition);
    const SourcePlace place{lua::source_name(definition), definition.linedefined};
    lua_call(L, static_cast<int>(arguments.size()), 1);
    result = lua::to_value(L, -1, place);
  });
  return result;
}

const std::string& Script::last_traceback() const {
  return host_->traceback;
}

const std::string& Script::name() const {
  return host_->name;
}

Value read_description(const std::filesystem::path& path, const ScriptOptions& options) {
  Script script(path, options);
  Value description = script.run();
  if (description.is_table() || description.is_list()) return description;
  throw ScriptError(fmt::format("{}: must return a table, got {}", script.name(), description.kind()));
}

}  // namespace preshape
