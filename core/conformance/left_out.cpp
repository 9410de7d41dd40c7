// Checks of the published lists that do not fit our interfaces, each with its reason.
#include "check.h"

namespace preshape::conformance {

namespace {

constexpr LeftOut kLeftOut[] = {
    {"S16", "no interface offers a gradient of a similarity"},
};

}  // namespace

std::span<const LeftOut> left_out() { return kLeftOut; }

}  // namespace preshape::conformance
