#pragma once

#include "../context.h"

namespace preshape::conformance {

// wrenches.cpp: what a contact transmits and adds to the pattern
void c01_covariant(Context& context);
void c02_own_point(Context& context);
void c03_reciprocal(Context& context);
void c04_pushes_only(Context& context);
void c11_basis_rank(Context& context);
void c15_odd_frames(Context& context);
void c17_opposed(Context& context);
void c18_independent(Context& context);
void c19_pattern_in_basis(Context& context);

// limits.cpp: what a contact can bear
void c05_friction_bound(Context& context);
void c08_cone(Context& context);
void c09_inner_polyhedron(Context& context);
void c10_isotropic(Context& context);
void c20_limits_in_basis(Context& context);
void c21_tolerance(Context& context);

}  // namespace preshape::conformance
