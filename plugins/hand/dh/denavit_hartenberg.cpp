#include "denavit_hartenberg.h"

#include <Eigen/Geometry>

namespace preshape::dh {

ChainJoint joint_of(const LinkParameters& link, bool prismatic) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  ChainJoint joint;
  joint.prismatic = prismatic;
  joint.X_PJ.R = AngleAxisd(link.theta, Vector3d::UnitZ()).toRotationMatrix();
  joint.X_JL.R = AngleAxisd(link.alpha, Vector3d::UnitX()).toRotationMatrix();
  joint.X_JL.p = Vector3d(link.a, 0.0, link.d);
  return joint;
}

}  // namespace preshape::dh
