#include "fingers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "document.h"
#include "preshape/base/suggest.h"

namespace preshape::urdf_hand {

namespace {

/// The rotation that takes the z axis to a unit vector; any about it. One that is nearly -z is turned over
/// first: the shortest turn would lose digits there.
Eigen::Matrix3d z_along(const Eigen::Vector3d& axis) {
  const bool over = axis.z() < 0.0;
  const Eigen::Vector3d up = over ? Eigen::Vector3d(-axis) : axis;
  const Eigen::Matrix3d R =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
  return over ? Eigen::Matrix3d(R * Eigen::Vector3d(1, -1, -1).asDiagonal()) : R;
}

/// q = ratio * (value of joint `root`) + offset; the root mimics nothing.
struct Source {
  std::string root;
  double ratio = 1.0, offset = 0.0;
};

class Builder {
 public:
  Builder(const Description& description, const Document& document)
      : description_(description), document_(document) {}

  Fingers build() {
    demand_link(description_.base_link, "base");
    for (const FingerDescription& finger : description_.fingers) append(finger);
    couple();
    return std::move(built_);
  }

 private:
  void demand_link(const std::string& link, const char* key) const {
    demand_link(description_.table, link, key);
  }
  void demand_link(const Table& table, const std::string& link, const char* key) const;
  void append(const FingerDescription& description);
  void append_joint(const urdf::JointConstSharedPtr& joint, const Motion& motion, Finger& finger);
  Source source_of(const urdf::Joint& joint) const;
  void couple();
  void lead_instead(std::size_t joint, const Source& source);
  void demand_room(std::size_t leader) const;

  const Description& description_;
  const Document& document_;
  Fingers built_;
  std::vector<urdf::JointConstSharedPtr> sources_;  ///< of each joint of the hand
};

void Builder::demand_link(const Table& table, const std::string& link, const char* key) const {
  if (document_.model->getLink(link)) return;
  table.refuse(key, fmt::format("names the link '{}', which is not in {}{}", link, document_.file.string(),
                                did_you_mean(link, link_names(*document_.model))));
}

void Builder::append(const FingerDescription& description) {
  demand_link(description.table, description.tip_link, "tip");
  const auto path = path_between(document_, description_.base_link, description.tip_link);
  if (!path) {
    description.table.refuse("tip",
                             fmt::format("names the link '{}', which is not beyond the base's link '{}'",
                                         description.tip_link, description_.base_link));
  }
  Finger finger{description.name, description.role, static_cast<int>(built_.joints.size()), 0};
  std::vector<ChainJoint> chain;
  Pose X_HB, X = description_.X_LH.inverse();  // X: of the joint to come, in the link before
  for (const auto& joint : *path) {
    const auto motion = motion_of(document_, *joint);
    if (!motion) {
      X = X * pose_at_rest(document_, *joint);
      continue;
    }
    X = X * origin_of(document_, *joint);
    if (chain.empty()) X_HB = std::exchange(X, {});
    const Eigen::Matrix3d R_JA = z_along(axis_of(document_, *joint));
    chain.push_back({motion->prismatic, {X.R * R_JA, X.p}, {R_JA.transpose(), Eigen::Vector3d::Zero()}});
    X = {};
    append_joint(joint, *motion, finger);
  }
  if (chain.empty()) {
    description.table.refuse(
        "tip", fmt::format("names the link '{}', which does not move against the base's link '{}'",
                           description.tip_link, description_.base_link));
  }
  built_.chains.emplace_back(X_HB, std::move(chain), X * Pose{Eigen::Matrix3d::Identity(), description.p_LD});
  built_.fingers.push_back(std::move(finger));
}

void Builder::append_joint(const urdf::JointConstSharedPtr& joint, const Motion& motion, Finger& finger) {
  ++finger.joint_count;
  const bool first =
      built_.moved_by
          .emplace(joint->name, Carrier{static_cast<int>(built_.fingers.size()), finger.joint_count})
          .second;
  Joint made;
  made.name = first ? joint->name : fmt::format("{} ({})", joint->name, finger.name);
  made.prismatic = motion.prismatic;
  made.lower = motion.lower;
  made.upper = motion.upper;
  made.torque_limit = motion.torque;
  built_.joints.push_back(std::move(made));
  sources_.push_back(joint);
}

Source Builder::source_of(const urdf::Joint& joint) const {
  Source source{joint.name};
  const urdf::Joint* at = &joint;
  for (std::size_t steps = 0; at->mimic; ++steps) {
    const urdf::JointMimic& mimic = *at->mimic;
    if (steps > document_.model->joints_.size())
      refuse(
          document_.file,
          fmt::format("joint '{}' mimics itself in a circle; one joint of it must have a drive", joint.name));
    if (!std::isfinite(mimic.multiplier) || !std::isfinite(mimic.offset))
      refuse(document_.file, fmt::format("joint '{}': <mimic> must have finite numbers", at->name));
    const auto leader = document_.model->getJoint(mimic.joint_name);
    if (!leader) {
      refuse(document_.file,
             fmt::format("joint '{}' mimics '{}', which is no joint{}", at->name, mimic.joint_name,
                         did_you_mean(mimic.joint_name, joint_names(*document_.model))));
    }
    source = {leader->name, source.ratio * mimic.multiplier, source.ratio * mimic.offset + source.offset};
    at = leader.get();
  }
  return source;
}

void Builder::couple() {
  std::map<std::string, std::size_t> drives;  // by the joint of the URDF that they stand for
  std::map<std::string, Source> stands_for;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (source_of(*sources_[i]).root == sources_[i]->name) drives.emplace(sources_[i]->name, i);
  }
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source source = source_of(*sources_[i]);
    if (drives.emplace(source.root, i).second) {
      stands_for[source.root] = source;
      lead_instead(i, source);
    }
    const std::size_t leader = drives.at(source.root);
    if (leader == i) continue;
    const auto instead = stands_for.find(source.root);
    const Source base = instead == stands_for.end() ? Source{} : instead->second;
    built_.joints[i].leader = static_cast<int>(leader);
    built_.joints[i].ratio = source.ratio / base.ratio;
    built_.joints[i].offset = source.offset - built_.joints[i].ratio * base.offset;
  }
  for (const auto& [name, leader] : drives) demand_room(leader);
}

/// A joint whose leader moves no finger leads in its place, within what the leader may do.
void Builder::lead_instead(std::size_t joint, const Source& source) {
  const auto motion = motion_of(document_, *document_.model->getJoint(source.root));
  if (!motion)
    refuse(document_.file, fmt::format("joint '{}' mimics '{}', which does not move; make it fixed",
                                       sources_[joint]->name, source.root));
  Joint& made = built_.joints[joint];
  const double a = source.ratio * motion->lower + source.offset,
               b = source.ratio * motion->upper + source.offset;
  made.lower = std::max(made.lower, std::min(a, b));
  made.upper = std::min(made.upper, std::max(a, b));
}

void Builder::demand_room(std::size_t leader) const {
  const Joint& drive = built_.joints[leader];
  double lower = drive.lower, upper = drive.upper;
  for (const Joint& joint : built_.joints) {
    if (joint.leader != static_cast<int>(leader)) continue;
    const double a = (joint.lower - joint.offset) / joint.ratio,
                 b = (joint.upper - joint.offset) / joint.ratio;
    lower = std::max(lower, std::min(a, b));
    upper = std::min(upper, std::max(a, b));
  }
  if (lower >= upper) {
    refuse(document_.file,
           fmt::format(
               "joint '{}' cannot move: its limits and those of the joints that mimic it exclude each other",
               drive.name));
  }
}

}  // namespace

Fingers build_fingers(const Description& description, const Document& document) {
  return Builder(description, document).build();
}

}  // namespace preshape::urdf_hand
