// Distances of convex bodies by alternating projections. Each step gives two points, whose distance is an
// upper bound, and the direction between them, along which the bodies' extents give a lower one: the answer
// proves itself.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "oracle.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;

Vector on_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector ab = b - a;
  const double squared = ab.squaredNorm();
  return squared > 0.0 ? Vector(a + std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) * ab) : a;
}

/// A convex set with a radius about it: a point, a segment, a triangle or a box.
struct Convex {
  std::vector<Vector> corners;  ///< 1, 2 or 3; of a box none
  Pose X_OS;                    ///< of a box
  Vector half = Vector::Zero();
  double radius = 0.0;

  Vector nearest(const Vector& p) const {
    if (corners.empty()) {
      const Vector p_S = X_OS.R.transpose() * (p - X_OS.p);
      return X_OS * p_S.cwiseMin(half).cwiseMax(-half);
    }
    if (corners.size() < 3) return on_segment(p, corners.front(), corners.back());
    return nearest_of_triangle(p);
  }
  /// Least of n . x over the set.
  double lowest(const Vector& n) const {
    if (corners.empty()) return n.dot(X_OS.p) - (X_OS.R.transpose() * n).cwiseAbs().dot(half);
    double least = n.dot(corners[0]);
    for (const Vector& c : corners) least = std::min(least, n.dot(c));
    return least;
  }
  Vector middle() const {
    if (corners.empty()) return X_OS.p;
    Vector sum = Vector::Zero();
    for (const Vector& c : corners) sum += c;
    return sum / static_cast<double>(corners.size());
  }
  double reach() const {
    if (corners.empty()) return half.norm();
    double reach = 0.0;
    for (const Vector& c : corners) reach = std::max(reach, (c - middle()).norm());
    return reach;
  }

 private:
  Vector nearest_of_triangle(const Vector& p) const {
    const Vector &a = corners[0], &b = corners[1], &c = corners[2];
    const Vector n = (b - a).cross(c - a);
    const Vector foot = p - n * (n.dot(p - a) / n.squaredNorm());
    const bool inside = n.dot((b - a).cross(foot - a)) >= 0.0 && n.dot((c - b).cross(foot - b)) >= 0.0 &&
                        n.dot((a - c).cross(foot - c)) >= 0.0;
    Vector best = on_segment(p, a, b);
    for (const Vector& q : {on_segment(p, b, c), on_segment(p, c, a)}) {
      if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
    }
    return inside && (foot - p).squaredNorm() < (best - p).squaredNorm() ? foot : best;
  }
};

Convex convex_of(const PosedSolid& posed) {
  const Solid& s = posed.solid;
  if (s.kind == Solid::Kind::kBox) return {{}, posed.X_OS, s.half_extents, 0.0};
  const Vector along = posed.X_OS.R.col(2) * (s.kind == Solid::Kind::kCapsule ? s.half_length : 0.0);
  return {{posed.X_OS.p - along, posed.X_OS.p + along}, {}, Vector::Zero(), s.radius};
}

Bounds distance_of(const Convex& a, const Convex& b) {
  constexpr int kSteps = 400;
  const double radii = a.radius + b.radius;
  Vector p = a.nearest(b.middle()), q = b.nearest(p);
  Bounds bounds{0.0, (q - p).norm()};
  for (int i = 0; i < kSteps && bounds.upper - bounds.lower > 1e-12 * bounds.upper; ++i) {
    p = a.nearest(q), q = b.nearest(p);
    const double apart = (q - p).norm();
    bounds.upper = std::min(bounds.upper, apart);
    if (!(apart > 0.0)) break;
    const Vector n = (q - p) / apart;
    bounds.lower = std::max(bounds.lower, b.lowest(n) + a.lowest(-n));
    if (bounds.upper < radii) break;
  }
  return {std::max(0.0, bounds.lower - radii), std::max(0.0, bounds.upper - radii)};
}

}  // namespace

Bounds solid_distance(const PosedSolid& a, const PosedSolid& b) {
  return distance_of(convex_of(a), convex_of(b));
}

Bounds surface_distance(const TriangleMesh& mesh, const PosedSolid& solid) {
  const Convex body = convex_of(solid);
  Bounds least{INFINITY, INFINITY};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Convex triangle{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, {}, Vector::Zero(), 0.0};
    const double longest = 2.0 * triangle.reach();
    if (!(mesh.area_vector(t).norm() > kFlatTriangle * longest * longest)) continue;
    const double apart =
        (triangle.middle() - body.middle()).norm() - triangle.reach() - body.reach() - body.radius;
    if (apart > least.upper) continue;
    const Bounds bounds = distance_of(body, triangle);
    least = {std::min(least.lower, bounds.lower), std::min(least.upper, bounds.upper)};
  }
  return least;
}

std::string wrong_distance(double distance, const Bounds& bounds, double size) {
  const double slack = distance_slack(size);
  if (distance >= bounds.lower - slack && distance <= bounds.upper + slack && distance >= 0.0) return "";
  return fmt::format("the distance is told to be {}; it is between {} and {}", distance, bounds.lower,
                     bounds.upper);
}

}  // namespace preshape::conformance
