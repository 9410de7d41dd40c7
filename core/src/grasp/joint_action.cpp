#include "preshape/grasp/joint_action.h"

#include "preshape/base/require.h"

namespace preshape {

std::vector<JointAction> joint_actions(const HandModel& hand, std::span<const int> fingers, std::span<const double> q,
                                       const Pose& X_OH) {
  require_size("q", hand.joints().size(), q.size());
  std::vector<JointAction> actions;
  for (std::size_t contact = 0; contact < fingers.size(); ++contact) {
    const Finger& finger = hand.fingers()[static_cast<std::size_t>(fingers[contact])];
    const auto first = static_cast<std::size_t>(finger.first_joint), count = static_cast<std::size_t>(finger.joint_count);
    Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, finger.joint_count);
    hand.jacobian(fingers[contact], q.subspan(first, count), J);
    for (std::size_t k = 0; k < count; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      actions.push_back({static_cast<int>(contact),
                         Twist(J.col(column).head<3>(), J.col(column).tail<3>()).rotated(X_OH.R),
                         hand.joints()[first + k].torque_limit});
    }
  }
  return actions;
}

}  // namespace preshape
