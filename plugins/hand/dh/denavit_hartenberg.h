#pragma once

#include "preshape/hand/chain.h"

namespace preshape::dh {

/// The four parameters of a link [m, rad].
struct LinkParameters {
  double a = 0.0;      ///< along x_i: from z_{i-1} to z_i
  double alpha = 0.0;  ///< about x_i: from z_{i-1} to z_i
  double d = 0.0;      ///< along z_{i-1}: from x_{i-1} to x_i
  double theta = 0.0;  ///< about z_{i-1}: from x_{i-1} to x_i
};

/// The standard (distal) Denavit-Hartenberg convention [FuGonzalezLee1987, ch. 2]: frame i is fixed to link i at
/// the link's far end, and joint i turns about, or slides along, z_{i-1}:
///   X_{i-1,i} = Rot_z(theta_i) Trans_z(d_i) Trans_x(a_i) Rot_x(alpha_i)
/// with the joint value added to theta_i (revolute) or to d_i (prismatic). The modified (proximal) convention of
/// [Craig1986] puts frame i at the link's near end: its tables have to be converted.
ChainJoint joint_of(const LinkParameters& link, bool prismatic);

}  // namespace preshape::dh
