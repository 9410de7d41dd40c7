#include <numbers>

#include <unsupported/Eigen/MatrixFunctions>

#include "preshape/base/error.h"
#include "preshape/hand/chain.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/hand");

namespace {

using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

Pose random_pose(Random& random) {
  const Eigen::Matrix3d R = random_rotation(random);
  return {R, random_vector(random)};
}

struct RandomChain {
  Pose X_HB, X_LD;
  std::vector<ChainJoint> joints;
  Chain chain() const { return {X_HB, joints, X_LD}; }
};

RandomChain random_chain(Random& random, int joint_count) {
  RandomChain parts{random_pose(random), random_pose(random), {}};
  for (int i = 0; i < joint_count; ++i) {
    const Pose X_PJ = random_pose(random);
    parts.joints.push_back({random.below(3) == 0, X_PJ, random_pose(random)});
  }
  return parts;
}

std::vector<double> random_values(Random& random, int count) {
  std::vector<double> q(static_cast<std::size_t>(count));
  for (double& value : q) value = random.uniform(-2, 2);
  return q;
}

std::vector<Pose> poses(const Chain& chain, const std::vector<double>& q) {
  std::vector<Pose> poses_H(q.size() + 2);
  chain.forward(q, poses_H);
  return poses_H;
}

Eigen::Matrix4d homogeneous(const Pose& X) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = X.R;
  matrix.topRightCorner<3, 1>() = X.p;
  return matrix;
}

/// Product of exponentials [MurrayLiSastry1994, ch. 3]: the twists of the joints at q = 0, then
/// exp(xi_1 q_1) .. exp(xi_n q_n) X_HD(0), each exponential as a general matrix function.
Eigen::Matrix4d product_of_exponentials(const RandomChain& parts, const std::vector<double>& q) {
  Eigen::Matrix4d X_HL = homogeneous(parts.X_HB), product = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Eigen::Matrix4d X_HJ = X_HL * homogeneous(parts.joints[i].X_PJ);
    Eigen::Matrix4d twist_J = Eigen::Matrix4d::Zero();
    if (parts.joints[i].prismatic) {
      twist_J(2, 3) = 1.0;
    } else {
      twist_J(0, 1) = -1.0;
      twist_J(1, 0) = 1.0;
    }
    const Eigen::Matrix4d twist_H = X_HJ * twist_J * X_HJ.inverse();
    product = product * Eigen::Matrix4d(twist_H * q[i]).exp();
    X_HL = X_HJ * homogeneous(parts.joints[i].X_JL);
  }
  return product * X_HL * homogeneous(parts.X_LD);
}

/// w of the rotation that leads from R to R_next = exp([w]) R, for small w.
Eigen::Vector3d small_rotation(const Eigen::Matrix3d& R, const Eigen::Matrix3d& R_next) {
  const Eigen::Matrix3d D = R_next * R.transpose();
  return 0.5 * Eigen::Vector3d(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
}

Jacobian central_differences(const Chain& chain, std::vector<double> q) {
  constexpr double kStep = 1e-5;
  Jacobian J(6, chain.joint_count());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const double q_i = q[i];
    q[i] = q_i + kStep;
    const Pose after = poses(chain, q).back();
    q[i] = q_i - kStep;
    const Pose before = poses(chain, q).back();
    q[i] = q_i;
    J.col(static_cast<Eigen::Index>(i)) << (after.p - before.p) / (2 * kStep),
        small_rotation(before.R, after.R) / (2 * kStep);
  }
  return J;
}

}  // namespace

TEST_CASE("Chain: its tip is where a product of exponentials puts it") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const RandomChain parts = random_chain(random, 1 + static_cast<int>(random.below(6)));
    const auto q = random_values(random, static_cast<int>(parts.joints.size()));
    CHECK_NEAR(homogeneous(poses(parts.chain(), q).back()), product_of_exponentials(parts, q), 1e-12);
  }
}

TEST_CASE("Chain: the Jacobian is the derivative of the tip's pose") {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const RandomChain parts = random_chain(random, 1 + static_cast<int>(random.below(6)));
    const Chain chain = parts.chain();
    const auto q = random_values(random, chain.joint_count());
    Jacobian J = Jacobian::Constant(6, chain.joint_count(), std::numeric_limits<double>::quiet_NaN());
    chain.jacobian(q, J);
    CHECK_NEAR(J, central_differences(chain, q), 1e-8);  // step 1e-5: truncation ~1e-9, rounding ~1e-10
  }
}

TEST_CASE("Chain: moving its base moves every link and the tip with it") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    RandomChain parts = random_chain(random, 4);
    const auto q = random_values(random, 4);
    const auto before = poses(parts.chain(), q);
    const Pose X = random_pose(random);
    parts.X_HB = X * parts.X_HB;
    const auto after = poses(parts.chain(), q);
    for (std::size_t k = 0; k < after.size(); ++k) {
      CHECK_NEAR(homogeneous(after[k]), homogeneous(X * before[k]), 200 * kEps);
    }
  }
}

TEST_CASE("Chain: a joint moves only the links behind it") {
  Random random(4);
  const RandomChain parts = random_chain(random, 5);
  auto q = random_values(random, 5);
  const auto before = poses(parts.chain(), q);
  q[2] += 0.3;
  const auto after = poses(parts.chain(), q);
  for (std::size_t k = 0; k <= 2; ++k) CHECK(homogeneous(after[k]) == homogeneous(before[k]));
  for (std::size_t k = 3; k <= 6; ++k) CHECK(homogeneous(after[k]) != homogeneous(before[k]));
}

TEST_CASE("Chain: two links in a plane end where trigonometry says") {
  const Pose along_x{Eigen::Matrix3d::Identity(), {1, 0, 0}};
  const Chain chain({}, {{false, {}, along_x}, {false, {}, along_x}}, {});
  const double third = std::numbers::pi / 3;
  CHECK_NEAR(poses(chain, {third, third}).back().p, Eigen::Vector3d(0, std::sqrt(3.0), 0), 4 * kEps);
  Jacobian J(6, 2);
  chain.jacobian(std::vector<double>{0, 0}, J);
  Jacobian expected(6, 2);
  expected << 0, 0, 2, 1, 0, 0, 0, 0, 0, 0, 1, 1;
  CHECK_NEAR(J, expected, 0);
}

TEST_CASE("Chain: a sliding joint moves the tip along its axis and does not turn it") {
  const Chain chain({}, {{true, {}, {}}}, {Eigen::Matrix3d::Identity(), {0, 0, 1}});
  CHECK_NEAR(poses(chain, {0.25}).back().p, Eigen::Vector3d(0, 0, 1.25), 0);
  Jacobian J(6, 1);
  chain.jacobian(std::vector<double>{0.25}, J);
  CHECK_NEAR(J, (Jacobian(6, 1) << 0, 0, 1, 0, 0, 0).finished(), 0);
}

TEST_CASE("Chain: buffers of another size are refused by number") {
  const Chain chain({}, {{}, {}}, {});
  std::vector<Pose> four(4), three(3);
  Jacobian J(6, 3);
  const std::vector<double> q = {0, 0}, longer = {0, 0, 0};
  CHECK_THROWS_SAYING(chain.forward(longer, four), InputError, "needs 2 joint values, got 3");
  CHECK_THROWS_SAYING(chain.forward(q, three), InputError, "needs 4 poses, got 3");
  CHECK_THROWS_SAYING(chain.jacobian(q, J), InputError, "needs 2 columns of the Jacobian, got 3");
}

TEST_SUITE_END();
