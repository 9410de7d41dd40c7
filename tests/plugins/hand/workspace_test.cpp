#include "preshape/hand/workspace.h"

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
}

TEST_SUITE_END();
