// Which checks and probes there are.
#include "check.h"
#include "preshape/base/assert.h"
#include "probe.h"

namespace preshape::conformance {

namespace {

struct Kind {
  std::string_view name;
  std::span<const Check> (*checks)();
  const Probe& (*probe)();
};

constexpr Kind kChecked[] = {
    {"contact", contact_checks, contact_probe},          {"similarity", similarity_checks, similarity_probe},
    {"classifier", classifier_checks, classifier_probe}, {"collision", collision_checks, collision_probe},
    {"hand", hand_checks, hand_probe},                   {"quality", quality_checks, quality_probe},
    {"explorer", explorer_checks, explorer_probe},       {"simulator", simulator_checks, simulator_probe},
};

const Kind& kind_named(std::string_view name) {
  for (const Kind& kind : kChecked) {
    if (kind.name == name) return kind;
  }
  PRESHAPE_DEMAND(!"a kind of the registry");
  return kChecked[0];
}

}  // namespace

std::string_view outcome_name(Outcome outcome) {
  static constexpr std::string_view kNames[] = {"pass", "warn", "skip", "fail", "crash", "timeout"};
  return kNames[static_cast<int>(outcome)];
}

std::span<const Check> checks_of(std::string_view kind) { return kind_named(kind).checks(); }
const Probe& probe_of(std::string_view kind) { return kind_named(kind).probe(); }

}  // namespace preshape::conformance
