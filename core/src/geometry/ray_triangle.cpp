#include "preshape/geometry/ray_triangle.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "preshape/base/error.h"

// Compiled without fused multiply-add (see CMakeLists.txt): a * b - c * d must be exactly the negative of
// c * d - a * b, or the two triangles of an edge may both refuse a ray.

namespace preshape {

RayProbe::RayProbe(const Ray& ray) : origin_(ray.origin) {
  ray.direction.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  if (ray.direction[z_] < 0.0) std::swap(x_, y_);
  shear_x_ = ray.direction[x_] / ray.direction[z_];
  shear_y_ = ray.direction[y_] / ray.direction[z_];
  scale_ = 1.0 / ray.direction[z_];
}

double RayProbe::distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const {
  constexpr double kMissed = std::numeric_limits<double>::infinity();
  const double az = a[z_] - origin_[z_], bz = b[z_] - origin_[z_], cz = c[z_] - origin_[z_];
  const double ax = a[x_] - origin_[x_] - shear_x_ * az, ay = a[y_] - origin_[y_] - shear_y_ * az;
  const double bx = b[x_] - origin_[x_] - shear_x_ * bz, by = b[y_] - origin_[y_] - shear_y_ * bz;
  const double cx = c[x_] - origin_[x_] - shear_x_ * cz, cy = c[y_] - origin_[y_] - shear_y_ * cz;
  // Twice the areas that the ray makes with the sides. Rounding is monotonic, so a sign is never the wrong one.
  const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return kMissed;
  const double sum = u + v + w;
  if (sum == 0.0) return kMissed;
  const double distance = scale_ * (u * az + v * bz + w * cz) / sum;
  return distance >= 0.0 ? distance : kMissed;
}

void NearestHit::offer(double distance, std::int32_t triangle) {
  if (!(distance <= limit()) || std::isinf(distance)) return;
  nearest_ = std::min(nearest_, distance);
  near_.push_back({distance, triangle});
}

RayHit NearestHit::hit() const {
  RayHit best;
  for (const RayHit& hit : near_) {
    if (hit.distance <= limit() && (!best.met() || hit.triangle < best.triangle)) best.triangle = hit.triangle;
  }
  best.distance = nearest_;
  return best;
}

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
  if (mesh.vertices.empty()) return 0.0;
  Eigen::Vector3d lower = mesh.vertices[0], upper = lower;
  for (const auto& p : mesh.vertices) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  return (upper - lower).norm();
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
    throw InputError(fmt::format("there are {} rays but room for {} hits; give one hit a ray", rays.size(), hits));
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& ray = rays[i];
    const double length = ray.direction.norm();
    if (ray.origin.allFinite() && std::abs(length - 1.0) <= 1e-6) continue;
    const char* what = ray.origin.allFinite() ? "a direction that is not of unit length" : "an origin that is not finite";
    throw InputError(fmt::format("ray {} has {}: origin ({}, {}, {}), direction ({}, {}, {})", i, what, ray.origin.x(),
                                 ray.origin.y(), ray.origin.z(), ray.direction.x(), ray.direction.y(),
                                 ray.direction.z()));
  }
}

}  // namespace preshape
