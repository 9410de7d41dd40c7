#include <numbers>
#include <thread>

#include <unsupported/Eigen/MatrixFunctions>

#include "dh_samples.h"
#include "preshape/base/error.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

using std::numbers::pi;

/// A row of a Denavit-Hartenberg table.
struct Row {
  double a, alpha, d, theta;
  bool prismatic;
};

struct RandomFinger {
  std::vector<Row> rows;
  Eigen::Vector3d position, rpy, tip;
  Value description;
};

RandomFinger random_finger(Random& random, int joint_count) {
  RandomFinger finger{{}, random_vector(random), random_vector(random) * pi, random_vector(random), {}};
  Value::List joints;
  for (int i = 0; i < joint_count; ++i) {
    const Eigen::Vector3d lengths = random_vector(random), angles = random_vector(random) * pi;
    const Row row{lengths.x(), angles.x(), lengths.y(), angles.y(), random.below(4) == 0};
    finger.rows.push_back(row);
    joints.push_back(joint_table(fmt::format("j{}", i), row.a, row.alpha, row.d, row.theta,
                                 row.prismatic ? "prismatic" : "revolute"));
  }
  const auto numbers = [](const Eigen::Vector3d& v) { return Value::numbers({v.x(), v.y(), v.z()}); };
  Value table = finger_table("index", std::move(joints));
  table.set("base", Value::table({{"position", numbers(finger.position)}, {"rotation", numbers(finger.rpy)}}));
  table.set("tip", numbers(finger.tip));
  finger.description = hand_table({std::move(table)});
  return finger;
}

/// The matrix of one row as the textbook prints it [FuGonzalezLee1987, ch. 2].
Eigen::Matrix4d textbook_matrix(const Row& row) {
  const double c = std::cos(row.theta), s = std::sin(row.theta);
  const double ca = std::cos(row.alpha), sa = std::sin(row.alpha);
  Eigen::Matrix4d A;
  A << c, -ca * s, sa * s, row.a * c,  //
      s, ca * c, -sa * c, row.a * s,   //
      0, sa, ca, row.d,                //
      0, 0, 0, 1;
  return A;
}

Eigen::Matrix4d base_matrix(const RandomFinger& finger) {
  const double r = finger.rpy.x(), p = finger.rpy.y(), y = finger.rpy.z();
  Eigen::Matrix3d Rx, Ry, Rz;
  Rx << 1, 0, 0, 0, std::cos(r), -std::sin(r), 0, std::sin(r), std::cos(r);
  Ry << std::cos(p), 0, std::sin(p), 0, 1, 0, -std::sin(p), 0, std::cos(p);
  Rz << std::cos(y), -std::sin(y), 0, std::sin(y), std::cos(y), 0, 0, 0, 1;
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.topLeftCorner<3, 3>() = Rz * Ry * Rx;
  X.topRightCorner<3, 1>() = finger.position;
  return X;
}

/// exp(xi_1 q_1) .. exp(xi_n q_n) X_HD(0): joint i turns about, or slides along, z_{i-1} as it stands at q = 0.
Eigen::Matrix4d product_of_exponentials(const RandomFinger& finger, const std::vector<double>& q) {
  Eigen::Matrix4d X = base_matrix(finger), product = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < q.size(); ++i) {
    Eigen::Matrix4d twist = Eigen::Matrix4d::Zero();
    if (finger.rows[i].prismatic) {
      twist(2, 3) = 1;
    } else {
      twist(0, 1) = -1;
      twist(1, 0) = 1;
    }
    product = product * Eigen::Matrix4d(X * twist * X.inverse() * q[i]).exp();
    X = X * textbook_matrix(finger.rows[i]);
  }
  Eigen::Matrix4d X_LD = Eigen::Matrix4d::Identity();
  X_LD.topRightCorner<3, 1>() = finger.tip;
  return product * X * X_LD;
}

Eigen::Matrix4d matrix(const Pose& X) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = X.R;
  M.topRightCorner<3, 1>() = X.p;
  return M;
}

std::vector<double> random_values(Random& random, std::size_t count) {
  std::vector<double> q(count);
  for (double& value : q) value = random.uniform(-3, 3);
  return q;
}

}  // namespace

TEST_CASE("DH: the tip is where the textbook's matrices and a product of exponentials put it") {
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    const RandomFinger finger = random_finger(random, 1 + static_cast<int>(random.below(5)));
    const auto hand = make_hand(finger.description);
    for (int k = 0; k < 20; ++k) {
      const auto q = random_values(random, finger.rows.size());
      CHECK_NEAR(matrix(forward(*hand, 0, q).back()), product_of_exponentials(finger, q), 1e-12);
    }
  }
}

TEST_CASE("DH: at q = 0 link k stands where the first k matrices put it") {
  Random random(12);
  const RandomFinger finger = random_finger(random, 4);
  const auto poses_H = forward(*make_hand(finger.description), 0, {0, 0, 0, 0});
  Eigen::Matrix4d X = base_matrix(finger);
  for (std::size_t k = 0; k <= 4; ++k) {
    CHECK_NEAR(matrix(poses_H[k]), X, 64 * kEps);
    if (k < 4) X = X * textbook_matrix(finger.rows[k]);
  }
}

TEST_CASE("DH: the Jacobian is the derivative of the tip's position and orientation") {
  Random random(13);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const RandomFinger finger = random_finger(random, 4);
    const auto hand = make_hand(finger.description);
    auto q = random_values(random, 4);
    Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 4);
    hand->jacobian(0, q, J);
    for (std::size_t k = 0; k < 4; ++k) {
      const double q_k = q[k];
      q[k] = q_k + kStep;
      const Pose after = forward(*hand, 0, q).back();
      q[k] = q_k - kStep;
      const Pose before = forward(*hand, 0, q).back();
      q[k] = q_k;
      const Eigen::Vector3d velocity = (after.p - before.p) / (2 * kStep);
      const Eigen::Matrix3d D = (after.R * before.R.transpose()) / (2 * kStep);
      const Eigen::Vector3d rate = 0.5 * Eigen::Vector3d(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
      const Eigen::Matrix<double, 6, 1> column = J.col(static_cast<Eigen::Index>(k));
      CHECK_NEAR(column.head<3>(), velocity, 1e-8);  // step 1e-5: truncation ~1e-9, rounding ~1e-10
      CHECK_NEAR(column.tail<3>(), rate, 1e-8);
    }
  }
}

TEST_CASE("DH: two parallel joints end where trigonometry says") {
  const auto hand = make_hand(planar_hand());
  CHECK_NEAR(forward(*hand, 0, {0, 0}).back().p, Eigen::Vector3d(2, 0, 0), 0);
  CHECK_NEAR(forward(*hand, 0, {pi / 2, 0}).back().p, Eigen::Vector3d(0, 2, 0), 8 * kEps);
  CHECK_NEAR(forward(*hand, 0, {pi / 2, pi / 2}).back().p, Eigen::Vector3d(-1, 1, 0), 8 * kEps);
}

TEST_CASE("DH: theta is added to a revolute joint's value and d to a prismatic one's") {
  const auto turned = make_hand(with_joint(planar_hand(), "theta", 0.3));
  const auto plain = make_hand(planar_hand());
  CHECK_NEAR(forward(*turned, 0, {0.2, 0.1}).back().p, forward(*plain, 0, {0.5, 0.1}).back().p, 8 * kEps);
  const auto slid = make_hand(with_joint(with_joint(planar_hand(), "type", "prismatic"), "d", 0.25));
  CHECK_NEAR(forward(*slid, 0, {0.5, 0}).back().p, Eigen::Vector3d(2, 0, 0.75), 4 * kEps);
}

TEST_CASE("DH: a description in U is the one in metres, times U") {
  Random random(14);
  const RandomFinger finger = random_finger(random, 4);
  Value in_U = finger.description;
  in_U.set("lengths", "U");
  in_U.set("unit_length", 0.5);
  const auto metres = make_hand(finger.description), units = make_hand(in_U);
  auto q = random_values(random, 4), q_metres = q;
  for (std::size_t i = 0; i < 4; ++i) {
    if (finger.rows[i].prismatic) q[i] = 0.5 * q_metres[i];
  }
  const Pose half = forward(*units, 0, q).back(), full = forward(*metres, 0, q_metres).back();
  CHECK_NEAR(half.p, Eigen::Vector3d(0.5 * full.p), 16 * kEps);
  CHECK_NEAR(half.R, full.R, 16 * kEps);
  CHECK(units->dimensions().unit_length_m == 0.5);
  CHECK(units->dimensions().finger_spacing_m == 0.5 * 0.03);
  CHECK(units->dimensions().maximum_opening_m == 0.5 * 0.12);
  CHECK(units->dimensions().base_width_m == 0.5 * 0.15);
}

TEST_CASE("DH: turning and shifting a finger's base turns and shifts its links") {
  Value moved = planar_hand();
  moved = with_finger(moved, 0, "base", Value::table({{"position", Value::numbers({1, 2, 3})},
                                                      {"rotation", Value::numbers({0, 0, pi / 2})}}));
  const auto after = forward(*make_hand(moved), 0, {0.4, 0.7});
  const auto before = forward(*make_hand(planar_hand()), 0, {0.4, 0.7});
  Pose X{Eigen::Matrix3d::Zero(), {1, 2, 3}};
  X.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (std::size_t k = 0; k < after.size(); ++k) CHECK_NEAR(matrix(after[k]), matrix(X * before[k]), 16 * kEps);
}

TEST_CASE("DH: threads that share a hand get the answers that one thread gets") {
  Random random(15);
  const auto hand = make_hand(planar_hand());
  std::vector<std::vector<double>> postures;
  for (int i = 0; i < 500; ++i) postures.push_back(random_values(random, 2));
  std::vector<Eigen::Vector3d> alone;
  for (const auto& q : postures) alone.push_back(forward(*hand, 1, q).back().p);

  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (int& count : wrong) {
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < postures.size(); ++i) {
        if (forward(*hand, 1, postures[i]).back().p != alone[i]) ++count;
      }
    });
  }
  for (auto& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("DH: a finger that the hand lacks and buffers of another size are refused") {
  const auto hand = make_hand(planar_hand());
  std::vector<Pose> poses_H(4);
  const std::vector<double> q = {0, 0}, longer = {0, 0, 0};
  CHECK_THROWS_SAYING(hand->forward(2, q, poses_H), InputError, "fingers 0 .. 1, got 2");
  CHECK_THROWS_SAYING(hand->forward(-1, q, poses_H), InputError, "fingers 0 .. 1, got -1");
  CHECK_THROWS_SAYING(hand->forward(0, longer, poses_H), InputError, "needs 2 joint values, got 3");
}

TEST_SUITE_END();
