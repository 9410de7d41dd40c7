#include "preshape/geometry/ray_triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

double RayProbe::distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) const {
  constexpr double kMissed = std::numeric_limits<double>::infinity();
  const double az = a[z_] - origin_[z_], bz = b[z_] - origin_[z_], cz = c[z_] - origin_[z_];
  const double ax = a[x_] - origin_[x_] - shear_x_ * az, ay = a[y_] - origin_[y_] - shear_y_ * az;
  const double bx = b[x_] - origin_[x_] - shear_x_ * bz, by = b[y_] - origin_[y_] - shear_y_ * bz;
  const double cx = c[x_] - origin_[x_] - shear_x_ * cz, cy = c[y_] - origin_[y_] - shear_y_ * cz;
  // Twice the areas that the ray makes with the sides. Rounding is monotonic, so a sign is never the wrong
  // one.
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
    if (hit.distance <= limit() && (!best.met() || hit.triangle < best.triangle))
      best.triangle = hit.triangle;
  }
  best.distance = nearest_;
  return best;
}

}  // namespace preshape
