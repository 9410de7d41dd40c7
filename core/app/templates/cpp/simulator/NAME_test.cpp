// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cstdio>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/grasp/simulator.h"
#include "preshape/hand/chain.h"
#include "preshape/plugin/registry.h"

namespace {

using namespace preshape;

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

/// A thumb and an index finger of two links of 5 cm, 8 cm apart, without solids.
class Tongs final : public HandModel {
 public:
  Tongs() {
    for (const double side : {-1.0, 1.0}) {
      Pose X_HB;
      X_HB.R << 0, 0, side, 0, -side, 0, 1, 0, 0;
      X_HB.p = {0, 0.04 * side, 0};
      ChainJoint first, second;
      second.X_PJ.p.x() = 0.05;
      Pose X_LD;
      X_LD.p.x() = 0.05;
      chains_.emplace_back(X_HB, std::vector<ChainJoint>{first, second}, X_LD);
    }
  }
  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return fingers_; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return {}; }
  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override {
    chains_[static_cast<std::size_t>(finger)].forward(q, poses_H);
  }
  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override {
    chains_[static_cast<std::size_t>(finger)].jacobian(q, jacobian);
  }

 private:
  HandDimensions dimensions_{0.03, 0.03, 0.05, 0.08};
  std::vector<Finger> fingers_ = {{"thumb", FingerRole::kThumb, 0, 2}, {"index", FingerRole::kIndex, 2, 2}};
  std::vector<Joint> joints_ = std::vector<Joint>(4, Joint{"joint", false, -0.5, 1.7, 0.0});
  std::vector<Chain> chains_;
};

/// Nothing to run into.
class Void final : public CollisionBackend, public CollisionScene {
 public:
  std::unique_ptr<CollisionScene> build(TriangleMeshView) const override { return std::make_unique<Void>(); }
  void cast(std::span<const Ray>, std::span<RayHit>) const override {}
  void distance(std::span<const PosedSolid>, std::span<double> d) const override { std::fill(d.begin(), d.end(), 1.0); }
  void distance(std::span<const PosedSolid>, std::span<const PosedSolid>, std::span<double> d) const override {
    std::fill(d.begin(), d.end(), 1.0);
  }
};

}  // namespace

int main(int, char** argv) {
  const Registry registry({{argv[1], "test"}});
  const auto simulator = registry.create<GraspSimulator>("@NAME@");
  const Tongs tongs;
  const Void empty;
  const FingerRole roles[] = {FingerRole::kThumb, FingerRole::kIndex};
  const Eigen::Vector3d approach_O(0, 0, -1), opposition_O(1, 0, 0);
  const auto grasp = [&](double half_width_m) {
    const ContactFrame contacts[] = {ContactFrame::at({half_width_m, 0, 0.1}, {-1, 0, 0}, approach_O),
                                     ContactFrame::at({-half_width_m, 0, 0.1}, {1, 0, 0}, approach_O)};
    return simulator->simulate({tongs, empty, empty, contacts, roles, approach_O, opposition_O, 0.01}, 1, nullptr);
  };

  const Simulation narrow = grasp(0.02);
  check(narrow.status == Simulation::Status::kReached, "contacts 4 cm apart are reached");
  check(narrow.contact_error_m < 1e-4 && narrow.path.size() > 1, "by a path that ends at the contacts");
  check((narrow.X_OH.R * Eigen::Vector3d::UnitZ() - approach_O).norm() < 1e-9, "the hand comes along the approach axis");
  for (const auto& q : narrow.path) {
    for (const double angle : q) check(angle >= -0.5 && angle <= 1.7, "every joint stays within its limits");
  }
  const Simulation wide = grasp(0.3);
  check(wide.status == Simulation::Status::kUnreachable && !wide.reason.empty(), "contacts 60 cm apart are not");

  bool refused = false;
  try {
    simulator->simulate({tongs, empty, empty, {}, roles, approach_O, opposition_O, 0.0}, 1, nullptr);
  } catch (const InputError&) {
    refused = true;
  }
  check(refused, "contacts and fingers that differ in number are refused");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
