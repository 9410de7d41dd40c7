#include <fmt/format.h>

#include "adapters.h"
#include "geometry_value.h"
#include "hand_reader.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "script/convert.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kForward };

constexpr double kDifference = 1e-6;  // [rad or m], of the Jacobian's central differences

/// A hand described in Lua. Its kinematics are those of Chain, unless it has a `forward` of its own.
class LuaHand final : public HandModel {
 public:
  LuaHand(const Value& instance, Blueprint blueprint)
      : hand_(read_hand(instance, blueprint.owner())),
        own_forward_(instance.find("forward") != nullptr),
        pool_(std::move(blueprint), {"forward"}) {
    if (own_forward_) try_forward();
  }

  const HandDimensions& dimensions() const noexcept override { return hand_.dimensions; }
  std::span<const Finger> fingers() const noexcept override { return hand_.fingers; }
  std::span<const Joint> joints() const noexcept override { return hand_.joints; }
  std::span<const LinkSolid> solids() const noexcept override { return hand_.solids; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    const Chain& chain = chain_of(finger);
    require_finite(pool_.blueprint().owner(), "joint values", q);
    if (!own_forward_) return chain.forward(q, poses_H);
    require_size("joint values", static_cast<std::size_t>(chain.joint_count()), q.size());
    require_size("poses", q.size() + 2, poses_H.size());
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
      refuse(place, owner,
             fmt::format("it must return {} poses, got {} for finger {} at {}", poses_H.size(), list.kind(),
                         finger + 1, text_of(q)));
    }
    for (std::size_t i = 0; i < poses_H.size(); ++i) {
      poses_H[i] = read_pose(list.items()[i], place, fmt::format("{}, pose {}", owner, i + 1));
    }
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    const Chain& chain = chain_of(finger);
    require_finite(pool_.blueprint().owner(), "joint values", q);
    if (!own_forward_) return chain.jacobian(q, jacobian);
    require_size("columns of the Jacobian", static_cast<std::size_t>(chain.joint_count()),
                 static_cast<std::size_t>(jacobian.cols()));
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
