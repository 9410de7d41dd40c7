#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "arena.h"
#include "preshape/base/progress.h"
#include "preshape/base/value.h"
#include "preshape/plugin/registry.h"

namespace preshape::conformance {

/// A call that should be refused, or give numbers by the declared policy.
struct Attempt {
  std::string what;                          ///< "cast with 3 hits for 4 rays"
  std::function<std::vector<double>()> run;  ///< the numbers that came out
  std::vector<std::string> named = {};       ///< what the message of the refusal shall contain
};

/// How the checks of every kind use a component without knowing its kind. A component is a pointer to its
/// kind's interface.
class Probe {
 public:
  virtual ~Probe() = default;

  virtual std::shared_ptr<void> create(const Registry& registry, const std::string& name,
                                       const Value& parameters) const = 0;
  virtual const void* extension(void* component, const char* id) const = 0;

  /// Everything that a component of the kind can be asked, on inputs that depend on the seed alone: the numbers
  /// that came out, in order. A component that cannot do without (a classifier learns first) is prepared by it.
  virtual std::vector<double> use(void* component, std::uint64_t seed) const = 0;

  /// The const calls alone, for several threads at once, of a component that `use` has prepared.
  virtual std::vector<double> use_const(void* component, std::uint64_t seed) const { return use(component, seed); }

  /// `use` with somebody who is told how far it is; none when the kind has nothing to tell.
  virtual std::optional<std::vector<double>> use_told(void* component, std::uint64_t seed, Progress& progress) const {
    (void)component, (void)seed, (void)progress;
    return std::nullopt;
  }

  /// `use_const` with its inputs in the arena, which it seals before it calls.
  virtual std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const = 0;

  /// Calls with buffers of a wrong size; each message names the sizes.
  virtual std::vector<Attempt> wrong_sizes(void* component) const = 0;

  /// Calls with one number that is not finite.
  virtual std::vector<Attempt> nonfinite(void* component, double number) const = 0;

  /// One call with `count` questions, and the same questions one by one; none when the kind has no batches.
  struct Answers {
    std::vector<double> together, singly;
  };
  virtual std::optional<Answers> batch(void* component, int count, std::uint64_t seed) const {
    (void)component, (void)count, (void)seed;
    return std::nullopt;
  }
};

/// The probe of a kind.
const Probe& probe_of(std::string_view kind);

const Probe& contact_probe();
const Probe& similarity_probe();
const Probe& classifier_probe();
const Probe& collision_probe();
const Probe& hand_probe();
const Probe& quality_probe();
const Probe& explorer_probe();
const Probe& simulator_probe();

}  // namespace preshape::conformance
