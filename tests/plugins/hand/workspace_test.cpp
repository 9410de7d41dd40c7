#include "preshape/hand/workspace.h"

#include <algorithm>
#include <cmath>

#include "support/hands.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/hand");

TEST_CASE("Workspace: every cell is within the finger's length of its base, and the box is around every fingertip") {
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    for (int finger = 0; finger < static_cast<int>(hand->fingers().size()); ++finger) {
      Random random(1);
      const FingerWorkspace workspace = finger_workspace(*hand, finger, 3000, 0.005, random);
      const auto poses = finger_poses(*hand, finger, middle_posture(*hand));
      double length = 0.0;
      for (std::size_t k = 1; k < poses.size(); ++k) length += (poses[k].p - poses[k - 1].p).norm();
      CHECK(workspace.volume_m3() > 0.0);
      CHECK(workspace.volume_m3() < 4.0 / 3.0 * M_PI * std::pow(length + 0.005, 3));
      for (const auto& p : workspace.cells_H) {
        CHECK((p - poses.front().p).norm() <= length + 0.005);
        CHECK(((p - workspace.box_H.lower).array() > -0.005).all());
        CHECK(((workspace.box_H.upper - p).array() > -0.005).all());
      }
    }
  }
}

TEST_CASE("Workspace: the opposition range is between the nearest and the farthest cells that stand before each other") {
  FingerWorkspace thumb, fore;
  thumb.cell_m = fore.cell_m = 0.01;
  thumb.cells_H = {{0, -0.05, 0.1}, {0, -0.02, 0.1}, {0.5, -0.9, 0.1}};
  fore.cells_H = {{0, 0.01, 0.1}, {0, 0.07, 0.1}, {0, 0.9, 0.3}};
  const OppositionRange range = opposition_range(thumb, fore);
  CHECK(range.opposed);
  CHECK_NEAR(range.least_m, 0.03, 1e-12);
  CHECK_NEAR(range.most_m, 0.12, 1e-12);
  fore.cells_H = {{0, 0.9, 0.3}};
  CHECK_FALSE(opposition_range(thumb, fore).opposed);
  fore.cells_H = {{0, -0.09, 0.1}, {0, -0.06, 0.1}};  // behind the thumb, where it opposes nothing
  CHECK_FALSE(opposition_range(thumb, fore).opposed);
}

TEST_CASE("Workspace: of several columns the nearest and the farthest count, whichever comes first, and fingers that pass each other come to 0") {
  FingerWorkspace thumb, fore;
  thumb.cell_m = fore.cell_m = 0.01;
  for (const double side : {1.0, -1.0}) {
    thumb.cells_H = {{side * 0.03, -0.02, 0.1}, {side * -0.03, 0.0, 0.1}};
    fore.cells_H = {{side * 0.03, 0.01, 0.1}, {side * 0.03, 0.09, 0.1}, {side * -0.03, 0.05, 0.1}};
    CHECK_NEAR(opposition_range(thumb, fore).least_m, 0.03, 1e-12);
    CHECK_NEAR(opposition_range(thumb, fore).most_m, 0.11, 1e-12);
  }
  thumb.cells_H = {{0, 0, 0}, {0, 0.04, 0}};
  fore.cells_H = {{0, 0.02, 0}, {0, 0.07, 0}};
  CHECK(opposition_range(thumb, fore).least_m == 0.0);
  CHECK_NEAR(opposition_range(thumb, fore).most_m, 0.07, 1e-12);
}

TEST_CASE("Workspace: its cells are those of the fingertips of the drawn postures, followers with their leaders, and no others") {
  constexpr double kCell = 0.004;
  for (const auto& [name, hand] : shipped_hands()) {
    INFO(name);
    Random random(4), again(4);
    const FingerWorkspace workspace = finger_workspace(*hand, 0, 200, kCell, random);
    std::vector<bool> used(workspace.cells_H.size(), false);
    Box box;
    for (int i = 0; i < 200; ++i) {
      Posture posture(hand->joints().size(), 0.0);
      for (const int joint : driven_joints(*hand)) {
        const DriveRange range = drive_range(*hand, joint);
        posture[static_cast<std::size_t>(joint)] = again.uniform(range.lower, range.upper);
      }
      apply_couplings(*hand, posture);
      const Eigen::Vector3d tip = finger_poses(*hand, 0, posture).back().p;
      box.lower = i == 0 ? tip : Eigen::Vector3d(box.lower.cwiseMin(tip)), box.upper = i == 0 ? tip : Eigen::Vector3d(box.upper.cwiseMax(tip));
      bool found = false;
      for (std::size_t k = 0; k < used.size(); ++k) {
        if ((workspace.cells_H[k] - tip).cwiseAbs().maxCoeff() <= 0.5 * kCell + 1e-12) found = used[k] = true;
      }
      CHECK(found);
    }
    CHECK(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
    CHECK(workspace.box_H.lower == box.lower);
    CHECK(workspace.box_H.upper == box.upper);
  }
}

TEST_SUITE_END();
