#include "../check.h"

namespace preshape::conformance {

std::span<const Check> classifier_checks() { return {}; }

}  // namespace preshape::conformance
