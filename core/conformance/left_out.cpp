// Checks of the published lists that do not fit our interfaces, each with its reason.
#include "check.h"

namespace preshape::conformance {

namespace {

constexpr LeftOut kLeftOut[] = {
    {"C06", "no contact model is given a velocity, so none can dissipate"},
    {"C07", "no contact model is given a penetration that its force could grow with"},
    {"C12", "no contact model is given a velocity that could be zero"},
    {"C13", "no contact model is given a motion, so no work can be counted"},
    {"C14", "contact models have no lengths: C02 holds them to that"},
    {"C16", "no interface offers a gradient of a contact's wrenches"},
    {"K03", "no classifier is told a number of threads"},
    {"K16", "no interface offers the rules of a fuzzy classifier"},
    {"S16", "no interface offers a gradient of a similarity"},
};

}  // namespace

std::span<const LeftOut> left_out() { return kLeftOut; }

}  // namespace preshape::conformance
