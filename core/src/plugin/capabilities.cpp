#include "preshape/plugin/capabilities.h"

#include <algorithm>

namespace preshape {

namespace {

constexpr Capability kCapabilities[] = {
    {"", "rejects_nonfinite", "an input that is NaN or infinite is an InputError"},
    {"", "propagates_nonfinite", "a NaN in the input gives a NaN in what depends on it"},
    {"contact", "frame_covariant", "rotating the contact rotates its wrenches"},
    {"contact", "friction", "two opposed contacts bear forces across their normals"},
    {"contact", "adhesive", "the pattern wrench may pull"},
    {"contact", "isotropic", "turning the approach axis about the normal changes nothing in what is borne"},
    {"similarity", "symmetric", "s(a, b) = s(b, a), bit for bit"},
    {"similarity", "additive", "the six component scores add up to the score"},
    {"similarity", "reflexive", "s(a, a) is the nearest value of the scale for every a"},
    {"similarity", "separating", "patterns that differ are farther than equal ones"},
    {"similarity", "monotone", "of nested memberships A <= B <= C, C is no nearer to A than B is"},
    {"similarity", "continuous", "small changes of a pattern change the score little"},
    {"similarity", "metric", "distances obey the triangle inequality"},
    {"similarity", "crisp_complement", "a crisp fuzzy vector and its complement are as far as can be"},
    {"similarity", "inclusion", "a pattern whose memberships include the task's is as near as can be"},
    {"similarity", "permutation_invariant", "the order of the six components does not matter"},
    {"similarity", "formula_tfvadi", "it is the total fuzzy vector approaching degree index (thesis eq. 3.9.11)"},
    {"similarity", "formula_tfdist", "it is the total fuzzy distance (thesis eq. 3.9.5)"},
    {"similarity", "formula_cosine", "it is half of one plus the cosine of the crisp vectors; 1/2 where one is zero"},
    {"similarity", "formula_jaccard", "it is the set-theoretic similarity of each component, summed (thesis eq. 3.9.1)"},
    {"similarity", "formula_dice", "it is Dice's coefficient of each component's memberships, summed"},
    {"similarity", "formula_hamming", "it is the mean difference of each component's memberships, summed"},
    {"similarity", "formula_minkowski", "it is the Minkowski distance of order 3 of each component's memberships, summed"},
    {"similarity", "formula_turksen_zhong", "it is 1 / (1 + D) of each component, D the root mean square difference of its memberships, summed"},
    {"similarity", "formula_chen_vector", "it is q . w / max(q . q, w . w) of each component's memberships, summed"},
    {"similarity", "formula_subsethood", "it is the degree to which each component of the task lies in the pattern's, summed"},
    {"similarity", "formula_largest_difference", "it is 1 less the largest difference of each component's memberships, summed"},
    {"similarity", "formula_screw_angle", "it is the angle between the crisp vectors, forces and moments weighted alike"},
    {"similarity", "formula_task_distance", "it is d / (1 + d) with d the Euclidean distance of the crisp vectors"},
    {"similarity", "scale_invariant", "multiplying a pattern's crisp vector by a positive number changes nothing"},
    {"classifier", "nonlinear", "it learns exclusive or"},
    {"classifier", "interpolating", "it reproduces every row that it has learned"},
    {"classifier", "order_invariant", "the order of the rows does not matter"},
    {"classifier", "scale_invariant", "multiplying a feature by a positive number changes no decision"},
    {"classifier", "incremental", "extend keeps what was learned before, without the old rows' help"},
    {"classifier", "seedless", "the seed changes nothing"},
    {"classifier", "realtime", "predict allocates nothing after its first call"},
    {"collision", "watertight", "no ray passes between the triangles of a closed mesh"},
    {"hand", "identical_fingers", "all fingers but the thumb have the same joints and lengths"},
    {"quality", "frame_invariant", "rotating the grasp changes none of its numbers"},
    {"quality", "frame_invariant_first", "rotating the grasp does not change its first number"},
    {"quality", "permutation_invariant", "the order of the contacts behind the thumb does not matter"},
    {"quality", "force_scale_invariant", "multiplying all wrenches by a positive number changes nothing"},
    {"explorer", "anytime", "a larger budget never gives a worse station"},
    {"explorer", "exhaustive", "it finds the best station of the symbols' grid"},
    {"simulator", "frame_covariant", "moving object and contacts moves the hand with them"},
    {"simulator", "collision_free", "a path that reached has no link inside the object, fingertips aside"},
};

}  // namespace

std::span<const Capability> capabilities() { return kCapabilities; }

bool is_capability(std::string_view kind, std::string_view name) {
  return std::any_of(std::begin(kCapabilities), std::end(kCapabilities), [&](const Capability& c) {
    return c.name == name && (c.kind.empty() || c.kind == kind);
  });
}

}  // namespace preshape
