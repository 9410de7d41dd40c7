#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/spatial/pose.h"

namespace preshape {

/// One joint of a serial chain and the link that it moves. The joint turns about, or slides along, the z axis of
/// its own frame J.
struct ChainJoint {
  bool prismatic = false;
  Pose X_PJ;  ///< J at q = 0, in the frame P of the link before (of the chain's base for the first joint)
  Pose X_JL;  ///< the moved link's frame L, fixed in J
};

/// A finger as a serial chain from the hand base H to the fingertip D:
///   X_HD(q) = X_HB  prod_i [ X_PJ_i  Z_i(q_i)  X_JL_i ]  X_LD,   Z_i = Rot_z(q_i) or Trans_z(q_i)
/// Whatever a hand is described with (Denavit-Hartenberg parameters, a URDF tree) ends as such a chain.
class PRESHAPE_API Chain {
 public:
  Chain(const Pose& X_HB, std::vector<ChainJoint> joints, const Pose& X_LD);

  int joint_count() const { return static_cast<int>(joints_.size()); }

  /// @param q joint_count values, base to tip [rad or m]
  /// @param poses_H joint_count + 2 poses in H: base B, links 1 .. joint_count, tip D
  /// @throws InputError when a size does not fit
  void forward(std::span<const double> q, std::span<Pose> poses_H) const;

  /// Geometric Jacobian of the tip: V_D_H = J qdot, linear rows first [m/rad or 1], then angular [1 or 0].
  /// Column of a revolute joint at p with axis z: (z x (p_D - p); z), of a prismatic one (z; 0).
  /// @param jacobian 6 x joint_count, overwritten
  /// @throws InputError when a size does not fit
  void jacobian(std::span<const double> q, Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const;

 private:
  Pose X_HB_;
  std::vector<ChainJoint> joints_;
  Pose X_LD_;
};

}  // namespace preshape
