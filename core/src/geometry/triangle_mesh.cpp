#include "preshape/geometry/triangle_mesh.h"

#include <Eigen/Geometry>

#include "preshape/base/assert.h"

namespace preshape {

Box bounding_box(const TriangleMesh& mesh) {
  PRESHAPE_DEMAND(!mesh.triangles.empty());
  Box box{mesh.corner(0, 0), mesh.corner(0, 0)};
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t vertex : triangle) {
      const Eigen::Vector3d& p = mesh.vertices[static_cast<std::size_t>(vertex)];
      box.lower = box.lower.cwiseMin(p);
      box.upper = box.upper.cwiseMax(p);
    }
  }
  return box;
}

VolumeProperties volume_properties(const TriangleMesh& mesh) {
  // Tetrahedra from the middle of the box: from a far origin they would cancel digits away.
  const Eigen::Vector3d middle = bounding_box(mesh).centre();
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0) - middle, b = mesh.corner(t, 1) - middle,
                          c = mesh.corner(t, 2) - middle;
    const double part = a.dot(b.cross(c)) / 6.0;
    volume += part;
    moment += part * (a + b + c) / 4.0;
  }
  return {volume, middle + moment / volume};
}

bool is_flat(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, bc = c - b;
  const double longest_squared = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
  return !(ab.cross(ac).norm() > kFlatTriangle * longest_squared);
}

}  // namespace preshape
