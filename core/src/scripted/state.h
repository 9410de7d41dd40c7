#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "blueprint.h"

namespace preshape::scripted {

/// Whether a component's calls bring a seed, from which `math.random` draws; without one it is not there.
enum class Chance { kNone, kSeeded };

class HostCall;

/// One Lua state with an instance of a component. One thread at a time.
class State {
 public:
  /// Runs the file and `new`. @param functions keys of the instance that `push` finds by their number
  /// @throws ScriptError
  State(const Blueprint& blueprint, std::span<const std::string> functions, Chance chance);

  lua::Host& host() { return *host_; }

  /// Pushes the function of that number, or nil when the instance has none.
  void push(int function) const {
    lua_rawgeti(host_->running, LUA_REGISTRYINDEX, references_[static_cast<std::size_t>(function)]);
  }

  /// For long loops inside of one `enter`: the instructions are counted anew.
  void count_anew() { host_->instructions.used = 0; }

  /// Lets `math.random` draw from this seed. Inside of `enter`.
  void seed(lua_State* L, std::uint64_t seed) const;

  /// "file:line: owner: 'compare' must return <what is wrong>": ScriptError at the function's first line.
  [[noreturn]] void refuse_result(int function, const std::string& expected_got,
                                  const std::string& input) const;

  /// Runs `body` with room for the instructions of learning or a search, which take more than an answer. What
  /// a HostCall throws goes through, whatever the script does about it; a ScriptError is the script's own
  /// matter.
  void enter_long(const std::function<void(lua_State*)>& body);

  /// A model or the like that this state has as Lua already: the number of its version, 0 for none.
  std::uint64_t kept_version = 0;
  int kept_reference = LUA_NOREF;

 private:
  friend class HostCall;

  std::map<std::uint64_t, const HostCall*> host_calls_;  ///< that can be called now, by number
  std::uint64_t next_host_call_ = 1;
  std::exception_ptr carried_;  ///< what a host call threw, on its way out
  std::unique_ptr<lua::Host> host_;
  std::string owner_;
  std::vector<std::string> names_;
  std::vector<int> references_;
};

/// A function of C++ that a call of Lua is given: it can be called until the scope ends, and then it is an
/// error that says so.
class HostCall {
 public:
  /// @param body reads its arguments from the stack and pushes its results; their number is returned
  HostCall(State& state, std::string name, std::function<int(lua_State*)> body);
  ~HostCall();
  HostCall(const HostCall&) = delete;
  HostCall& operator=(const HostCall&) = delete;

  /// Pushes it. Inside of `enter`.
  void push(lua_State* L) const;

 private:
  static int call(lua_State* L);

  State& state_;
  std::string name_;
  std::function<int(lua_State*)> body_;
  std::uint64_t number_;
};

/// The states of one object: as many as threads have called it at the same time. [any thread]
class StatePool {
 public:
  StatePool(Blueprint blueprint, std::vector<std::string> functions, Chance chance = Chance::kNone);

  /// A state for the length of a scope. One in which an error has arisen is not used again.
  class Lease {
   public:
    explicit Lease(const StatePool& pool);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    State& operator*() const { return *state_; }
    State* operator->() const { return state_.get(); }

   private:
    const StatePool& pool_;
    std::unique_ptr<State> state_;
    int exceptions_;
  };

  const Blueprint& blueprint() const { return blueprint_; }

 private:
  Blueprint blueprint_;
  std::vector<std::string> functions_;
  Chance chance_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<State>> free_;
};

}  // namespace preshape::scripted
