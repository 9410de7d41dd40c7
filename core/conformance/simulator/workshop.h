#pragma once

#include <vector>

#include "../context.h"
#include "preshape/grasp/simulator.h"
#include "preshape/hand/chain.h"

namespace preshape::conformance {

/// A thumb against an index and a middle finger, each with a sideways joint and two bends. In H the fingers
/// point along z, the thumb stands at -y and the others at +y, palm in the plane z = 0.
class Gripper final : public HandModel {
 public:
  Gripper();
  const HandDimensions& dimensions() const noexcept override { return dimensions_; }
  std::span<const Finger> fingers() const noexcept override { return fingers_; }
  std::span<const Joint> joints() const noexcept override { return joints_; }
  std::span<const LinkSolid> solids() const noexcept override { return solids_; }
  void forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const override;
  void jacobian(int finger, std::span<const double> q,
                Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const override;

 private:
  HandDimensions dimensions_{0.03, 0.03, 0.12, 0.08};
  std::vector<Finger> fingers_;
  std::vector<Joint> joints_;
  std::vector<LinkSolid> solids_;
  std::vector<Chain> chains_;
};

/// Looks at every triangle.
class PlainBackend final : public CollisionBackend {
 public:
  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const override;
  void distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                std::span<double> distances) const override;
};

/// A box to be grasped: its middle at X_OB, the hand comes along its -z, the thumb against its -y face.
struct Job {
  Eigen::Vector3d half = {0.03, 0.02, 0.03};  ///< [m]
  Pose X_OB;
  double spread = 0.03;      ///< between the two forefingers [m]
  double off = 0.0;          ///< of all contacts along the box's z [m]
  double clearance = 0.015;  ///< [m]
  bool three = true;         ///< or thumb and index alone
};

/// The numbers of a job, and the job. Most can be done; of the tallest boxes the palm is in the way.
std::vector<Block> job_blocks();
Job job_of(Case numbers);

/// A job with everything that its task refers to.
class Bench {
 public:
  explicit Bench(const Job& job);
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  SimulationTask task() const;
  const Gripper& hand() const { return hand_; }
  const Job& job() const { return job_; }
  /// The object, filled.
  PosedSolid object() const { return {{Solid::Kind::kBox, 0, 0, job_.half}, job_.X_OB}; }

  std::vector<ContactFrame> contacts;
  std::vector<FingerRole> fingers;
  Eigen::Vector3d approach_O, opposition_O;

 private:
  Job job_;
  Gripper hand_;
  PlainBackend collision_;
  std::unique_ptr<CollisionScene> scene_;
};

/// Where a finger's frames are in O: base, links, tip.
std::vector<Pose> finger_poses(const HandModel& hand, int finger, const Pose& X_OH,
                               const std::vector<double>& posture);
/// Where the fingertips of a task's contacts are in O.
std::vector<Eigen::Vector3d> tips(const SimulationTask& task, const Pose& X_OH,
                                  const std::vector<double>& posture);

/// Status, errors, base and path in order.
std::vector<double> numbers_of(const Simulation& simulation);

}  // namespace preshape::conformance
