// Kinematics that hold for every hand in hands/: random postures, finite differences, inverse of forward.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/hand/inverse_kinematics.h"
#include "preshape/hand/manipulability.h"
#include "preshape/hand/planar_finger.h"
#include "preshape/workbench/catalogue.h"
#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

namespace {

constexpr int kPostures = 10000;
const InverseKinematicsSettings kNumeric{.tolerance_m = 1e-7, .iterations = 100, .starts = 150, .closed_form = false};

int finger_count(const HandModel& hand) { return static_cast<int>(hand.fingers().size()); }

}  // namespace

TEST_CASE("Hands: every drive leaves its followers room within their limits, and a leader follows nobody") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    for (const Joint& joint : hand->joints()) {
      INFO(joint.name);
      if (joint.leader >= 0) CHECK(hand->joints()[static_cast<std::size_t>(joint.leader)].leader == -1);
    }
    for (const int drive : driven_joints(*hand)) {
      const DriveRange range = drive_range(*hand, drive);
      INFO(hand->joints()[static_cast<std::size_t>(drive)].name);
      CHECK(range.lower < range.upper);
    }
    Random random(1);
    for (int i = 0; i < 100; ++i) CHECK(within_limits(*hand, random_posture(*hand, random), 1e-12));
    CHECK(within_limits(*hand, middle_posture(*hand), 1e-12));
  }
}

TEST_CASE("Hands: the Jacobian with respect to the drives is the difference quotient of the fingertip") {
  constexpr double kStep = 1e-6;
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(2);
    const auto drives = driven_joints(*hand);
    for (int i = 0; i < 200; ++i) {
      const Posture q = random_posture(*hand, random);
      for (int finger = 0; finger < finger_count(*hand); ++finger) {
        const auto J = drive_jacobian(*hand, finger, q);
        for (std::size_t d = 0; d < drives.size(); ++d) {
          Posture up = q, down = q;
          up[static_cast<std::size_t>(drives[d])] += kStep, down[static_cast<std::size_t>(drives[d])] -= kStep;
          apply_couplings(*hand, up), apply_couplings(*hand, down);
          const Eigen::Vector3d quotient = (tip(*hand, finger, up) - tip(*hand, finger, down)) / (2 * kStep);
          CHECK_NEAR(J.col(static_cast<Eigen::Index>(d)).head<3>(), quotient, 1e-8);
        }
      }
    }
  }
}

TEST_CASE("Hands: inverse kinematics brings all fingertips at once to places that a posture has, within the limits, to 1e-6 m") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(3), starts(4);
    int missed = 0, out = 0;
    double worst = 0.0;
    for (int i = 0; i < kPostures / 10; ++i) {
      const Posture wanted = random_posture(*hand, random);
      std::vector<FingertipTarget> targets;
      for (int finger = 0; finger < finger_count(*hand); ++finger) targets.push_back({finger, tip(*hand, finger, wanted)});
      const auto solution = solve_fingertips(*hand, targets, middle_posture(*hand), kNumeric, starts);
      out += !within_limits(*hand, solution.posture, 1e-9);
      double far = 0.0;
      for (const auto& target : targets) far = std::max(far, (tip(*hand, target.finger, solution.posture) - target.p_HD).norm());
      CHECK_NEAR(far, solution.residual_m, 1e-12);
      missed += far > 1e-6;
      worst = std::max(worst, far);
    }
    MESSAGE(name, ": ", missed, " of ", kPostures / 10, " not to 1e-6 m, worst ", worst, " m");
    CHECK(missed == 0);
    CHECK(out == 0);
  }
}

TEST_CASE("Hands: inverse kinematics finger by finger over ten thousand random postures, to 1e-6 m within the limits") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(5), starts(6);
    int missed = 0, out = 0;
    for (int i = 0; i < kPostures; ++i) {
      const Posture wanted = random_posture(*hand, random);
      const int finger = i % finger_count(*hand);
      const FingertipTarget target{finger, tip(*hand, finger, wanted)};
      const auto solution = solve_fingertips(*hand, {&target, 1}, middle_posture(*hand), kNumeric, starts);
      out += !within_limits(*hand, solution.posture, 1e-9);
      missed += (tip(*hand, finger, solution.posture) - target.p_HD).norm() > 1e-6;
    }
    CHECK(missed == 0);
    CHECK(out == 0);
  }
}

TEST_CASE("Hands: a hand that is free to move goes along to fingertips of a posture elsewhere, no further than it may") {
  const HandFreedom freedom{{0.02, 0.02, 0.01}, Eigen::Vector3d::Constant(0.3)};
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(8), starts(9);
    int missed = 0;
    for (int i = 0; i < 100; ++i) {
      const Posture wanted = random_posture(*hand, random);
      Pose X_HW;
      X_HW.p = Eigen::Vector3d(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.01, 0.01));
      X_HW.R = Eigen::AngleAxisd(random.uniform(-0.3, 0.3), Eigen::Vector3d::UnitZ()).toRotationMatrix();
      std::vector<FingertipTarget> targets;
      for (int finger = 0; finger < finger_count(*hand); ++finger) targets.push_back({finger, X_HW * tip(*hand, finger, wanted)});
      const auto solution = solve_fingertips(*hand, targets, wanted, {.tolerance_m = 1e-7, .iterations = 200, .starts = 20, .freedom = freedom}, starts);
      missed += !solution.reached;
      for (const auto& target : targets) {
        CHECK((solution.X_HM * tip(*hand, target.finger, solution.posture) - target.p_HD).norm() <= solution.residual_m + 1e-12);
      }
      CHECK(within_limits(*hand, solution.posture, 1e-9));
      CHECK((solution.X_HM.p.cwiseAbs() - freedom.translation_m).maxCoeff() <= 1e-12);
      CHECK(solution.X_HM.R.eulerAngles(0, 1, 2).cwiseAbs().unaryExpr([](double a) { return std::min(a, std::numbers::pi - a); }).maxCoeff() <= 0.3 + 1e-9);
    }
    MESSAGE(name, ": ", missed, " of 100 not reached");
    CHECK(missed == 0);
    const FingertipTarget far{0, {1.0, 1.0, 1.0}};
    CHECK((solve_fingertips(*hand, {&far, 1}, middle_posture(*hand), {.freedom = freedom}, starts).X_HM.p.cwiseAbs() - freedom.translation_m).maxCoeff() <= 1e-12);
    CHECK(solve_fingertips(*hand, {&far, 1}, middle_posture(*hand), {}, starts).X_HM.p.norm() == 0.0);
    CHECK_THROWS_SAYING(solve_fingertips(*hand, {&far, 1}, middle_posture(*hand), {.freedom = {{-0.1, 0, 0}, {0, 0, 0}}}, starts), InputError, "freedom to move");
  }
}

TEST_CASE("Hands: a finger that has a closed form is solved by it, as near to where it starts as it can be; numbers alone get there too") {
  const HandModel& hand = *shipped_hands().at("utah_mit");
  Random random(10), starts(11);
  for (int i = 0; i < 200; ++i) {
    const Posture wanted = random_posture(hand, random);
    const FingertipTarget target{i % 4, tip(hand, i % 4, wanted)};
    const auto closed = solve_fingertips(hand, {&target, 1}, wanted, {}, starts);
    CHECK(closed.starts == 0);
    CHECK(closed.residual_m < 1e-9);
    CHECK(within_limits(hand, closed.posture));
    CHECK((tip(hand, target.finger, closed.posture) - target.p_HD).norm() < 1e-9);
    CHECK(solve_fingertips(hand, {&target, 1}, wanted, {.closed_form = false}, starts).starts > 0);
    const FingertipTarget wish{target.finger, target.p_HD, Eigen::Vector3d::UnitZ(), 0.003};
    CHECK(solve_fingertips(hand, {&wish, 1}, wanted, {}, starts).starts > 0);
  }
}

TEST_CASE("Hands: what is out of reach is told by the residual, and the posture stays within the limits") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random starts(7);
    const FingertipTarget far{0, {1.0, 1.0, 1.0}};
    const auto solution = solve_fingertips(*hand, {&far, 1}, middle_posture(*hand), {}, starts);
    CHECK_FALSE(solution.reached);
    CHECK(solution.residual_m > 1.0);
    CHECK(within_limits(*hand, solution.posture, 1e-9));
    CHECK_THROWS_SAYING(solve_fingertips(*hand, std::vector<FingertipTarget>{far, far}, middle_posture(*hand), {}, starts), InputError, "two targets");
    CHECK_THROWS_SAYING(solve_fingertips(*hand, std::vector<FingertipTarget>{{99, {}}}, middle_posture(*hand), {}, starts), InputError, "the hand has fingers 0 ..");
    CHECK_THROWS_SAYING(solve_fingertips(*hand, std::vector<FingertipTarget>{{0, {NAN, 0, 0}}}, middle_posture(*hand), {}, starts), InputError, "finite");
  }
}

TEST_CASE("Planar fingers: the closed form gives back the posture among its solutions, and every one of them to 1e-9 m") {
  int recognised = 0;
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(8);
    for (int finger = 0; finger < finger_count(*hand); ++finger) {
      const auto planar = PlanarFinger::recognise(*hand, finger);
      if (!planar) continue;
      ++recognised;
      int lost = 0;
      double worst = 0.0;
      for (int i = 0; i < kPostures; ++i) {
        Posture q = random_posture(*hand, random);
        const auto values = finger_values(*hand, finger, q);
        const Posture wanted(values.begin(), values.end());
        const Eigen::Vector3d p = tip(*hand, finger, q);
        const auto solutions = planar->solve(p, wanted[1] + wanted[2] + wanted[3]);
        double nearest = INFINITY;
        for (const auto& solution : solutions) {
          Posture found = q;
          const auto first = static_cast<std::size_t>(hand->fingers()[static_cast<std::size_t>(finger)].first_joint);
          double off = 0.0;
          for (std::size_t k = 0; k < 4; ++k) {
            found[first + k] = solution[k];
            off = std::max(off, std::abs(std::remainder(solution[k] - wanted[k], 2 * M_PI)));
          }
          worst = std::max(worst, (tip(*hand, finger, found) - p).norm());
          nearest = std::min(nearest, off);
        }
        lost += nearest > 1e-5;  // near a stretched elbow an angle is known to the root of a rounding
      }
      CHECK(worst < 1e-9);
      CHECK(lost == 0);
    }
  }
  CHECK(recognised >= 4);
}

TEST_CASE("Planar fingers: within the limits, the closed form finds a posture wherever one is, near the preferred one") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(9);
    for (int finger = 0; finger < finger_count(*hand); ++finger) {
      const auto planar = PlanarFinger::recognise(*hand, finger);
      if (!planar) continue;
      int lost = 0;
      for (int i = 0; i < 300; ++i) {
        const Posture q = random_posture(*hand, random);
        const auto values = finger_values(*hand, finger, q);
        const PlanarFinger::Values preferred{values[0], values[1], values[2], values[3]};
        const auto found = planar->solve_within_limits(tip(*hand, finger, q), preferred);
        if (!found) {
          ++lost;
          continue;
        }
        for (std::size_t k = 0; k < 4; ++k) CHECK_NEAR((*found)[k], preferred[k], 1e-4);
      }
      CHECK(lost == 0);
    }
  }
}

TEST_CASE("Manipulability: Yoshikawa's measure is the root of the determinant, and no velocity of unit drive rates is beyond its ellipsoid") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(10);
    for (int i = 0; i < 200; ++i) {
      const Posture q = random_posture(*hand, random);
      for (int finger = 0; finger < finger_count(*hand); ++finger) {
        const auto m = manipulability(*hand, finger, q);
        const Eigen::Matrix3Xd J = drive_jacobian(*hand, finger, q).topRows<3>();
        CHECK_NEAR(m.measure, std::sqrt(std::max(0.0, (J * J.transpose()).determinant())), 1e-9);
        Eigen::VectorXd rates(J.cols());
        for (Eigen::Index k = 0; k < rates.size(); ++k) rates[k] = random.normal();
        const Eigen::Vector3d v = m.axes_H.transpose() * (J * rates.normalized());
        for (int k = 0; k < 3; ++k) CHECK(std::abs(v[k]) <= m.singular_values[k] + 1e-12);
      }
    }
  }
}

TEST_SUITE_END();
