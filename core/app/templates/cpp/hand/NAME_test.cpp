// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/hand/hand_model.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const Value lengths = Value::table({{"proximal", 0.06}, {"distal", 0.04}, {"half_width", 0.05}});
  const auto hand = registry.create<HandModel>("@NAME@", lengths);
  check(hand->fingers().size() == 3 && hand->joints().size() == 6, "it has a thumb and two forefingers of two joints");

  std::vector<Pose> poses_H(4);
  hand->forward(0, std::vector<double>{0, 0}, poses_H);
  check((poses_H[3].p - Eigen::Vector3d(0, -0.05, 0.1)).norm() < 1e-15, "a stretched thumb stands above its base");
  const double right = std::numbers::pi / 2;
  hand->forward(0, std::vector<double>{0, right}, poses_H);
  check((poses_H[3].p - Eigen::Vector3d(0, -0.01, 0.06)).norm() < 1e-15, "a bent thumb points to the forefingers");
  hand->forward(1, std::vector<double>{0, right}, poses_H);
  check(std::abs(poses_H[3].p.y() - 0.01) < 1e-15, "and a bent forefinger to the thumb");

  // The Jacobian is the derivative of the fingertip's place.
  const std::vector<double> q = {0.3, 0.7};
  const double step = 1e-6;
  Eigen::Matrix<double, 6, Eigen::Dynamic> J(6, 2);
  hand->jacobian(1, q, J);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> more = q, less = q;
    more[i] += step, less[i] -= step;
    std::vector<Pose> ahead(4), behind(4);
    hand->forward(1, more, ahead);
    hand->forward(1, less, behind);
    const Eigen::Vector3d slope = (ahead[3].p - behind[3].p) / (2 * step);
    check((J.col(static_cast<Eigen::Index>(i)).head<3>() - slope).norm() < 1e-9, "the Jacobian is the tip's derivative");
  }

  bool refused = false;
  try {
    hand->forward(3, q, poses_H);
  } catch (const InputError&) {
    refused = true;
  }
  check(refused, "a finger that is not there is refused");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
