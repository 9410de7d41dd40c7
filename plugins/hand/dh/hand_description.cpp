#include "hand_description.h"

#include <algorithm>

#include <fmt/format.h>

#include "joint_section.h"
#include "section.h"
#include "turned.h"

namespace preshape::dh {

namespace {

const std::vector<std::string> kRoles = {"thumb", "index", "middle", "ring", "little"};

std::vector<ParameterDeclaration> hand_keys() {
  auto unit = ParameterDeclaration::number("unit_length", 0.0, 1e-6, 1.0, "m",
                                           "U: length of the middle finger's middle phalanx [m]");
  unit.default_value = Value{};
  return {ParameterDeclaration::choice("model", "dh", {"dh"}, "the plugin that reads this table"),
          optional_label("summary", "one line on the hand"),
          unit,
          ParameterDeclaration::choice("lengths", "m", {"m", "U"}, "unit of every length but unit_length"),
          positive_length("finger_spacing", "between neighbouring forefingers"),
          positive_length("maximum_opening", "from the middle of the grasp to an opened fingertip"),
          positive_length("base_width", "across the fingers"),
          optional_list("palm", "solids of the palm"),
          ParameterDeclaration::description("fingers", "list of fingers")};
}

std::vector<ParameterDeclaration> finger_keys() {
  auto role = ParameterDeclaration::choice("role", "", kRoles, "thumb, index, middle, ring or little");
  role.default_value = Value{};
  return {required_label("name", "name of the finger"),
          role,
          ParameterDeclaration::description("base", "pose of the finger's frame 0 in the hand base"),
          ParameterDeclaration::description("joints", "list of joints, base to tip"),
          point("tip", "fingertip in the last link's frame"),
          optional_list("links", "solids of the links")};
}

std::vector<ParameterDeclaration> base_keys() {
  return {point("position", "of frame 0 in the hand base"), roll_pitch_yaw("rotation", "of frame 0 in the hand base")};
}

ParameterDeclaration shape_key() {
  return ParameterDeclaration::choice("shape", "capsule", {"capsule", "sphere", "box"}, "what the solid is");
}

std::vector<ParameterDeclaration> solid_keys(bool of_link, const std::string& shape) {
  std::vector<ParameterDeclaration> keys = {shape_key()};
  if (of_link) {
    auto link = ParameterDeclaration::integer("link", 0, 0, 1000, "-", "0 = the finger's base, k = moved by joint k");
    link.default_value = Value{};
    keys.push_back(link);
  }
  if (shape == "box") {
    keys.insert(keys.end(), {point("centre", "of the box"), roll_pitch_yaw("rotation", "of the box"),
                             required_numbers("half_extents", "length", "half the box's size along its axes")});
  } else if (shape == "sphere") {
    keys.insert(keys.end(), {point("centre", "of the sphere"), positive_length("radius", "of the sphere")});
  } else {
    keys.insert(keys.end(), {required_numbers("from", "length", "centre of one end"),
                             required_numbers("to", "length", "centre of the other end"),
                             positive_length("radius", "of the capsule")});
  }
  return keys;
}

/// The shape decides which other keys there are, so it is checked before them.
std::string shape_of(const std::string& owner, const Value& table, const SourcePlace& place) {
  Value head = Value::table({});
  if (const Value* given = table.find("shape")) head.set("shape", *given);
  head.at(table.place());
  return Section(owner, {shape_key()}, head, place).text("shape");
}

std::string label_of(const char* what, std::size_t index, const Value& table) {
  const Value* name = table.find("name");
  if (!name || !name->is_string()) return fmt::format("{} {}", what, index + 1);
  return fmt::format("{} {} '{}'", what, index + 1, name->string());
}

class HandReader {
 public:
  explicit HandReader(const Value& table) : section_("hand description", hand_keys(), table, table.place()) {
    if (section_.text("lengths") == "U") metres_ = section_.number("unit_length");
  }

  HandDescription read() {
    hand_.dimensions = {section_.number("unit_length"), metres_ * section_.number("finger_spacing"),
                        metres_ * section_.number("maximum_opening"), metres_ * section_.number("base_width")};
    read_solids(section_, "palm", "solid", -1, 0);
    const auto fingers = section_.list("fingers");
    if (fingers.empty()) section_.refuse("fingers", "must have at least one finger");
    for (std::size_t i = 0; i < fingers.size(); ++i) read_finger(i, fingers[i]);
    couplings_.make(hand_.joints, metres_);
    return std::move(hand_);
  }

 private:
  void read_finger(std::size_t index, const Value& table);
  Pose read_base(const Section& finger) const;
  ChainJoint append_joint(const Section& finger, std::size_t index, const Value& table);
  void read_solids(const Section& section, const char* key, const char* what, int finger, int joint_count);
  LinkSolid read_solid(const std::string& owner, const Value& table, const SourcePlace& place, int finger,
                       int joint_count) const;

  Section section_;
  double metres_ = 1.0;  ///< one length unit of the file
  HandDescription hand_;
  Couplings couplings_;
};

void HandReader::read_finger(std::size_t index, const Value& table) {
  const Section section(label_of("finger", index, table), finger_keys(), table, section_.place());
  Finger finger;
  finger.name = section.text("name");
  const auto role = std::find(kRoles.begin(), kRoles.end(), section.text("role"));
  finger.role = static_cast<FingerRole>(role - kRoles.begin());
  for (const Finger& other : hand_.fingers) {
    if (other.name == finger.name) section.refuse("name", fmt::format("'{}' is taken by another finger", finger.name));
    if (other.role == finger.role) {
      section.refuse("role", fmt::format("'{}' is taken by finger '{}'", section.text("role"), other.name));
    }
  }

  const auto joints = section.list("joints");
  if (joints.empty()) section.refuse("joints", "must have at least one joint");
  finger.first_joint = static_cast<int>(hand_.joints.size());
  finger.joint_count = static_cast<int>(joints.size());
  std::vector<ChainJoint> chain;
  for (std::size_t k = 0; k < joints.size(); ++k) chain.push_back(append_joint(section, k, joints[k]));
  const Pose X_LD{Eigen::Matrix3d::Identity(), metres_ * section.vector("tip")};
  hand_.chains.emplace_back(read_base(section), std::move(chain), X_LD);
  read_solids(section, "links", "link solid", static_cast<int>(index), finger.joint_count);
  hand_.fingers.push_back(std::move(finger));
}

Pose HandReader::read_base(const Section& finger) const {
  const Section base(finger.owner() + ", base", base_keys(), finger.value("base"), finger.place());
  return {base.rotation("rotation"), metres_ * base.vector("position")};
}

ChainJoint HandReader::append_joint(const Section& finger, std::size_t index, const Value& table) {
  const std::string owner = finger.owner() + ", " + label_of("joint", index, table);
  const Section section(owner, joint_keys(), table, finger.place());
  Joint joint = read_joint(section, metres_);
  for (const Joint& other : hand_.joints) {
    if (other.name == joint.name) section.refuse("name", fmt::format("'{}' is taken by another joint", joint.name));
  }
  couplings_.note(section, static_cast<int>(hand_.joints.size()));
  hand_.joints.push_back(std::move(joint));
  return read_chain_joint(section, metres_);
}

void HandReader::read_solids(const Section& section, const char* key, const char* what, int finger, int joint_count) {
  const auto solids = section.list(key);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const std::string owner = fmt::format("{}, {} {}", finger < 0 ? "palm" : section.owner(), what, i + 1);
    hand_.solids.push_back(read_solid(owner, solids[i], section.place(), finger, joint_count));
  }
}

LinkSolid HandReader::read_solid(const std::string& owner, const Value& table, const SourcePlace& place, int finger,
                                 int joint_count) const {
  const std::string shape = shape_of(owner, table, place);
  const Section section(owner, solid_keys(finger >= 0, shape), table, place);

  LinkSolid link;
  link.finger = finger;
  if (finger >= 0) {
    link.link = static_cast<int>(section.number("link"));
    if (link.link > joint_count) {
      section.refuse("link", fmt::format("must be at most {}, the finger's number of joints, got {}", joint_count,
                                         link.link));
    }
  }
  if (shape == "box") {
    link.solid.kind = Solid::Kind::kBox;
    link.solid.half_extents = metres_ * section.vector("half_extents");
    if (link.solid.half_extents.minCoeff() <= 0.0) {
      section.refuse("half_extents", fmt::format("must be positive, got {}", section.value("half_extents").text()));
    }
    link.X_LS = {section.rotation("rotation"), metres_ * section.vector("centre")};
  } else if (shape == "sphere") {
    link.solid.kind = Solid::Kind::kSphere;
    link.solid.radius = metres_ * section.number("radius");
    link.X_LS.p = metres_ * section.vector("centre");
  } else {
    const Eigen::Vector3d from = metres_ * section.vector("from"), to = metres_ * section.vector("to");
    link.solid.kind = Solid::Kind::kCapsule;
    link.solid.radius = metres_ * section.number("radius");
    link.solid.half_length = 0.5 * (to - from).norm();
    if (link.solid.half_length > 0.0) link.X_LS.R = z_along(to - from);
    link.X_LS.p = 0.5 * (from + to);
  }
  return link;
}

}  // namespace

HandDescription read_hand(const Value& table) { return HandReader(table).read(); }

}  // namespace preshape::dh
