#include "preshape/geometry/distance.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_distance.h"

namespace preshape {

namespace {

using Vector = Eigen::Vector3d;

/// A solid as its core and the radius about it: a point, a segment, or a box.
struct Core {
  Vector p, q;  ///< ends; the same for a sphere
  double radius;
};

Core core_of(const PosedSolid& posed) {
  const bool capsule = posed.solid.kind == Solid::Kind::kCapsule;
  const Vector along =
      capsule ? Vector(posed.X_OS.R.col(2) * posed.solid.half_length) : Vector(Vector::Zero());
  return {posed.X_OS.p - along, posed.X_OS.p + along, posed.solid.radius};
}

bool is_box(const PosedSolid& posed) {
  return posed.solid.kind == Solid::Kind::kBox;
}

double beyond(double distance, double radius) {
  return std::max(0.0, distance - radius);
}

/// Whether the segment goes through the triangle. In its plane, to rounding, it does not: there its ends and
/// the triangle's sides have the same distance to tell, and signs would be chance.
bool pierces(const Vector& p, const Vector& q, const Vector& a, const Vector& b, const Vector& c) {
  const Vector normal = (b - a).cross(c - a).normalized();
  const double height_p = normal.dot(p - a), height_q = normal.dot(q - a);
  if (height_p * height_q > 0.0) return false;
  const double flat = 1e-13 * ((p - a).norm() + (q - a).norm() + (b - a).norm() + (c - a).norm());
  if (std::abs(height_p) <= flat && std::abs(height_q) <= flat) return false;
  const Vector along = q - p;
  const double u = along.dot((b - p).cross(c - p)), v = along.dot((c - p).cross(a - p)),
               w = along.dot((a - p).cross(b - p));
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

}  // namespace

double distance_point_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector ab = b - a;
  const double squared = ab.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * ab).norm();
}

double distance_segments(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  // The least is at an end of one of them, or where both are crossed by their common perpendicular.
  double least = std::min({distance_point_segment(a, c, d), distance_point_segment(b, c, d),
                           distance_point_segment(c, a, b), distance_point_segment(d, a, b)});
  const Vector u = b - a, v = d - c, across = u.cross(v);
  const double squared = across.squaredNorm();
  if (!(squared > 0.0)) return least;
  // The foot on one segment is poor for near parallels, so the distance is taken from it, not along `across`.
  const double s = (c - a).cross(v).dot(across) / squared;
  if (s > 0.0 && s < 1.0) least = std::min(least, distance_point_segment(a + s * u, c, d));
  return least;
}

double distance_point_triangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c) {
  const Vector normal = (b - a).cross(c - a);
  const bool above = normal.dot((b - a).cross(p - a)) >= 0.0 && normal.dot((c - b).cross(p - b)) >= 0.0 &&
                     normal.dot((a - c).cross(p - c)) >= 0.0;
  if (above) return std::abs(normal.dot(p - a)) / normal.norm();
  return std::min(
      {distance_point_segment(p, a, b), distance_point_segment(p, b, c), distance_point_segment(p, c, a)});
}

double distance_segment_triangle(const Vector& p, const Vector& q, const Vector& a, const Vector& b,
                                 const Vector& c) {
  if (pierces(p, q, a, b, c)) return 0.0;
  return std::min({distance_point_triangle(p, a, b, c), distance_point_triangle(q, a, b, c),
                   distance_segments(p, q, a, b), distance_segments(p, q, b, c),
                   distance_segments(p, q, c, a)});
}

double distance_solid_triangle(const PosedSolid& solid, const Vector& a, const Vector& b, const Vector& c) {
  if (is_box(solid)) {
    const Pose X_SO = solid.X_OS.inverse();
    return distance_box_triangle(solid.solid.half_extents, X_SO * a, X_SO * b, X_SO * c);
  }
  const Core core = core_of(solid);
  if (solid.solid.kind == Solid::Kind::kSphere)
    return beyond(distance_point_triangle(core.p, a, b, c), core.radius);
  return beyond(distance_segment_triangle(core.p, core.q, a, b, c), core.radius);
}

double distance_solids(const PosedSolid& first, const PosedSolid& second) {
  if (is_box(second) && !is_box(first)) return distance_solids(second, first);
  const Core core = core_of(second);
  if (!is_box(first)) {
    const Core other = core_of(first);
    return beyond(distance_segments(other.p, other.q, core.p, core.q), other.radius + core.radius);
  }
  const Pose X_SO = first.X_OS.inverse();
  if (is_box(second)) {
    return distance_boxes(first.solid.half_extents, second.solid.half_extents, X_SO * second.X_OS);
  }
  return beyond(distance_box_segment(first.solid.half_extents, X_SO * core.p, X_SO * core.q), core.radius);
}

}  // namespace preshape
