// The table of the checks of contact models.
#include "contact.h"

namespace preshape::conformance {

namespace {

constexpr Check kChecks[] = {
    {"C01", "contact", "rotating a contact rotates its unit wrenches, its pattern wrench and what it bears", c01_covariant,
     "frame_covariant"},
    {"C02", "contact", "wrenches are about the contact's own point: moving it without a turn changes none", c02_own_point},
    {"C03", "contact", "seen from the other body, its normal turned round, a contact transmits the same wrenches", c03_reciprocal},
    {"C04", "contact", "a contact pushes: no pattern wrench pulls and no pull is borne, unless it promises 'adhesive'",
     c04_pushes_only},
    {"C05", "contact", "the force across the normal that is borne is bounded by the normal force, by 'mu' where it has one",
     c05_friction_bound},
    {"C08", "contact", "what is borne is a convex cone that holds the normal force: sums and multiples are borne too", c08_cone},
    {"C09", "contact", "the edges are borne, with unit normal force, and fill the cone from inside with an error of 1/k^2",
     c09_inner_polyhedron},
    {"C10", "contact", "turning the approach axis about the normal changes nothing in what is borne", c10_isotropic, "isotropic"},
    {"C11", "contact", "the unit wrenches of a contact are 1 to 6, of unit length and independent", c11_basis_rank},
    {"C15", "contact", "normals that are zero or not unit, and fewer than three edges, give finite numbers or an InputError",
     c15_odd_frames},
    {"C17", "contact", "if it promises 'friction', two opposed contacts bear small forces and moments across their line", c17_opposed},
    {"C18", "contact", "the unit wrenches and edges of a contact do not depend on the contacts beside it", c18_independent},
    {"C19", "contact", "the pattern wrench is one that the unit wrenches transmit", c19_pattern_in_basis},
    {"C20", "contact", "what is borne is what the unit wrenches transmit, and nothing else", c20_limits_in_basis},
    {"C21", "contact", "what is borne at a tolerance is borne at any larger one", c21_tolerance},
};

}  // namespace

std::span<const Check> contact_checks() { return kChecks; }

}  // namespace preshape::conformance
