#pragma once

#include <span>

#include <Eigen/Core>

#include "preshape/contact/contact_model.h"

namespace preshape {

using WrenchUnion = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// Wrench union WU: the unit wrenches of all contacts about O, one a row (thesis eq. 3.6.9).
/// @param length_m characteristic length [m]; p_OC is divided by it
/// @returns (contacts * basis_size) x 6
PRESHAPE_API WrenchUnion wrench_union(const ContactModel& model, std::span<const ContactFrame> contacts,
                                      double length_m);

/// Resultant wrench W_n about O: the sum of the pattern wrenches, moved to O (thesis eq. 3.6.7, 3.6.8).
PRESHAPE_API Wrench resultant_wrench(std::span<const ContactFrame> contacts, std::span<const Wrench> F_C_O,
                                     double length_m);

}  // namespace preshape
