#pragma once

#include <span>
#include <string>
#include <string_view>

namespace preshape::conformance {

class Context;

/// How thorough a run is: quick takes under 5 s a component, full more cases and rare faults, soak minutes.
enum class Tier { kQuick, kFull, kSoak };

/// How a check ended.
enum class Outcome { kPass, kWarn, kSkip, kFail, kCrash, kTimeout };

std::string_view outcome_name(Outcome outcome);
/// A component with such a check does not conform.
inline bool is_bad(Outcome outcome) { return outcome >= Outcome::kFail; }

/// One property that components of a kind have.
struct Check {
  const char* id;        ///< "S03"; the letter is the kind's, G for all kinds
  const char* kind;      ///< "" for every kind
  const char* property;  ///< a sentence that is false of a component that fails
  void (*run)(Context&);
  const char* capability = "";  ///< run only when the component declares it; "" always
  Tier tier = Tier::kQuick;     ///< the lowest tier that runs it
  double seconds = 20.0;        ///< time limit
  /// What a process of its own answers to Context::in_fresh_process; may be null.
  std::string (*fresh)(Context&, std::string_view input) = nullptr;
};

/// The checks of every kind (G) and of each kind, in the order of their ids.
std::span<const Check> generic_checks();
std::span<const Check> contact_checks();
std::span<const Check> similarity_checks();
std::span<const Check> classifier_checks();
std::span<const Check> collision_checks();
std::span<const Check> hand_checks();
std::span<const Check> quality_checks();
std::span<const Check> explorer_checks();
std::span<const Check> simulator_checks();

/// The checks of one kind alone.
std::span<const Check> checks_of(std::string_view kind);

/// A check of the published lists that this suite does not have.
struct LeftOut {
  const char* id;
  const char* reason;
};
/// In the order of their ids.
std::span<const LeftOut> left_out();

}  // namespace preshape::conformance
