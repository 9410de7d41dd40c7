#include "preshape/grasp/imparted_twists.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "preshape/base/require.h"

namespace preshape {

namespace {

constexpr double kRank = 1e-9;  // of the largest singular value

/// Orthonormal basis of the null space, as columns.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return Eigen::MatrixXd::Identity(A.cols(), A.cols());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullV);
  const auto& s = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < s.size() && s[rank] > kRank * s[0]) ++rank;
  return svd.matrixV().rightCols(A.cols() - rank);
}

}  // namespace

std::vector<DriveShare> drive_shares(const HandModel& hand, std::span<const int> fingers) {
  std::vector<DriveShare> shares;
  for (const int finger : fingers) {
    const Finger& about = hand.fingers()[static_cast<std::size_t>(finger)];
    for (int joint = about.first_joint; joint < about.first_joint + about.joint_count; ++joint) {
      const Joint& coupling = hand.joints()[static_cast<std::size_t>(joint)];
      shares.push_back(coupling.leader < 0 ? DriveShare{joint, 1.0} : DriveShare{coupling.leader, coupling.ratio});
    }
  }
  return shares;
}

ImpartedTwists imparted_twists(const ContactModel& model, std::span<const ContactFrame> contacts,
                               std::span<const JointAction> joints, std::span<const DriveShare> groups, double length_m) {
  require_size("groups", joints.size(), groups.size());
  const Eigen::Index each = model.basis_size(), rows = each * std::ssize(contacts);
  WrenchBasis basis(6, rows);
  model.wrench_basis(contacts, basis);
  std::vector<int> drives;
  for (const auto& share : groups) drives.push_back(share.drive);
  std::sort(drives.begin(), drives.end());
  drives.erase(std::unique(drives.begin(), drives.end()), drives.end());

  // Unknowns: the object's twist about O, lengths over L, then a rate for each drive.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, 6 + std::ssize(drives));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto first = static_cast<Eigen::Index>(i) * each;
    const Eigen::Matrix<double, Eigen::Dynamic, 6> Bt = basis.middleCols(first, each).transpose();
    for (int k = 0; k < 6; ++k) {
      Eigen::Matrix<double, 6, 1> unit = Eigen::Matrix<double, 6, 1>::Unit(k);
      const Twist V_O(unit.head<3>(), unit.tail<3>());
      A.col(k).segment(first, each) = Bt * V_O.shifted(contacts[i].p_OC / length_m).vector();
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j].contact != static_cast<int>(i)) continue;
      const auto drive = std::lower_bound(drives.begin(), drives.end(), groups[j].drive) - drives.begin();
      const Twist V(joints[j].V_C_O.linear() / length_m, joints[j].V_C_O.angular());
      A.col(6 + drive).segment(first, each) -= groups[j].gain * (Bt * V.vector());
    }
  }
  const Eigen::MatrixXd motions = null_space(A);
  ImpartedTwists result;
  if (motions.cols() == 0) return result;
  const Eigen::JacobiSVD<Eigen::MatrixXd> object(motions.topRows(6), Eigen::ComputeThinU);
  for (Eigen::Index k = 0; k < object.singularValues().size() && object.singularValues()[k] > kRank; ++k) {
    const Eigen::Matrix<double, 6, 1> v = object.matrixU().col(k);
    result.twists_O.emplace_back(v.head<3>(), v.tail<3>());
  }
  result.internal_motions = static_cast<int>(null_space(A.rightCols(std::ssize(drives))).cols());
  return result;
}

double share_of(const ImpartedTwists& imparted, const Task& task) {
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> wanted(task.screw.data());
  if (!(wanted.norm() > 0.0)) return 1.0;
  double squared = 0.0;
  for (const Twist& basis : imparted.twists_O) squared += std::pow(basis.vector().dot(wanted), 2);
  return std::sqrt(squared) / wanted.norm();
}

}  // namespace preshape
