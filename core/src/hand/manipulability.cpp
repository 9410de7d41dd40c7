#include "preshape/hand/manipulability.h"

#include <algorithm>

#include <Eigen/SVD>

namespace preshape {

Eigen::Matrix<double, 6, Eigen::Dynamic> drive_jacobian(const HandModel& hand, int finger, std::span<const double> posture) {
  const std::vector<int> drives = driven_joints(hand);
  const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
  Eigen::Matrix<double, 6, Eigen::Dynamic> own(6, about.joint_count), J(6, std::ssize(drives));
  hand.jacobian(finger, finger_values(hand, finger, posture), own);
  J.setZero();
  for (int k = 0; k < about.joint_count; ++k) {
    const int joint = about.first_joint + k;
    const Joint& coupling = hand.joints()[static_cast<std::size_t>(joint)];
    const int leader = coupling.leader < 0 ? joint : coupling.leader;
    const auto drive = std::lower_bound(drives.begin(), drives.end(), leader) - drives.begin();
    J.col(drive) += (coupling.leader < 0 ? 1.0 : coupling.ratio) * own.col(k);
  }
  return J;
}

Manipulability manipulability(const HandModel& hand, int finger, std::span<const double> posture) {
  const Eigen::Matrix3Xd J = drive_jacobian(hand, finger, posture).topRows<3>();
  Manipulability result;
  // Zero columns do not change the singular values and make sure that there are three.
  Eigen::Matrix3Xd padded = Eigen::Matrix3Xd::Zero(3, std::max<Eigen::Index>(3, J.cols()));
  padded.leftCols(J.cols()) = J;
  const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(padded, Eigen::ComputeThinU);
  result.singular_values = svd.singularValues().head<3>();
  result.axes_H = svd.matrixU().leftCols<3>();
  result.measure = result.singular_values.prod();
  return result;
}

}  // namespace preshape
