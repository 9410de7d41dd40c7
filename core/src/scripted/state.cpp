#include "state.h"

#include <exception>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "script/guard.h"

namespace preshape::scripted {

namespace {

constexpr std::int64_t kLongInstructions = 50'000'000'000;

/// In place of math.random where nothing may be left to chance; the upvalue is what the component is.
int refuse_chance(lua_State* L) {
  return lua::guard(L, [L]() -> int {
    throw ScriptError(
        fmt::format("math.random: {} has no seed, so that the same question has the same answer",
                    lua_tostring(L, lua_upvalueindex(1))));
  });
}

/// Pushes the table of `math` that scripts see a sealed view of.
void push_math(lua_State* L) {
  lua_getglobal(L, "math");
  lua_getmetatable(L, -1);
  lua_getfield(L, -1, "__index");
  lua_replace(L, -3);
  lua_pop(L, 1);
}

void take_chance(lua_State* L, const std::string& owner) {
  push_math(L);
  for (const char* name : {"random", "randomseed"}) {
    lua_pushstring(L, owner.c_str());
    lua_pushcclosure(L, &refuse_chance, 1);
    lua_setfield(L, -2, name);
  }
  lua_pop(L, 1);
}

}  // namespace

State::State(const Blueprint& blueprint, std::span<const std::string> functions, Chance chance)
    : host_(open_host(blueprint.source, false)),
      owner_(blueprint.owner()),
      names_(functions.begin(), functions.end()) {
  references_.reserve(names_.size());
  host_->enter([&](lua_State* L) {
    if (chance == Chance::kNone) take_chance(L, owner_);
    push_instance(L, blueprint);
    for (const auto& name : names_) {
      lua_pushlstring(L, name.data(), name.size());
      if (lua_rawget(L, -2) != LUA_TFUNCTION) {
        lua_pop(L, 1);
        lua_pushnil(L);
      }
      references_.push_back(luaL_ref(L, LUA_REGISTRYINDEX));
    }
  });
}

void State::seed(lua_State* L, std::uint64_t seed) const {
  push_math(L);
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, static_cast<lua_Integer>(seed));
  lua_call(L, 1, 0);
  lua_pop(L, 1);
}

void State::refuse_result(int function, const std::string& expected_got, const std::string& input) const {
  push(function);
  const SourcePlace place = definition(host_->running, -1);
  lua_pop(host_->running, 1);
  throw ScriptError(fmt::format("{}: {}: '{}' must return {}{}{}", place.text(), owner_,
                                names_[static_cast<std::size_t>(function)], expected_got,
                                input.empty() ? "" : " for ", input));
}

void State::enter_long(const std::function<void(lua_State*)>& body) {
  const auto usual = std::exchange(host_->instructions.limit, kLongInstructions);
  carried_ = nullptr;
  try {
    host_->enter(body);
  } catch (const Error&) {
    host_->instructions.limit = usual;
    if (carried_) std::rethrow_exception(carried_);
    throw;
  }
  host_->instructions.limit = usual;
  if (carried_) std::rethrow_exception(carried_);
}

HostCall::HostCall(State& state, std::string name, std::function<int(lua_State*)> body)
    : state_(state), name_(std::move(name)), body_(std::move(body)), number_(state.next_host_call_++) {
  state_.host_calls_.emplace(number_, this);
}

HostCall::~HostCall() {
  state_.host_calls_.erase(number_);
}

void HostCall::push(lua_State* L) const {
  lua_pushlightuserdata(L, &state_);
  lua_pushinteger(L, static_cast<lua_Integer>(number_));
  lua_pushlstring(L, name_.data(), name_.size());
  lua_pushcclosure(L, &HostCall::call, 3);
}

int HostCall::call(lua_State* L) {
  return lua::guard(L, [L] {
    auto& state = *static_cast<State*>(lua_touserdata(L, lua_upvalueindex(1)));
    const auto found =
        state.host_calls_.find(static_cast<std::uint64_t>(lua_tointeger(L, lua_upvalueindex(2))));
    if (found == state.host_calls_.end()) {
      throw ScriptError(fmt::format("{}: it can be called only during the call that it was given to",
                                    lua_tostring(L, lua_upvalueindex(3))));
    }
    if (state.carried_) std::rethrow_exception(state.carried_);
    try {
      return found->second->body_(L);
    } catch (const ScriptError&) {
      throw;
    } catch (const std::exception&) {
      state.carried_ = std::current_exception();
      throw;
    }
  });
}

StatePool::StatePool(Blueprint blueprint, std::vector<std::string> functions, Chance chance)
    : blueprint_(std::move(blueprint)), functions_(std::move(functions)), chance_(chance) {
  free_.push_back(std::make_unique<State>(blueprint_, functions_, chance_));
}

StatePool::Lease::Lease(const StatePool& pool) : pool_(pool), exceptions_(std::uncaught_exceptions()) {
  {
    const std::lock_guard lock(pool.mutex_);
    if (!pool.free_.empty()) {
      state_ = std::move(pool.free_.back());
      pool.free_.pop_back();
    }
  }
  if (!state_) state_ = std::make_unique<State>(pool.blueprint_, pool.functions_, pool.chance_);
}

StatePool::Lease::~Lease() {
  if (std::uncaught_exceptions() > exceptions_) return;
  const std::lock_guard lock(pool_.mutex_);
  pool_.free_.push_back(std::move(state_));
}

}  // namespace preshape::scripted
