#pragma once

#include <vector>

#include "preshape/grasp/simulator.h"

namespace preshape::kinematic {

/// Which finger of the hand makes each contact, thumb first; indices into HandModel::fingers().
using Assignment = std::vector<int>;

/// All ways to give the contacts to fingers without crossing them: the thumb to the first, forefingers to the others in
/// their order across the hand. Those that move the hand's middle least come first, fingers of the asked roles before
/// others that do as well. None when the hand has no thumb or too few forefingers.
/// @param R_OH orientation of the hand base
std::vector<Assignment> assignments(const SimulationTask& task, const Eigen::Matrix3d& R_OH);

}  // namespace preshape::kinematic
