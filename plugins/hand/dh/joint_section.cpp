#include "joint_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "denavit_hartenberg.h"
#include "preshape/base/suggest.h"
#include "preshape/hand/posture.h"
#include "turned.h"

namespace preshape::dh {

namespace {

constexpr std::array kByParameters = {"a", "alpha", "d", "theta"};
constexpr std::array kByAxis = {"position", "rotation", "axis"};

std::vector<ParameterDeclaration> coupling_keys() {
  auto ratio = ParameterDeclaration::number("ratio", 0.0, -1000.0, 1000.0, "-", "of the leader's value");
  ratio.default_value = Value{};
  return {required_label("joint", "name of the joint that leads"), ratio,
          length("offset", 0.0, "joint value where the leader's is 0; angle or length")};
}

template <std::size_t kCount>
const char* first_given(const Section& section, const std::array<const char*, kCount>& keys) {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const char* key) { return section.has(key); });
  return found == keys.end() ? nullptr : *found;
}

void read_limits(const Section& section, double metres, Joint& joint) {
  const auto limits = section.numbers("limits", 2);
  if (limits[0] > limits[1]) {
    section.refuse("limits",
                   fmt::format("must be {{ lower, upper }} with lower <= upper, got {}", section.value("limits").text()));
  }
  if (!joint.prismatic && std::max(std::abs(limits[0]), std::abs(limits[1])) > 2.0 * std::numbers::pi) {
    section.refuse("limits", fmt::format("are in radians, got {}; write math.rad({})",
                                         section.value("limits").text(), number_text(limits[1])));
  }
  const double unit = joint.prismatic ? metres : 1.0;
  joint.lower = unit * limits[0];
  joint.upper = unit * limits[1];
}

Eigen::Vector3d read_axis(const Section& section) {
  const Eigen::Vector3d axis = section.vector("axis");
  if (axis.norm() < 1e-6) section.refuse("axis", "must have a direction, got { 0, 0, 0 }");
  return axis;
}

/// What is left of the leader's range when its followers keep to theirs.
void demand_room(const Section& section, const std::vector<Joint>& joints, int leader) {
  const Joint& drive = joints[static_cast<std::size_t>(leader)];
  const DriveRange range = drive_range(joints, leader);
  if (range.lower >= range.upper) {
    section.refuse(
        "joint",
        fmt::format("'{}' has no room left: its limits and those of the joints that follow it exclude "
                    "each other; mend limits, ratio or offset",
                    drive.name));
  }
}

}  // namespace

std::vector<ParameterDeclaration> joint_keys() {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  auto axis = point("axis", "turned about, or slid along, in the joint's frame");
  axis.default_value = Value::numbers({0, 0, 1});
  auto follows = ParameterDeclaration::description("follows", "the joint that moves it");
  follows.default_value = Value::list({});
  return {
      required_label("name", "name of the joint"),
      ParameterDeclaration::choice("type", "revolute", {"revolute", "prismatic"}, "how it moves"),
      length("a", 0.0, "along x_i"),
      angle("alpha", "about x_i"),
      length("d", 0.0, "along z_{i-1}; the joint value adds to it when prismatic"),
      angle("theta", "about z_{i-1}; the joint value adds to it when revolute"),
      point("position", "of the joint's frame in the frame of the link before"),
      roll_pitch_yaw("rotation", "of the joint's frame in the frame of the link before"),
      axis,
      required_numbers("limits", "rad or length", "lower and upper joint value"),
      ParameterDeclaration::number("torque_limit", unknown, 0.0, 1e6, "N m or N", "largest torque or force"),
      follows};
}

Joint read_joint(const Section& section, double metres) {
  Joint joint;
  joint.name = section.text("name");
  joint.prismatic = section.text("type") == "prismatic";
  joint.torque_limit = section.number("torque_limit");
  read_limits(section, metres, joint);
  return joint;
}

ChainJoint read_chain_joint(const Section& section, double metres) {
  const bool prismatic = section.text("type") == "prismatic";
  const char* by_axis = first_given(section, kByAxis);
  if (!by_axis) {
    return joint_of({metres * section.number("a"), section.number("alpha"), metres * section.number("d"),
                     section.number("theta")},
                    prismatic);
  }
  if (const char* by_parameters = first_given(section, kByParameters)) {
    section.refuse(
        by_axis,
        fmt::format("and '{}' exclude each other: give a joint by a, alpha, d, theta or by position, "
                    "rotation, axis",
                    by_parameters));
  }
  return joint_about({section.rotation("rotation"), metres * section.vector("position")}, read_axis(section),
                     prismatic);
}

void Couplings::note(const Section& joint, int follower) {
  if (!joint.has("follows")) return;
  const auto table = std::make_shared<const Value>(joint.given("follows"));
  couplings_.push_back({table, Section(joint.owner() + ", follows", coupling_keys(), *table, joint.place()), follower});
}

void Couplings::make(std::vector<Joint>& joints, double metres) const {
  for (const Coupling& coupling : couplings_) couple(coupling, joints, metres);
  for (const auto& [table, section, follower] : couplings_) {
    const int leader = joints[static_cast<std::size_t>(follower)].leader;
    if (joints[static_cast<std::size_t>(leader)].leader >= 0) {
      const std::string& own =
          joints[static_cast<std::size_t>(joints[static_cast<std::size_t>(leader)].leader)].name;
      section.refuse("joint", fmt::format("'{}' itself follows '{}'; follow that one",
                                          joints[static_cast<std::size_t>(leader)].name, own));
    }
    demand_room(section, joints, leader);
  }
}

void Couplings::couple(const Coupling& coupling, std::vector<Joint>& joints, double metres) {
  const Section& section = coupling.section;
  const std::string& name = section.text("joint");
  Joint& follower = joints[static_cast<std::size_t>(coupling.follower)];
  if (name == follower.name) section.refuse("joint", "is the joint itself; name another one");
  const auto leader =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == name; });
  if (leader == joints.end()) {
    std::vector<std::string> names;
    for (const Joint& joint : joints) {
      if (joint.name != follower.name) names.push_back(joint.name);
    }
    section.refuse("joint",
                   fmt::format("names no joint of the hand, got '{}'{}", name, did_you_mean(name, names)));
  }
  if (section.number("ratio") == 0.0) section.refuse("ratio", "must not be 0: such a joint would not move");
  const double unit = follower.prismatic ? metres : 1.0;
  follower.leader = static_cast<int>(leader - joints.begin());
  follower.ratio = section.number("ratio") * unit / (leader->prismatic ? metres : 1.0);
  follower.offset = section.number("offset") * unit;
}

}  // namespace preshape::dh
