#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "check.h"
#include "preshape/base/random.h"
#include "preshape/plugin/registry.h"
#include "running_case.h"
#include "subject.h"

namespace preshape::conformance {

/// What a run of the suite is given.
struct Settings {
  Tier tier = Tier::kQuick;
  std::uint64_t seed = 1;
  Value parameters;               ///< of every component that is made, beside what a check sets; nil: defaults
  std::filesystem::path command;  ///< the `preshape` command, for checks that need a process of their own
};

/// Thrown by checks to end at once; caught by the runner only.
struct Failure {
  std::string text;
};
struct Skip {
  std::string reason;
};

/// Some numbers of a case that belong together, as a person would name them.
struct Block {
  std::string name;
  int size = 1;
  double low = 0.0, high = 1.0;
  std::vector<double> corners = {};  ///< values that are tried often, beside low and high
  bool whole = false;                ///< whole numbers only
};

/// One case: the numbers of all blocks, one after another.
using Case = std::span<const double>;
/// Whether the property holds for the case: "" or a sentence that says what was found.
using Property = std::function<std::string(Case)>;

/// A check at work: the component, its randomness, and how the check says what it found.
class Context {
 public:
  Context(const Check& check, Subject subject, Settings settings, RunningCase* running);

  const Check& check() const { return check_; }
  const Subject& subject() const { return subject_; }
  const Settings& settings() const { return settings_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// A registry of the subject's file alone; the library is loaded when something of it is asked.
  const Registry& registry();
  /// Lets go of the registry, and so of the library unless an object of it is alive.
  void forget_registry() { registry_.reset(); }
  const ComponentRecord& record() { return registry().describe(subject_.kind, subject_.name); }
  bool declares(std::string_view capability);

  /// The parameters that components are made with unless a check sets others: the settings', with what a
  /// component cannot be made without.
  Value parameters();
  template <class T>
  std::shared_ptr<T> create() {
    return registry().create<T>(subject_.name, parameters());
  }
  template <class T>
  std::shared_ptr<T> create(const Value& parameters) {
    return registry().create<T>(subject_.name, parameters);
  }

  /// The number of cases for this tier: ten times as many in full, a hundred times in soak.
  int cases(int quick) const;
  /// Randomness of this check and purpose.
  Random random(std::string_view purpose) const;

  /// The property holds for the corners of the blocks and for `count` random cases. One that breaks it is made
  /// small before it is told. An exception of the property breaks it too.
  void for_all(std::span<const Block> blocks, int count, const Property& property);

  template <class... Arguments>
  [[noreturn]] void fail(fmt::format_string<Arguments...> format, Arguments&&... arguments) const {
    throw Failure{fmt::format(format, std::forward<Arguments>(arguments)...)};
  }
  template <class... Arguments>
  void require(bool condition, fmt::format_string<Arguments...> format, Arguments&&... arguments) const {
    if (!condition) throw Failure{fmt::format(format, std::forward<Arguments>(arguments)...)};
  }
  [[noreturn]] void skip(std::string reason) const { throw Skip{std::move(reason)}; }
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  /// What Check::fresh answers to `input` in a process that was started anew.
  std::string in_fresh_process(std::string_view input);

 private:
  const Check& check_;
  Subject subject_;
  Settings settings_;
  RunningCase* running_;
  std::unique_ptr<Registry> registry_;
  std::vector<std::string> warnings_;
  Value hand_description_;  ///< what a hand model is made with, once it was read
};

/// A hand's description that was given by its file or by the name of a hand.
/// @throws InputError, ScriptError when there is none
Value named_description(const std::string& name);

/// "task = {0 0.5 1}, step = 2": a case as a person reads it.
std::string case_text(std::span<const Block> blocks, Case numbers);

}  // namespace preshape::conformance
