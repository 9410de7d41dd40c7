// Postures of a small hand whose joints follow one another by ratios and offsets of either sign.
#include <limits>

#include "preshape/base/error.h"
#include "preshape/hand/chain.h"
#include "preshape/hand/manipulability.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/hand");

namespace {

/// One finger of three parallel joints, 10 cm, 5 cm and 2 cm long; the second follows the first backwards, the third has a
/// drive of its own.
class Claw final : public HandModel {
 public:
  Claw() : chain_({}, {link(0.1), link(0.05), link(0.02)}, {}) {
    joints_[0] = {"lead", false, -1.0, 2.0, 1.0};
    joints_[1] = {"follow", false, -1.0, 0.6, 1.0, 0, -2.0, 0.5};
    joints_[2] = {"free", false, 0.2, 0.6, 1.0};
  }
  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return {&finger_, 1}; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return {}; }
  void forward(int, std::span<const double> q, std::span<Pose> poses_H) const override { chain_.forward(q, poses_H); }
  void jacobian(int, std::span<const double> q, Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> J) const override {
    chain_.jacobian(q, J);
  }

 private:
  static ChainJoint link(double length_m) { return {false, {}, {Eigen::Matrix3d::Identity(), {length_m, 0, 0}}}; }

  Chain chain_;
  Joint joints_[3];
  Finger finger_{"claw", FingerRole::kIndex, 0, 3};
  HandDimensions dimensions_{0.05, 0.05, 0.1, 0.1};
};

}  // namespace

TEST_CASE("Posture: a drive's range is what its follower leaves of it, also where the ratio is negative") {
  const Claw claw;
  CHECK(driven_joints(claw) == std::vector<int>{0, 2});
  const DriveRange lead = drive_range(claw, 0), free = drive_range(claw, 2);
  CHECK_NEAR(lead.lower, -0.05, 1e-15);  // follow = -2 lead + 0.5 is in -1 .. 0.6
  CHECK_NEAR(lead.upper, 0.75, 1e-15);
  CHECK(free.lower == 0.2);
  CHECK(free.upper == 0.6);
}

TEST_CASE("Posture: the middle one has every drive in the middle of its range and every follower where its leader puts it") {
  const Posture middle = middle_posture(Claw());
  CHECK_NEAR(middle[0], 0.35, 1e-15);
  CHECK_NEAR(middle[1], -0.2, 1e-15);
  CHECK_NEAR(middle[2], 0.4, 1e-15);
  Posture posture = {0.5, 9.0, 0.3};
  apply_couplings(Claw(), posture);
  CHECK(posture == Posture{0.5, -0.5, 0.3});
  CHECK_THROWS_SAYING(apply_couplings(Claw(), std::span(posture).first(2)), InputError, "posture");
}

TEST_CASE("Posture: limits count at both ends, to the tolerance, and what is no number is not within them") {
  const Claw claw;
  CHECK(within_limits(claw, Posture{2.0, 0.6, 0.2}));
  CHECK_FALSE(within_limits(claw, Posture{2.1, 0.6, 0.2}));
  CHECK_FALSE(within_limits(claw, Posture{2.0, 0.6, 0.1}));
  CHECK(within_limits(claw, Posture{2.1, 0.7, 0.1}, 0.11));
  CHECK_FALSE(within_limits(claw, Posture{2.1, 0.7, 0.05}, 0.11));
  CHECK_FALSE(within_limits(claw, Posture{2.0, std::numeric_limits<double>::quiet_NaN(), 0.2}, 1.0));
  CHECK_THROWS_SAYING(within_limits(claw, Posture{0.0}), InputError, "posture");
}

TEST_CASE("Manipulability: a plane finger of two drives has two singular values and none across its plane") {
  const Claw claw;
  const Posture posture = middle_posture(claw);
  const auto m = manipulability(claw, 0, posture);
  CHECK(m.singular_values[1] > 1e-4);
  CHECK(m.singular_values[2] < 1e-15);
  CHECK(m.measure < 1e-15);
  CHECK_NEAR(m.axes_H.col(2).cwiseAbs(), Eigen::Vector3d::UnitZ(), 1e-12);
  // The leader moves both joints: the second turns twice as far, backwards.
  Eigen::Matrix<double, 6, Eigen::Dynamic> own(6, 3);
  claw.jacobian(0, posture, own);
  CHECK_NEAR(drive_jacobian(claw, 0, posture).col(0), (own.col(0) - 2.0 * own.col(1)).eval(), 1e-15);
}

TEST_SUITE_END();
