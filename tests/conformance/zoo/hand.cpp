// Hands that are broken on purpose: each fails the check that its name begins with, and nothing else.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/hand/chain.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

enum class Fault {
  kNone,
  kTwins,
  kStretches,
  kJumps,
  kCouples,
  kMomentFirst,
  kClamps,
  kNoSuchLink,
  kOneLonger,
  kAnyFinger,
};

/// Sideways, then two bends and a slide at the end.
constexpr int kJoints = 4;

Pose turned(double angle, const Eigen::Vector3d& axis, const Eigen::Vector3d& p) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), p};
}

Chain finger_chain(double x, double y, double yaw, double longer) {
  const double quarter = std::numbers::pi / 2;
  std::vector<ChainJoint> joints = {{false, {}, turned(quarter, Eigen::Vector3d::UnitX(), {0.01, 0, 0})},
                                    {false, {}, {Eigen::Matrix3d::Identity(), {0.04 + longer, 0, 0}}},
                                    {false, {}, {Eigen::Matrix3d::Identity(), {0.03, 0, 0}}},
                                    {true,
                                     turned(quarter, Eigen::Vector3d::UnitY(), {0, 0, 0}),
                                     {Eigen::Matrix3d::Identity(), {0, 0, 0.01}}}};
  return Chain(turned(yaw, Eigen::Vector3d::UnitZ(), {x, y, 0}), std::move(joints),
               {Eigen::Matrix3d::Identity(), {0, 0, 0.005}});
}

/// A thumb against two fingers, and one broken rule.
template <Fault fault>
class Hand final : public HandModel {
 public:
  static std::vector<std::string> capabilities() {
    if constexpr (fault == Fault::kNone) return {"identical_fingers", "propagates_nonfinite"};
    if constexpr (fault == Fault::kOneLonger) return {"identical_fingers"};
    return {};
  }

  explicit Hand(const Parameters&) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    constexpr FingerRole kRoles[] = {FingerRole::kThumb, FingerRole::kIndex, FingerRole::kMiddle};
    const char* const names[] = {"thumb", "index", "middle"};
    for (int f = 0; f < 3; ++f) {
      fingers_.push_back({names[f], kRoles[f], f * kJoints, kJoints});
      const std::string name = fault == Fault::kTwins && f == 2 ? names[1] : names[f];
      joints_.push_back({name + "_side", false, -0.6, 0.6, 1.0});
      joints_.push_back({name + "_root", false, -0.3, 1.5, 1.0});
      joints_.push_back({name + "_middle", false, 0.0, 1.7, kUnknown});
      joints_.push_back({name + "_slide", true, 0.0, 0.02, kUnknown});
      solids_.push_back({f,
                         2,
                         {Solid::Kind::kCapsule, 0.008, 0.02, Eigen::Vector3d::Zero()},
                         turned(std::numbers::pi / 2, Eigen::Vector3d::UnitY(), {-0.02, 0, 0})});
    }
    if (fault == Fault::kNoSuchLink) solids_.back().link = kJoints + 1;
    chains_ = {finger_chain(-0.03, 0, std::numbers::pi, 0), finger_chain(0.03, 0.02, 0, 0),
               finger_chain(0.03, -0.02, 0, fault == Fault::kOneLonger ? 0.001 : 0.0)};
  }

  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return fingers_; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return solids_; }

  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    chain(finger).forward(inner(q), poses_H);
    if (fault == Fault::kStretches) {
      for (Pose& X : poses_H) X.R *= 1.000001;
    }
  }

  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    chain(finger).jacobian(inner(q), jacobian);
    if (fault == Fault::kCouples) jacobian.col(1) += 0.5 * jacobian.col(2);
    if (fault == Fault::kMomentFirst) {
      const Eigen::Matrix<double, 3, Eigen::Dynamic> linear = jacobian.topRows<3>();
      jacobian.topRows<3>() = jacobian.bottomRows<3>().eval();
      jacobian.bottomRows<3>() = linear;
    }
  }

 private:
  const Chain& chain(int finger) const {
    if (fault == Fault::kAnyFinger) return chains_[static_cast<std::size_t>(std::abs(finger) % 3)];
    if (finger < 0 || finger >= 3)
      throw InputError(fmt::format("the hand has fingers 0 .. 2, got {}", finger));
    return chains_[static_cast<std::size_t>(finger)];
  }

  /// What the chain is given for the caller's joint values; a wrong number of them goes on to the chain,
  /// which refuses it.
  std::vector<double> inner(std::span<const double> given) const {
    std::vector<double> q(given.begin(), given.end());
    if (q.size() != kJoints) return q;
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (fault == Fault::kClamps) q[i] = std::clamp(q[i], joints_[i].lower, joints_[i].upper);
      if (fault == Fault::kJumps && std::abs(q[i]) >= std::numbers::pi) q[i] += 0.1;
    }
    if (fault == Fault::kCouples) q[2] += 0.5 * q[1];
    return q;
  }

  HandDimensions dimensions_{0.03, 0.04, 0.1, 0.08};
  std::vector<Finger> fingers_;
  std::vector<Joint> joints_;
  std::vector<LinkSolid> solids_;
  std::vector<Chain> chains_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"zoo_hand", "1.0.0", "BSD-3-Clause", "the preshape developers", "Broken hands"}),
    ({"hand/good", "hand/h01_twins", "hand/h02_stretches", "hand/h03_jumps", "hand/h05_couples",
      "hand/h06_moment_first", "hand/h09_clamps", "hand/h13_no_such_link", "hand/h16_one_longer",
      "hand/h18_any_finger"}),
    component<Hand<Fault::kNone>>("good", "A thumb against two fingers"),
    component<Hand<Fault::kTwins>>("h01_twins", "Names joints of two fingers the same"),
    component<Hand<Fault::kStretches>>("h02_stretches", "Has rotations that stretch"),
    component<Hand<Fault::kJumps>>("h03_jumps", "Jumps where a joint has made half a turn"),
    component<Hand<Fault::kCouples>>("h05_couples", "Moves two joints with one"),
    component<Hand<Fault::kMomentFirst>>("h06_moment_first", "Has the Jacobian's angular rows first"),
    component<Hand<Fault::kClamps>>("h09_clamps", "Cuts joint values at their limits"),
    component<Hand<Fault::kNoSuchLink>>("h13_no_such_link", "Has a solid beyond its last link"),
    component<Hand<Fault::kOneLonger>>("h16_one_longer", "Calls fingers of two lengths identical"),
    component<Hand<Fault::kAnyFinger>>("h18_any_finger", "Answers for fingers that it does not have"))
