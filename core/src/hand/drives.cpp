#include "drives.h"

#include <Eigen/Geometry>

namespace preshape {

Drives::Drives(const HandModel& hand, std::span<const FingertipTarget> targets, const HandFreedom& freedom)
    : hand_(hand), place_(hand.joints().size(), -1) {
  for (const auto& target : targets) {
    const Finger& finger = hand.fingers()[static_cast<std::size_t>(target.finger)];
    for (int j = finger.first_joint; j < finger.first_joint + finger.joint_count; ++j) add(j);
  }
  for (int way = 0; way < 6; ++way) {
    const double most = way < 3 ? freedom.translation_m[way] / hand.dimensions().unit_length_m : freedom.turn[way - 3];
    if (!(most > 0.0)) continue;
    ways_.push_back(way);
    ranges_.push_back({-most, most});
  }
}

double Drives::gain(int joint) const {
  const Joint& about = hand_.joints()[static_cast<std::size_t>(joint)];
  return about.leader < 0 ? 1.0 : about.ratio;
}

int Drives::leader(int joint) const {
  const int leader = hand_.joints()[static_cast<std::size_t>(joint)].leader;
  return leader < 0 ? joint : leader;
}

void Drives::add(int joint) {
  auto& place = place_[static_cast<std::size_t>(leader(joint))];
  if (place >= 0) return;
  place = count();
  joints_.push_back(leader(joint));
  ranges_.push_back(drive_range(hand_, leader(joint)));
}

Standing::Standing(const HandModel& hand, const Eigen::Matrix<double, 6, 1>& moved) {
  X_HM.p = hand.dimensions().unit_length_m * moved.head<3>();
  X_HM.R.setIdentity();
  for (int k = 0; k < 3; ++k) {
    axes_H.col(k) = X_HM.R.col(k);
    X_HM.R = X_HM.R * Eigen::AngleAxisd(moved[3 + k], Eigen::Vector3d::Unit(k)).toRotationMatrix();
  }
}

}  // namespace preshape
