#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "adapters.h"
#include "geometry_value.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/hand/chain.h"
#include "script/convert.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kForward };

constexpr double kLongest = 1000.0;      // [m]
constexpr double kWidest = 1000.0;       // [rad or m], of a joint value
constexpr double kDifference = 1e-6;     // [rad or m], of the Jacobian's central differences

/// Everything that a hand's instance says, checked.
struct HandData {
  HandDimensions dimensions;
  std::vector<Finger> fingers;
  std::vector<Joint> joints;
  std::vector<Chain> chains;
  std::vector<LinkSolid> solids;
};

class HandReader {
 public:
  HandReader(const Value& instance, std::string owner) : place_(instance.place()), owner_(std::move(owner)) {
    const Keys keys{owner_,
                    {required_table("dimensions", "sizes of the hand"), required_table("fingers", "list of fingers"),
                     optional_table("solids", "list of solids")},
                    {}, {"forward"}, {}};
    values_ = keys.check(instance, {});
  }

  HandData read() {
    read_dimensions(values_.value("dimensions"));
    const auto& fingers = list(values_.value("fingers"), "fingers");
    if (fingers.empty()) refuse(place_, owner_, "'fingers' must have at least one finger");
    for (const Value& finger : fingers) read_finger(finger);
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
    const Keys keys{owner_ + ", dimensions",
                    {required_number("unit_length", least, kLongest, "m", "U: middle phalanx of the middle finger"),
                     required_number("finger_spacing", least, kLongest, "m", "between neighbouring forefingers"),
                     required_number("maximum_opening", least, kLongest, "m", "fingertip to the middle of the grasp"),
                     required_number("base_width", least, kLongest, "m", "across the fingers")},
                    {}, {}, {}};
    const Parameters p = keys.check(table, place_);
    hand_.dimensions = {p.number("unit_length"), p.number("finger_spacing"), p.number("maximum_opening"), p.number("base_width")};
  }

  void read_finger(const Value& table) {
    const std::string what = fmt::format("{}, finger {}", owner_, hand_.fingers.size() + 1);
    const SourcePlace& place = place_of(table, place_);
    const Keys keys{what,
                    {required_text("name", "of the finger"), required_choice("role", role_names(), "which finger it is"),
                     optional_table("base", "pose of its base in the hand"), required_table("joints", "list, base to tip"),
                     optional_table("tip", "pose of the tip in the last link")},
                    {}, {}, {}};
    const Parameters p = keys.check(table, place);
    Finger finger{p.text("name"), role_of(p.text("role")), static_cast<int>(hand_.joints.size()), 0};
    for (const Finger& other : hand_.fingers) {
      if (other.name == finger.name || other.role == finger.role) refuse(place, what, "its name or role is another finger's");
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
    const Keys keys{what,
                    {required_text("name", "of the joint"), ParameterDeclaration::flag("prismatic", false, "slides"),
                     required_number("lower", -kWidest, kWidest, "rad or m", "smallest value"),
                     required_number("upper", -kWidest, kWidest, "rad or m", "largest value"),
                     ParameterDeclaration::number("torque_limit", unknown, 0.0, 1e6, "N m or N", "largest torque or force"),
                     optional_table("X_PJ", "joint in the link before"), optional_table("X_JL", "link in the joint")},
                    {}, {}, {}};
    const Parameters p = keys.check(table, place);
    const Joint joint{p.text("name"), p.flag("prismatic"), p.number("lower"), p.number("upper"), p.number("torque_limit")};
    if (joint.lower > joint.upper) refuse(place, what, "'lower' is above 'upper'");
    for (const Joint& other : hand_.joints) {
      if (other.name == joint.name) refuse(place, what, fmt::format("'{}' is another joint's name", joint.name));
    }
    hand_.joints.push_back(joint);
    return {joint.prismatic, read_pose(p.value("X_PJ"), place, what + ", X_PJ"), read_pose(p.value("X_JL"), place, what + ", X_JL")};
  }

  void read_solid_of(const Value& table) {
    const std::string what = fmt::format("{}, solid {}", owner_, hand_.solids.size() + 1);
    const SourcePlace& place = place_of(table, place_);
    Keys keys{what, solid_keys(), {}, {}, {}};
    keys.data.push_back(ParameterDeclaration::label("finger", "", "name of its finger; none: the palm"));
    keys.data.push_back(ParameterDeclaration::integer("link", 0, 0, 1000, "-", "0: the finger's base, k: moved by its first k joints"));
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
    if (!finger.empty() && link.finger < 0) refuse(place, what, fmt::format("there is no finger '{}'", finger));
    const int most = link.finger < 0 ? 0 : hand_.fingers[static_cast<std::size_t>(link.finger)].joint_count;
    if (link.link > most) refuse(place, what, fmt::format("'link' must be at most {}, got {}", most, link.link));
    hand_.solids.push_back(link);
  }

  SourcePlace place_;
  std::string owner_;
  Parameters values_;
  HandData hand_;
};

/// A hand described in Lua. Its kinematics are those of Chain, unless it has a `forward` of its own.
class LuaHand final : public HandModel {
 public:
  LuaHand(const Value& instance, Blueprint blueprint)
      : hand_(HandReader(instance, blueprint.owner()).read()), own_forward_(instance.find("forward") != nullptr),
        pool_(std::move(blueprint), {"forward"}) {
    if (own_forward_) try_forward();
  }

  const HandDimensions& dimensions() const noexcept override { return hand_.dimensions; }
  std::span<const Finger> fingers() const noexcept override { return hand_.fingers; }
  std::span<const Joint> joints() const noexcept override { return hand_.joints; }
  std::span<const LinkSolid> solids() const noexcept override { return hand_.solids; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    const Chain& chain = chain_of(finger);
    if (!own_forward_) return chain.forward(q, poses_H);
    require_size("joint values", static_cast<std::size_t>(chain.joint_count()), q.size());
    require_size("poses", q.size() + 2, poses_H.size());
    require_finite(pool_.blueprint().owner(), "joint values", q);
    const StatePool::Lease state(pool_);
    Value list;
    SourcePlace place;
    state->host().enter([&](lua_State* L) {
      state->push(kForward);
      place = definition(L, -1);
      lua_pushinteger(L, finger + 1);
      push_numbers(L, q);
      lua_call(L, 2, 1);
      list = lua::to_value(L, -1, place);
    });
    const std::string owner = pool_.blueprint().owner() + ", forward";
    if (!list.is_list() || list.items().size() != poses_H.size()) {
      refuse(place, owner, fmt::format("it must return {} poses, got {} for finger {} at {}", poses_H.size(), list.kind(), finger + 1, text_of(q)));
    }
    for (std::size_t i = 0; i < poses_H.size(); ++i) {
      poses_H[i] = read_pose(list.items()[i], place, fmt::format("{}, pose {}", owner, i + 1));
    }
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    const Chain& chain = chain_of(finger);
    if (!own_forward_) return chain.jacobian(q, jacobian);
    require_size("columns of the Jacobian", static_cast<std::size_t>(chain.joint_count()), static_cast<std::size_t>(jacobian.cols()));
    const Pose X_HD = tip(finger, q);
    std::vector<double> moved(q.begin(), q.end());
    for (std::size_t k = 0; k < q.size(); ++k) {
      moved[k] = q[k] + kDifference;
      const Pose after = tip(finger, moved);
      moved[k] = q[k] - kDifference;
      const Pose before = tip(finger, moved);
      moved[k] = q[k];
      // dR R^T is the angular velocity as a skew matrix.
      const Eigen::Matrix3d spin = (after.R - before.R) / (2.0 * kDifference) * X_HD.R.transpose();
      jacobian.col(static_cast<Eigen::Index>(k)) << (after.p - before.p) / (2.0 * kDifference),
          0.5 * (spin(2, 1) - spin(1, 2)), 0.5 * (spin(0, 2) - spin(2, 0)), 0.5 * (spin(1, 0) - spin(0, 1));
    }
  }

 private:
  const Chain& chain_of(int finger) const {
    if (finger < 0 || finger >= static_cast<int>(hand_.chains.size())) {
      throw InputError(fmt::format("the hand has fingers 0 .. {}, got {}", hand_.chains.size() - 1, finger));
    }
    return hand_.chains[static_cast<std::size_t>(finger)];
  }

  Pose tip(int finger, std::span<const double> q) const {
    std::vector<Pose> poses(q.size() + 2);
    forward(finger, q, poses);
    return poses.back();
  }

  /// So that a mistake in it is told when the hand is made.
  void try_forward() const {
    for (std::size_t i = 0; i < hand_.fingers.size(); ++i) {
      std::vector<double> q;
      for (int k = 0; k < hand_.fingers[i].joint_count; ++k) {
        const Joint& joint = hand_.joints[static_cast<std::size_t>(hand_.fingers[i].first_joint + k)];
        q.push_back(0.5 * (joint.lower + joint.upper));
      }
      tip(static_cast<int>(i), q);
    }
  }

  HandData hand_;
  bool own_forward_;
  StatePool pool_;
};

}  // namespace

std::shared_ptr<HandModel> make_hand(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  return std::make_shared<LuaHand>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
