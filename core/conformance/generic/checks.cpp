#include "../check.h"

namespace preshape::conformance {

std::span<const Check> generic_checks() { return {}; }

}  // namespace preshape::conformance
