#include "../check.h"

namespace preshape::conformance {

std::span<const Check> quality_checks() { return {}; }

}  // namespace preshape::conformance
