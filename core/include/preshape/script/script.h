#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/export.h"
#include "preshape/base/value.h"

namespace preshape {

namespace lua {
struct Host;
}

/// What a script may use up. Instructions are counted anew for each `run` and `call` that comes from outside;
/// a callback counts with the call that led to it. A function of Lua's own is one instruction and is not
/// interrupted, however long it takes (a pathological pattern in `string.find`, `table.move` over a huge
/// range): where a hard guarantee is needed, give the process a limit.
struct ScriptLimits {
  std::size_t memory_bytes = std::size_t{64} << 20;  ///< of the Lua state; 0: no limit
  std::int64_t instructions = 200'000'000;           ///< 0: no limit, and Lua runs two to three times faster
};

struct ScriptOptions {
  /// Folders that `require` searches after the script's own.
  std::vector<std::filesystem::path> module_roots;
  /// Gives the script `io`, `os` and `package` as Lua ships them, and the stock `require` after ours.
  bool trust = false;
  /// Of `math.random`.
  std::uint64_t seed = 1;
  ScriptLimits limits;
  /// Told each line that the script prints; empty: standard output.
  std::function<void(std::string_view line)> print;
};

/// A function that scripts call as `preshape.NAME(...)`. A preshape::Error that it throws becomes a Lua error
/// with the caller's file and line in front, unless the message begins with a place already.
/// @param caller the line of the script that calls
using HostFunction = std::function<Value(std::span<const Value> arguments, const SourcePlace& caller)>;

/// One name of the module `preshape`, as the generated annotations and the reference page show it.
struct HostRecord {
  std::string name;
  std::string signature;  ///< "(scenario: table): table"; the value's kind for a constant
  std::string text;       ///< one line
};

/// One Lua script in a state of its own. It sees a strict, read-only `preshape`, `math`, `string`, `table`,
/// `utf8`, `coroutine` and the harmless base functions; `require` reads Lua files from the script's folder
/// and the module roots; `pairs` and `next` go in sorted order and `math.random` is seeded, so that a run can
/// be repeated. There is no way to files, processes or the clock unless the options trust the script, and
/// none to byte code, finalizers (`__gc`), `debug` or the address of anything.
///
/// Data crosses as Value. A table with the keys 1..n becomes a list, one with string keys a table; the form
/// `{ "salisbury_soft_finger", ka = 0.45 }`, one string in front of named keys, becomes a table whose key
/// `name` is that string. Anything else (holes, other keys, a cycle, userdata, coroutines) is an error that
/// names the place. Metatables are not looked at.
///
/// Every Value knows where it was written: an entry of a table has the file and line of its *key*, in
/// whatever file its table constructor or a traceable assignment (`s.contact.mu = 3`) stands; failing that,
/// the last line where that file writes the key at all; failing that, the place of what encloses it.
///
/// Used from one thread at a time; several scripts may run in several threads.
class PRESHAPE_API Script {
 public:
  /// @param path shown in messages as given, or relative to the current folder when absolute and inside it
  /// @throws InputError when the file cannot be read
  explicit Script(const std::filesystem::path& path, ScriptOptions options = {});

  /// A script that is not a file: `name` stands in messages, and `require` searches the module roots alone.
  static Script from_text(std::string text, std::string name, ScriptOptions options = {});

  Script(Script&&) noexcept;
  Script& operator=(Script&&) noexcept;
  ~Script();

  /// Makes `preshape.NAME` callable; before `run`, each name once.
  void add_function(std::string name, std::string signature, std::string text, HostFunction function);
  /// Makes `preshape.NAME` readable; tables inside it are the script's own copy.
  void add_constant(std::string name, std::string text, const Value& value);
  /// What was added, in that order.
  const std::vector<HostRecord>& records() const;

  /// Runs the script and returns its (first) result; functions inside it can be called with `call`.
  /// @throws ScriptError "file:line: sentence" for whatever goes wrong in it
  Value run();

  /// Calls a function that came out of this script, also from within a HostFunction that it called.
  /// @returns its first result
  /// @throws ScriptError as `run`
  Value call(Value::Function function, std::span<const Value> arguments);

  /// How the script came to where the last ScriptError arose; "" when there is nothing to tell.
  const std::string& last_traceback() const;

  /// The name in messages.
  const std::string& name() const;

 private:
  explicit Script(std::unique_ptr<lua::Host> host);

  std::unique_ptr<lua::Host> host_;
};

/// Runs a file that describes one thing (an object, a hand) and returns its table.
/// @throws InputError when the file cannot be read, ScriptError when it fails or returns something else
PRESHAPE_API Value read_description(const std::filesystem::path& path, const ScriptOptions& options = {});

}  // namespace preshape
