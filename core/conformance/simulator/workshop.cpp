#include "workshop.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "../collision/bodies.h"
#include "preshape/base/error.h"
#include "preshape/geometry/distance.h"
#include "preshape/geometry/query_checks.h"
#include "preshape/geometry/ray_triangle.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;
constexpr double kLink = 0.05;  // [m]

Pose turned(double angle, const Vector& axis, const Vector& p = Vector::Zero()) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), p};
}

/// The link frames keep z along the finger. @param yaw about z: 0 bends towards -y, pi towards +y
Chain finger_chain(double x, double y, double yaw) {
  const double quarter = std::numbers::pi / 2;
  const Pose to_y = turned(-quarter, Vector::UnitX()), to_x = turned(quarter, Vector::UnitY());
  const auto joint = [](const Pose& X_PJ, double length) {
    return ChainJoint{false, X_PJ, {X_PJ.R.transpose(), X_PJ.R.transpose() * Vector(0, 0, length)}};
  };
  return Chain(turned(yaw, Vector::UnitZ(), {x, y, 0}),
               {joint(to_y, 0.0), joint(to_x, kLink), joint(to_x, kLink)}, {});
}

class PlainScene final : public CollisionScene {
 public:
  explicit PlainScene(TriangleMeshView mesh)
      : mesh_{{mesh.vertices.begin(), mesh.vertices.end()}, {mesh.triangles.begin(), mesh.triangles.end()}},
        which_(touchable_triangles(mesh)) {}

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check_rays(rays, hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const RayProbe probe(rays[i]);
      NearestHit nearest(extent_of(mesh_));
      for (const auto t : which_) nearest.offer(probe.distance(corner(t, 0), corner(t, 1), corner(t, 2)), t);
      hits[i] = nearest.hit();
    }
  }
  void distance(std::span<const PosedSolid> solids, std::span<double> distances) const override {
    check_solids(solids, distances.size());
    for (std::size_t i = 0; i < solids.size(); ++i) {
      distances[i] = std::numeric_limits<double>::infinity();
      for (const auto t : which_) {
        distances[i] = std::min(distances[i],
                                distance_solid_triangle(solids[i], corner(t, 0), corner(t, 1), corner(t, 2)));
      }
    }
  }

 private:
  const Vector& corner(std::int32_t t, int k) const { return mesh_.corner(static_cast<std::size_t>(t), k); }
  TriangleMesh mesh_;
  std::vector<std::int32_t> which_;
};

}  // namespace

Gripper::Gripper() {
  const char* const names[] = {"thumb", "index", "middle"};
  constexpr FingerRole kRoles[] = {FingerRole::kThumb, FingerRole::kIndex, FingerRole::kMiddle};
  for (int f = 0; f < 3; ++f) {
    fingers_.push_back({names[f], kRoles[f], 3 * f, 3});
    joints_.push_back({fmt::format("{}_side", names[f]), false, -0.7, 0.7, 1.0});
    joints_.push_back({fmt::format("{}_root", names[f]), false, -0.9, 1.4, 1.0});
    joints_.push_back({fmt::format("{}_bend", names[f]), false, -0.2, 1.7, 1.0});
    for (const int link : {2, 3}) {
      // Along z, from the joint to a radius before the far end, where the next one or the tip is.
      solids_.push_back({f,
                         link,
                         {Solid::Kind::kCapsule, 0.006, 0.5 * kLink - 0.006, Vector::Zero()},
                         {Eigen::Matrix3d::Identity(), {0, 0, -0.5 * kLink}}});
    }
  }
  solids_.push_back(
      {-1, 0, {Solid::Kind::kBox, 0, 0, {0.04, 0.05, 0.01}}, {Eigen::Matrix3d::Identity(), {0, 0, -0.02}}});
  chains_ = {finger_chain(0, -0.04, std::numbers::pi), finger_chain(0.02, 0.04, 0),
             finger_chain(-0.02, 0.04, 0)};
}

void Gripper::forward(int finger, std::span<const double> q, std::span<Pose> poses_H) const {
  if (finger < 0 || finger >= 3)
    throw InputError(fmt::format("the gripper has fingers 0 .. 2, got {}", finger));
  chains_[static_cast<std::size_t>(finger)].forward(q, poses_H);
}

void Gripper::jacobian(int finger, std::span<const double> q,
                       Eigen::Ref<Eigen::Matrix<double, 6, Eigen::Dynamic>> jacobian) const {
  if (finger < 0 || finger >= 3)
    throw InputError(fmt::format("the gripper has fingers 0 .. 2, got {}", finger));
  chains_[static_cast<std::size_t>(finger)].jacobian(q, jacobian);
}

std::unique_ptr<CollisionScene> PlainBackend::build(TriangleMeshView mesh_O) const {
  return std::make_unique<PlainScene>(mesh_O);
}

void PlainBackend::distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                            std::span<double> distances) const {
  check_solids(a, distances.size());
  check_solids(b, distances.size());
  for (std::size_t i = 0; i < a.size(); ++i) distances[i] = distance_solids(a[i], b[i]);
}

std::vector<Block> job_blocks() {
  return {{"half sizes", 2, 0.015, 0.03}, {"half height", 1, 0.015, 0.1}, {"spread", 1, 0.02, 0.05},
          {"off", 1, -0.01, 0.01},        {"clearance", 1, 0.0, 0.04},    {"turn", 4, -1, 1},
          {"place", 3, -0.5, 0.5},        {"fingers", 1, 2, 3, {}, true}};
}

Job job_of(Case c) {
  Job job;
  job.half = {c[0], c[1], c[2]};
  job.spread = std::min(c[3], 1.8 * c[0]);
  job.off = c[4];
  job.clearance = c[5];
  const Eigen::Quaterniond turn(c[6], c[7], c[8], c[9]);
  if (turn.norm() > 1e-3) job.X_OB.R = turn.normalized().toRotationMatrix();
  job.X_OB.p = Vector(c[10], c[11], c[12]);
  job.three = c[13] > 2.5;
  return job;
}

Bench::Bench(const Job& job) : job_(job) {
  const Eigen::Matrix3d& R = job.X_OB.R;
  approach_O = -R.col(2), opposition_O = -R.col(1);
  const auto contact = [&](double x, double side) {
    return ContactFrame::at(job.X_OB * Vector(x, side * job.half.y(), job.off), -side * R.col(1), approach_O);
  };
  contacts = {contact(0, -1)};
  fingers = {FingerRole::kThumb, FingerRole::kIndex};
  if (job.three) {
    // Seen along the hand's z, which is the box's -z, the index at the hand's +x stands at the box's -x.
    contacts.push_back(contact(-0.5 * job.spread, 1)), contacts.push_back(contact(0.5 * job.spread, 1));
    fingers.push_back(FingerRole::kMiddle);
  } else {
    contacts.push_back(contact(0, 1));
  }
  scene_ = collision_.build(moved(box_mesh(-job.half, job.half), job.X_OB));
}

SimulationTask Bench::task() const {
  return {hand_, collision_, *scene_, contacts, fingers, approach_O, opposition_O, job_.clearance};
}

std::vector<Pose> finger_poses(const HandModel& hand, int finger, const Pose& X_OH,
                               const std::vector<double>& posture) {
  const Finger& f = hand.fingers()[static_cast<std::size_t>(finger)];
  std::vector<Pose> poses(static_cast<std::size_t>(f.joint_count) + 2);
  hand.forward(finger,
               std::span(posture).subspan(static_cast<std::size_t>(f.first_joint),
                                          static_cast<std::size_t>(f.joint_count)),
               poses);
  for (Pose& X : poses) X = X_OH * X;
  return poses;
}

std::vector<Vector> tips(const SimulationTask& task, const Pose& X_OH, const std::vector<double>& posture) {
  std::vector<Vector> places;
  for (const FingerRole role : task.fingers) {
    for (int f = 0; f < std::ssize(task.hand.fingers()); ++f) {
      if (task.hand.fingers()[static_cast<std::size_t>(f)].role == role)
        places.push_back(finger_poses(task.hand, f, X_OH, posture).back().p);
    }
  }
  return places;
}

std::vector<double> numbers_of(const Simulation& s) {
  std::vector<double> numbers = {static_cast<double>(s.status), s.contact_error_m,
                                 static_cast<double>(s.path.size())};
  numbers.insert(numbers.end(), s.X_OH.R.data(), s.X_OH.R.data() + 9);
  numbers.insert(numbers.end(), s.X_OH.p.data(), s.X_OH.p.data() + 3);
  for (const auto& posture : s.path) numbers.insert(numbers.end(), posture.begin(), posture.end());
  return numbers;
}

}  // namespace preshape::conformance
