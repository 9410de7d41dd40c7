#include "../check.h"

namespace preshape::conformance {

std::span<const Check> simulator_checks() { return {}; }

}  // namespace preshape::conformance
