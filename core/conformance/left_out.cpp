// Checks of the published lists that do not fit our interfaces, each with its reason.
#include "check.h"

namespace preshape::conformance {

namespace {

constexpr LeftOut kLeftOut[] = {
    {"G08", "the host fills the defaults in before a component is made, so that both are one call"},
    {"G11", "parameters are plain data that reads back from text as the same data: held by tests/core/script/setting_test.cpp"},
    {"G18", "inputs and outputs of every call are of different types, and buffers may not overlap by contract"},
    {"G24", "a property of the host, whatever the plugin: held by tests/core/plugin/lifetime_test.cpp"},
    {"H04", "the forward kinematics are in the hand's own frame H; a pose of the hand is the caller's to multiply"},
    {"H07", "the interface has no inverse kinematics"},
    {"H08", "the interface has no inverse kinematics"},
    {"H10", "each joint is moved by itself: the interface has no coupling, and H05 refuses one"},
    {"H11", "the interface has no opening command"},
    {"H12", "the interface has no tendons or actuators"},
    {"H14", "the interface has no mirrored hands"},
    {"H15", "a description is plain data that the host reads; the interface saves none"},
    {"H17", "the interface has no named postures; the simulator's checks look at preshapes"},
    {"S06", "a path of constant sign is a chain of nested patterns: S05 has it"},
    {"S09", "the interface has no weights"},
    {"S10", "a pattern has six components, no more can be added"},
    {"S13", "memberships come from fuzzy sets, which cannot leave [0, 1]"},
    {"S16", "the interface offers no gradient"},
    {"C06", "no contact model is given a velocity, so none can dissipate"},
    {"C07", "no contact model is given a penetration that its force could grow with"},
    {"C12", "no contact model is given a velocity that could be zero"},
    {"C13", "no contact model is given a motion, so no work can be counted"},
    {"C14", "contact models have no lengths: C02 holds them to that"},
    {"C16", "no interface offers a gradient of a contact's wrenches"},
    {"K03", "no classifier is told a number of threads"},
    {"K16", "no interface offers the rules of a fuzzy classifier"},
    {"B11", "the interface tells distances, not contacts or penetrations"},
    {"B15", "the same as G21, which asks every kind from eight threads at once"},
    {"B16", "the interface has no continuous collision"},
    {"B18", "a run sees one component; B01, B09 and B10 compare each with the suite's own answers instead"},
};

}  // namespace

std::span<const LeftOut> left_out() { return kLeftOut; }

}  // namespace preshape::conformance
