#include "preshape/geometry/ray_triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

// Compiled without fused multiply-add (see CMakeLists.txt): a * b - c * d must be exactly the negative of
// c * d - a * b, or the two triangles of an edge may both refuse a ray.

namespace preshape {

namespace {

/// By how much of its size and distance a triangle's box is grown: far more than the test's own rounding, less than the
/// margin of any tree (kEqualDistance of the whole mesh).
constexpr double kBoxMargin = 0.25 * kEqualDistance;

/// The part of a ray that runs through a triangle's box, by the way along the ray's main axis.
struct BoxPart {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
  bool empty() const { return from > to; }

  /// Cuts off what is outside along one axis, on which the corners are at a, b, c and the ray at slope * way.
  void cut(double a, double b, double c, double slope, double margin) {
    const double lower = std::min({a, b, c}) - margin, upper = std::max({a, b, c}) + margin;
    if (slope == 0.0) {
      if (lower > 0.0 || upper < 0.0) to = -std::numeric_limits<double>::infinity();
      return;
    }
    const double first = lower / slope, second = upper / slope;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
};

}  // namespace

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
  // Of a triangle seen edge on the areas are rounding alone: it may seem met by a ray that passes beside it in its plane,
  // and its distance may be that of any of its places. Its box knows better.
  const double weighted = u * az + v * bz + w * cz, way = weighted / sum;
  const double size = std::max({std::abs(ax - bx), std::abs(ay - by), std::abs(az - bz), std::abs(ax - cx), std::abs(ay - cy),
                                std::abs(az - cz)});
  const double margin = kBoxMargin * (std::abs(way) + size);
  BoxPart part;
  part.cut(a[x_] - origin_[x_], b[x_] - origin_[x_], c[x_] - origin_[x_], shear_x_, margin);
  part.cut(a[y_] - origin_[y_], b[y_] - origin_[y_], c[y_] - origin_[y_], shear_y_, margin);
  part.cut(az, bz, cz, 1.0, margin);
  if (part.empty()) return kMissed;
  const bool inside = way >= part.from && way <= part.to;
  const double distance = inside ? scale_ * weighted / sum : scale_ * (way < part.from ? part.from : part.to);
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
