#include "preshape/geometry/query_checks.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

std::vector<std::int32_t> touchable_triangles(TriangleMeshView mesh) {
  std::vector<std::int32_t> touchable;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d* corners[3];
    for (int k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(mesh.triangles[t][k]);  // a negative index becomes a huge one
      const bool usable = v < mesh.vertices.size() && mesh.vertices[v].allFinite();
      if (!usable) throw InputError(fmt::format("triangle {} has no finite corner {}; mend the mesh", t, k));
      corners[k] = &mesh.vertices[v];
    }
    if (!is_flat(*corners[0], *corners[1], *corners[2])) touchable.push_back(static_cast<std::int32_t>(t));
  }
  return touchable;
}

double extent_of(TriangleMeshView mesh) {
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const auto& p : mesh.vertices) {
    if (!p.allFinite()) continue;  // of no triangle that may be met
    lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  }
  return (upper - lower).cwiseMax(0.0).norm();
}

void check_solids(std::span<const PosedSolid> solids, std::size_t distances) {
  if (solids.size() != distances) {
    throw InputError(fmt::format("there are {} solids but room for {} distances; give one distance a solid",
                                 solids.size(), distances));
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids[i].solid;
    const bool sized = solid.kind == Solid::Kind::kBox
                           ? solid.half_extents.allFinite() && solid.half_extents.minCoeff() >= 0.0
                           : std::isfinite(solid.radius) && solid.radius >= 0.0 &&
                                 (solid.kind == Solid::Kind::kSphere ||
                                  (std::isfinite(solid.half_length) && solid.half_length >= 0.0));
    if (!sized) throw InputError(fmt::format("solid {} has a size that is negative or not finite", i));
    const bool posed = solids[i].X_OS.p.allFinite() && solids[i].X_OS.R.allFinite();
    if (!posed) throw InputError(fmt::format("solid {} has a pose that is not finite", i));
  }
}

void check_rays(std::span<const Ray> rays, std::size_t hits) {
  if (rays.size() != hits) {
    throw InputError(
        fmt::format("there are {} rays but room for {} hits; give one hit a ray", rays.size(), hits));
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& ray = rays[i];
    const double length = ray.direction.norm();
    if (ray.origin.allFinite() && std::abs(length - 1.0) <= 1e-6) continue;
    const char* what =
        ray.origin.allFinite() ? "a direction that is not of unit length" : "an origin that is not finite";
    throw InputError(fmt::format("ray {} has {}: origin ({}, {}, {}), direction ({}, {}, {})", i, what,
                                 ray.origin.x(), ray.origin.y(), ray.origin.z(), ray.direction.x(),
                                 ray.direction.y(), ray.direction.z()));
  }
}

}  // namespace preshape
