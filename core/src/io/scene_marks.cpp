#include "io/scene_marks.h"

#include <cmath>

#include <fmt/format.h>

#include "preshape/geometry/solid_mesh.h"

namespace preshape {

Pose pose_along(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  Pose X_OA{Eigen::Matrix3d::Identity(), origin};
  const Eigen::Vector3d z = direction.normalized();
  const Eigen::Vector3d aside = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  X_OA.R.col(2) = z;
  X_OA.R.col(0) = aside.cross(z).normalized();
  X_OA.R.col(1) = z.cross(X_OA.R.col(0));
  return X_OA;
}

TriangleMesh bar_mesh(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  const Solid solid{Solid::Kind::kCapsule, radius, 0.5 * (to - from).norm(), {}};
  return transformed(solid_mesh(solid, 12), pose_along(0.5 * (from + to), to - from));
}

TriangleMesh outline_mesh(const std::vector<Eigen::Vector3d>& corners, double radius) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < corners.size(); ++i)
    append(mesh, bar_mesh(corners[i], corners[(i + 1) % corners.size()], radius));
  return mesh;
}

Eigen::Vector3d middle_beside_O(const GraspScene& scene) {
  const Eigen::Vector3d t = scene.opposition_O.cross(scene.approach_O);
  double forefingers = 0.0;
  for (std::size_t i = 1; i < scene.contacts.size(); ++i) forefingers += scene.contacts[i].p_OC.dot(t);
  const double thumb = scene.contacts.front().p_OC.dot(t);
  const auto count = static_cast<double>(scene.contacts.size() - 1);
  return 0.5 * (thumb + (count > 0.0 ? forefingers / count : thumb)) * t;
}

std::string colliding_links(const GraspScene& scene) {
  constexpr int kMost = 3;
  std::string names;
  int count = 0;
  for (const SceneLink& link : scene.links) {
    if (!link.collides || ++count > kMost) continue;
    names += (names.empty() ? "" : ", ") + link.name;
  }
  return count > kMost ? fmt::format("{} and {} more", names, count - kMost) : names;
}

}  // namespace preshape
