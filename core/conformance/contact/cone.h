#pragma once

#include <Eigen/Core>

#include "preshape/contact/contact_limits.h"

namespace preshape::conformance {

/// Distance of a vector from the cone that the columns span with weights >= 0: non-negative least squares by
/// Lawson and Hanson's active set.
double distance_from_cone(const WrenchBasis& edges, const Eigen::Matrix<double, 6, 1>& vector);

/// How far the contact bears its unit normal force with a load along `direction` added: the largest multiple, by
/// bisection through `admits`; 0 when it bears none of it, `most` when it bears that much.
double reach(const ContactLimits& limits, const ContactFrame& contact, const Eigen::Matrix<double, 6, 1>& direction,
             double most = 1e3);

/// The unit normal force with a multiple of a load.
Wrench loaded(const ContactFrame& contact, double multiple, const Eigen::Matrix<double, 6, 1>& direction);

}  // namespace preshape::conformance
