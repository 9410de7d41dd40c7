// What inverse kinematics does beside arriving: hands that move, wished directions, limits, couplings and what it tells.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/hand/inverse_kinematics.h"
#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;
using Eigen::Vector3d;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

/// All fingertips of a posture whose hand has moved by X_HM; directions too when they have a weight.
std::vector<FingertipTarget> targets_of(const HandModel& hand, const Posture& posture, const Pose& X_HM, double weight_m) {
  std::vector<FingertipTarget> targets;
  for (int finger = 0; finger < std::ssize(hand.fingers()); ++finger) {
    targets.push_back({finger, X_HM * tip(hand, finger, posture), X_HM.R * pointing_of(hand, finger, posture), weight_m});
  }
  return targets;
}

/// Angles of R = Rot_x Rot_y Rot_z.
Vector3d turns_of(const Eigen::Matrix3d& R) {
  return {std::atan2(-R(1, 2), R(2, 2)), std::asin(std::clamp(R(0, 2), -1.0, 1.0)), std::atan2(-R(0, 1), R(0, 0))};
}

Pose moved_by(const Vector3d& along, const Vector3d& turn) {
  using Eigen::AngleAxisd;
  return {(AngleAxisd(turn.x(), Vector3d::UnitX()) * AngleAxisd(turn.y(), Vector3d::UnitY()) * AngleAxisd(turn.z(), Vector3d::UnitZ())).toRotationMatrix(), along};
}

Vector3d drawn_within(const Vector3d& most, Random& random) {
  return {random.uniform(-most.x(), most.x()), random.uniform(-most.y(), most.y()), random.uniform(-most.z(), most.z())};
}

double direction_off(const HandModel& hand, const std::vector<FingertipTarget>& targets, const InverseKinematicsSolution& solution) {
  double off = 0.0;
  for (const auto& target : targets) {
    off = std::max(off, (target.pointing_H - solution.X_HM.R * pointing_of(hand, target.finger, solution.posture)).norm());
  }
  return off;
}

}  // namespace

TEST_CASE("Inverse kinematics: a hand free in all its ways follows its fingertips' move and turn in few steps, with and without wished directions") {
  const Vector3d along(0.03, 0.01, 0.02), turn(0.5, 0.3, 0.4);
  for (const auto& [name, hand] : shipped_hands()) {
    for (const double weight_m : {0.0, 0.02}) {
      INFO(name, " weight ", weight_m);
      Random random(11), starts(12);
      int slow = 0, off = 0;
      for (int i = 0; i < 60; ++i) {
        const Posture posture = random_posture(*hand, random);
        const Pose X_HM = moved_by(drawn_within(along, random), drawn_within(turn, random));
        const auto targets = targets_of(*hand, posture, X_HM, weight_m);
        const auto solution = solve_fingertips(*hand, targets, posture, {.tolerance_m = 1e-7, .iterations = 12, .starts = 1, .freedom = {along, turn}}, starts);
        slow += !solution.reached;
        off += weight_m > 0.0 && direction_off(*hand, targets, solution) > 1e-3;
        CHECK((solution.X_HM.p.cwiseAbs() - along).maxCoeff() <= 1e-12);
        CHECK((turns_of(solution.X_HM.R).cwiseAbs() - turn).maxCoeff() <= 1e-9);
      }
      CHECK(slow == 0);
      CHECK(off <= 2);  // places have other directions too, where a start is far away
    }
  }
}

TEST_CASE("Inverse kinematics: each way of the hand is its own: what is not free stays, what is free goes for a target far away, no further than it may") {
  const HandModel& hand = *shipped_hands().at("utah_mit");
  Random starts(13);
  for (int way = 0; way < 6; ++way) {
    INFO("way ", way);
    HandFreedom freedom;
    (way < 3 ? freedom.translation_m : freedom.turn)[way % 3] = 0.05;
    for (const double side : {-1.0, 1.0}) {
      const FingertipTarget far{0, side * (way < 3 ? Vector3d(Vector3d::Unit(way)) : Vector3d(1, 2, 3))};
      const auto solution = solve_fingertips(hand, {&far, 1}, middle_posture(hand), {.freedom = freedom}, starts);
      const Vector3d turns = turns_of(solution.X_HM.R);
      for (int k = 0; k < 3; ++k) {
        if (way != k) CHECK(solution.X_HM.p[k] == 0.0);
        if (way != 3 + k) CHECK(std::abs(turns[k]) <= 1e-15);
      }
      CHECK((turns.cwiseAbs() - freedom.turn).maxCoeff() <= 1e-9);
      if (way < 3) CHECK(solution.X_HM.p[way] == doctest::Approx(side * 0.05));
      else CHECK(std::abs(turns[way - 3]) > 0.04);
    }
  }
}

TEST_CASE("Inverse kinematics: wished directions that go with the places are found from nearby") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(14), starts(15);
    int off = 0;
    for (int i = 0; i < 100; ++i) {
      const Posture posture = random_posture(*hand, random);
      Posture start = posture;
      for (double& value : start) value += random.uniform(-0.2, 0.2);
      const auto targets = targets_of(*hand, posture, {}, 0.02);
      const auto solution = solve_fingertips(*hand, targets, start, {.tolerance_m = 1e-7, .iterations = 30, .starts = 1}, starts);
      off += direction_off(*hand, targets, solution) > 1e-3;
    }
    CHECK(off <= 2);
  }
}

TEST_CASE("Inverse kinematics: a start beyond the limits or beside the couplings is put right even when its fingertips are there already") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random starts(16);
    Posture beyond = middle_posture(*hand);
    for (double& value : beyond) value += 2.0;
    const auto solution = solve_fingertips(*hand, targets_of(*hand, beyond, {}, 0.0), beyond, {.starts = 1}, starts);
    CHECK(within_limits(*hand, solution.posture, 1e-9));
    Posture coupled = solution.posture;
    apply_couplings(*hand, coupled);
    CHECK(solution.posture == coupled);

    Posture beside = middle_posture(*hand);
    for (std::size_t j = 0; j < beside.size(); ++j) beside[j] += hand->joints()[j].leader < 0 ? 0.0 : 0.1;
    const auto righted = solve_fingertips(*hand, targets_of(*hand, beside, {}, 0.0), beside, {.starts = 1}, starts).posture;
    coupled = righted;
    apply_couplings(*hand, coupled);
    CHECK(righted == coupled);
  }
}

TEST_CASE("Inverse kinematics: a finger points from its last joint's axis to its tip: against the bend of the tip's arc") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(18);
    for (int finger = 0; finger < std::ssize(hand->fingers()); ++finger) {
      const Posture posture = random_posture(*hand, random);
      const Finger& about = hand->fingers()[static_cast<std::size_t>(finger)];
      Posture up = posture, down = posture;  // without couplings: the last joint alone
      up[static_cast<std::size_t>(about.first_joint + about.joint_count - 1)] += 0.5;
      down[static_cast<std::size_t>(about.first_joint + about.joint_count - 1)] -= 0.5;
      const Vector3d bend = tip(*hand, finger, up) + tip(*hand, finger, down) - 2.0 * tip(*hand, finger, posture);
      CHECK_NEAR(pointing_of(*hand, finger, posture), -bend.normalized(), 1e-9);
    }
  }
}

TEST_CASE("Inverse kinematics: a wished direction that the place does not allow gives way to it") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(19), starts(20);
    int missed = 0;
    for (int i = 0; i < 50; ++i) {
      const Posture posture = random_posture(*hand, random);
      FingertipTarget target = targets_of(*hand, posture, {}, 0.05).front();
      target.pointing_H = -target.pointing_H;
      missed += !solve_fingertips(*hand, {&target, 1}, posture, {.tolerance_m = 1e-7, .starts = 50}, starts).reached;
    }
    CHECK(missed == 0);
  }
}

TEST_CASE("Inverse kinematics: more starts never come less near, and a freedom that is no number is refused") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(21), starts(22);
    const Posture middle = middle_posture(*hand);
    for (int i = 0; i < 20; ++i) {
      const FingertipTarget beyond{0, 3.0 * tip(*hand, 0, random_posture(*hand, random))};
      const double one = solve_fingertips(*hand, {&beyond, 1}, middle, {.iterations = 5, .starts = 1}, starts).residual_m;
      CHECK(solve_fingertips(*hand, {&beyond, 1}, middle, {.iterations = 5, .starts = 6}, starts).residual_m <= one);
    }
    const FingertipTarget target{0, tip(*hand, 0, middle)};
    for (const double bad : {NAN, INFINITY}) {
      CHECK_THROWS_SAYING(solve_fingertips(*hand, {&target, 1}, middle, {.freedom = {{0, bad, 0}, {0, 0, 0}}}, starts), InputError, "freedom to move");
      CHECK_THROWS_SAYING(solve_fingertips(*hand, {&target, 1}, middle, {.freedom = {{0, 0, 0}, {0, 0, bad}}}, starts), InputError, "freedom to move");
    }
  }
}

TEST_CASE("Inverse kinematics: joints at a limit of their drive are named, ascending, and the residual is that of the worst fingertip") {
  std::ptrdiff_t stopped = 0;
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random starts(17);
    const Posture middle = middle_posture(*hand);
    const int last = static_cast<int>(std::ssize(hand->fingers())) - 1;
    for (const auto& [far_finger, near_finger] : {std::pair(last, 0), std::pair(0, last)}) {
      const std::vector<FingertipTarget> targets = {{last, far_finger == last ? Vector3d(0.5, 1.0, 1.5) : tip(*hand, last, middle)},
                                                    {0, far_finger == 0 ? Vector3d(0.5, 1.0, 1.5) : tip(*hand, 0, middle)}};
      const auto solution = solve_fingertips(*hand, targets, middle, {}, starts);
      CHECK_FALSE(solution.reached);
      CHECK_NEAR(solution.residual_m, (targets[far_finger == last ? 0 : 1].p_HD - tip(*hand, far_finger, solution.posture)).norm(), 1e-12);
      CHECK(solution.starts == 12);
      std::vector<int> expected;
      for (const int index : {0, last}) {
        const Finger& finger = hand->fingers()[static_cast<std::size_t>(index)];
        for (int joint = finger.first_joint; joint < finger.first_joint + finger.joint_count; ++joint) {
          const int leader = hand->joints()[static_cast<std::size_t>(joint)].leader, drive = leader < 0 ? joint : leader;
          const DriveRange range = drive_range(*hand, drive);
          const double q = solution.posture[static_cast<std::size_t>(drive)];
          if (std::min(q - range.lower, range.upper - q) <= 1e-9 * (range.upper - range.lower)) expected.push_back(joint);
        }
      }
      std::sort(expected.begin(), expected.end());
      stopped += std::ssize(expected);
      CHECK(solution.at_limit == expected);
    }
  }
  CHECK(stopped >= 5);
  // Of two fingers at their limits, the later one asked for first.
  const HandModel& hand = *shipped_hands().at("utah_mit");
  Random starts(23);
  const int last = static_cast<int>(std::ssize(hand.fingers())) - 1;
  const auto both = solve_fingertips(hand, std::vector<FingertipTarget>{{last, {0.0, 0.0, -1.0}}, {0, {0.0, 0.0, -1.0}}}, middle_posture(hand), {}, starts);
  CHECK(both.at_limit.front() < hand.fingers()[0].joint_count);
  CHECK(both.at_limit.back() >= hand.fingers()[static_cast<std::size_t>(last)].first_joint);
  CHECK(std::is_sorted(both.at_limit.begin(), both.at_limit.end()));
}

TEST_SUITE_END();
