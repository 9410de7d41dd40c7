#include "hand_reader.h"

#include <limits>

#include <fmt/format.h>

#include "couplings.h"
#include "geometry_value.h"
#include "keys.h"

namespace preshape::scripted {

namespace {

constexpr double kLongest = 1000.0;  // [m]
constexpr double kWidest = 1000.0;   // [rad or m], of a joint value

class HandReader {
 public:
  HandReader(const Value& instance, std::string owner) : place_(instance.place()), owner_(std::move(owner)) {
    const Keys keys{
        owner_,
        {required_table("dimensions", "sizes of the hand"), required_table("fingers", "list of fingers"),
         optional_table("solids", "list of solids")},
        {},
        {"forward"},
        {}};
    values_ = keys.check(instance, {});
  }

  HandData read() {
    read_dimensions(values_.value("dimensions"));
    const auto& fingers = list(values_.value("fingers"), "fingers");
    if (fingers.empty()) refuse(place_, owner_, "'fingers' must have at least one finger");
    for (const Value& finger : fingers) read_finger(finger);
    couplings_.make(hand_.joints);
    for (const Value& solid : list(values_.value("solids"), "solids")) read_solid_of(solid);
    return std::move(hand_);
  }

 private:
  const Value::List& list(const Value& value, const char* key) const {
    if (!value.is_list()) refuse(place_of(value, place_), owner_, fmt::format("'{}' must be a list", key));
    return value.items();
  }

  void read_dimensions(const Value& table) {
    const double least = 1e-6;
    const Keys keys{
        owner_ + ", dimensions",
        {required_number("unit_length", least, kLongest, "m", "U: middle phalanx of the middle finger"),
         required_number("finger_spacing", least, kLongest, "m", "between neighbouring forefingers"),
         required_number("maximum_opening", least, kLongest, "m", "fingertip to the middle of the grasp"),
         required_number("base_width", least, kLongest, "m", "across the fingers")},
        {},
        {},
        {}};
    const Parameters p = keys.check(table, place_);
    hand_.dimensions = {p.number("unit_length"), p.number("finger_spacing"), p.number("maximum_opening"),
                        p.number("base_width")};
  }

  void read_finger(const Value& table) {
    const std::string what = fmt::format("{}, finger {}", owner_, hand_.fingers.size() + 1);
    const SourcePlace& place = place_of(table, place_);
    const Keys keys{
        what,
        {required_text("name", "of the finger"), required_choice("role", role_names(), "which finger it is"),
         optional_table("base", "pose of its base in the hand"),
         required_table("joints", "list, base to tip"),
         optional_table("tip", "pose of the tip in the last link")},
        {},
        {},
        {}};
    const Parameters p = keys.check(table, place);
    Finger finger{p.text("name"), role_of(p.text("role")), static_cast<int>(hand_.joints.size()), 0};
    for (const Finger& other : hand_.fingers) {
      if (other.name == finger.name || other.role == finger.role)
        refuse(place, what, "its name or role is another finger's");
    }
    std::vector<ChainJoint> chain;
    for (const Value& joint : list(p.value("joints"), "joints")) {
      chain.push_back(read_joint(joint, place, fmt::format("{}, joint {}", what, chain.size() + 1)));
    }
    if (chain.empty()) refuse(place, what, "'joints' must have at least one joint");
    finger.joint_count = static_cast<int>(chain.size());
    hand_.chains.emplace_back(read_pose(p.value("base"), place, what + ", base"), std::move(chain),
                              read_pose(p.value("tip"), place, what + ", tip"));
    hand_.fingers.push_back(std::move(finger));
  }

  ChainJoint read_joint(const Value& table, const SourcePlace& enclosing, const std::string& what) {
    const SourcePlace& place = place_of(table, enclosing);
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    const Keys keys{
        what,
        {required_text("name", "of the joint"), ParameterDeclaration::flag("prismatic", false, "slides"),
         optional_table("follows", "joint that moves it, with ratio and offset"),
         required_number("lower", -kWidest, kWidest, "rad or m", "smallest value"),
         required_number("upper", -kWidest, kWidest, "rad or m", "largest value"),
         ParameterDeclaration::number("torque_limit", unknown, 0.0, 1e6, "N m or N",
                                      "largest torque or force"),
         optional_table("X_PJ", "joint in the link before"), optional_table("X_JL", "link in the joint")},
        {},
        {},
        {}};
    const Parameters p = keys.check(table, place);
    const Joint joint{p.text("name"), p.flag("prismatic"), p.number("lower"), p.number("upper"),
                      p.number("torque_limit")};
    if (joint.lower > joint.upper) refuse(place, what, "'lower' is above 'upper'");
    for (const Joint& other : hand_.joints) {
      if (other.name == joint.name)
        refuse(place, what, fmt::format("'{}' is another joint's name", joint.name));
    }
    if (table.find("follows"))
      couplings_.note(p.value("follows"), place, what, static_cast<int>(hand_.joints.size()));
    hand_.joints.push_back(joint);
    return {joint.prismatic, read_pose(p.value("X_PJ"), place, what + ", X_PJ"),
            read_pose(p.value("X_JL"), place, what + ", X_JL")};
  }

  void read_solid_of(const Value& table) {
    const std::string what = fmt::format("{}, solid {}", owner_, hand_.solids.size() + 1);
    const SourcePlace& place = place_of(table, place_);
    Keys keys{what, solid_keys(), {}, {}, {}};
    keys.data.push_back(ParameterDeclaration::label("finger", "", "name of its finger; none: the palm"));
    keys.data.push_back(ParameterDeclaration::integer(
        "link", 0, 0, 1000, "-", "0: the finger's base, k: moved by its first k joints"));
    keys.data.push_back(optional_table("X_LS", "solid in the link"));
    const Parameters p = keys.check(table, place);
    LinkSolid link;
    link.solid = read_solid(p, place, what);
    link.link = static_cast<int>(p.integer("link"));
    link.X_LS = read_pose(p.value("X_LS"), place, what + ", X_LS");
    const std::string& finger = p.text("finger");
    for (std::size_t i = 0; i < hand_.fingers.size(); ++i) {
      if (hand_.fingers[i].name == finger) link.finger = static_cast<int>(i);
    }
    if (!finger.empty() && link.finger < 0)
      refuse(place, what, fmt::format("there is no finger '{}'", finger));
    const int most = link.finger < 0 ? 0 : hand_.fingers[static_cast<std::size_t>(link.finger)].joint_count;
    if (link.link > most)
      refuse(place, what, fmt::format("'link' must be at most {}, got {}", most, link.link));
    hand_.solids.push_back(link);
  }

  SourcePlace place_;
  std::string owner_;
  Parameters values_;
  HandData hand_;
  Couplings couplings_;
};

}  // namespace

HandData read_hand(const Value& instance, const std::string& owner) {
  return HandReader(instance, owner).read();
}

}  // namespace preshape::scripted
