#include "io/smooth_normals.h"

#include <cmath>

namespace preshape {

std::vector<std::array<Eigen::Vector3f, 3>> smooth_normals(const TriangleMesh& mesh, double crease) {
  std::vector<Eigen::Vector3d> areas;
  std::vector<std::vector<std::int32_t>> around(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    areas.push_back(mesh.area_vector(t));
    for (const std::int32_t v : mesh.triangles[t])
      around[static_cast<std::size_t>(v)].push_back(static_cast<std::int32_t>(t));
  }
  const double least = std::cos(crease);
  std::vector<std::array<Eigen::Vector3f, 3>> normals(areas.size());
  for (std::size_t t = 0; t < areas.size(); ++t) {
    const Eigen::Vector3d own = areas[t].stableNormalized();
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d sum = areas[t];
      for (const std::int32_t other : around[static_cast<std::size_t>(mesh.triangles[t][k])]) {
        const Eigen::Vector3d& area = areas[static_cast<std::size_t>(other)];
        if (static_cast<std::size_t>(other) != t && area.dot(own) > least * area.norm()) sum += area;
      }
      normals[t][static_cast<std::size_t>(k)] = sum.stableNormalized().cast<float>();
    }
  }
  return normals;
}

}  // namespace preshape
