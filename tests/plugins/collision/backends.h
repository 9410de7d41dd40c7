#pragma once

#include <string>
#include <vector>

#include "core/geometry/shapes.h"
#include "preshape/geometry/collision.h"
#include "support/registry.h"

namespace preshape::test {

/// Every backend of this build.
inline std::vector<std::string> backend_names() {
  return registry().names("collision");
}

inline std::shared_ptr<const CollisionBackend> backend(const std::string& name) {
  return registry().create<CollisionBackend>(name);
}

inline std::shared_ptr<const CollisionScene> scene(const std::string& name, const TriangleMesh& mesh) {
  return build_scene(backend(name), mesh);
}

inline std::vector<RayHit> cast(const CollisionScene& scene, const std::vector<Ray>& rays) {
  std::vector<RayHit> hits(rays.size());
  scene.cast(rays, hits);
  return hits;
}

inline std::vector<double> distances(const CollisionScene& scene, const std::vector<PosedSolid>& solids) {
  std::vector<double> values(solids.size());
  scene.distance(solids, values);
  return values;
}

inline PosedSolid sphere_at(const Eigen::Vector3d& p, double radius) {
  return {{Solid::Kind::kSphere, radius, 0, {0, 0, 0}}, {Eigen::Matrix3d::Identity(), p}};
}

/// A solid of any kind and orientation of about `size`.
inline PosedSolid random_solid(Random& random, double size, const Eigen::Vector3d& p) {
  PosedSolid solid;
  solid.solid.kind = static_cast<Solid::Kind>(random.below(3));
  solid.solid.radius = size * random.uniform(0.2, 1.0);
  solid.solid.half_length = size * random.uniform(0.2, 1.0);
  for (double& half : solid.solid.half_extents) half = size * random.uniform(0.2, 1.0);
  solid.X_OS = {random_rotation(random), p};
  return solid;
}

/// Rays from around a box through points in it.
inline std::vector<Ray> rays_at(Random& random, const Box& box, int count) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d target = box.centre() + random_vector(random).cwiseProduct(0.55 * box.extents());
    const Eigen::Vector3d direction = random_unit(random);
    rays.push_back({target - box.extents().norm() * random.uniform(0.0, 2.0) * direction, direction});
  }
  return rays;
}

}  // namespace preshape::test
