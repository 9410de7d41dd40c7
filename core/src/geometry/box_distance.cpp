#include "geometry/box_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "preshape/geometry/distance.h"

namespace preshape {

namespace {

using Vector = Eigen::Vector3d;

// Corner i has the sign of bit k of i along axis k.
constexpr std::array<std::array<int, 2>, 12> kEdges = {
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

std::array<Vector, 8> corners_of(const Vector& half, const Pose& X = {}) {
  std::array<Vector, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] =
        X * Vector(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z());
  }
  return corners;
}

double distance_box_point(const Vector& half, const Vector& p) {
  return (p.cwiseAbs() - half).cwiseMax(0.0).norm();
}

/// Whether the axis has a gap between the box and the points. A cross product of near parallels (to 1e-8) is
/// mostly rounding, and says nothing that the faces' normals do not.
bool separates(const Vector& axis, double weight, const Vector& half, std::span<const Vector> points) {
  if (axis.squaredNorm() <= 1e-16 * weight) return false;
  const double reach = half.dot(axis.cwiseAbs());
  double lower = axis.dot(points[0]), upper = lower;
  for (const Vector& p : points.subspan(1)) {
    lower = std::min(lower, axis.dot(p)), upper = std::max(upper, axis.dot(p));
  }
  return lower > reach || upper < -reach;
}

/// Separating axes of the box at the origin and a convex body: the box's and the body's face normals, and the
/// cross products of their edges.
bool apart(const Vector& half, std::span<const Vector> points, std::span<const Vector> normals,
           std::span<const Vector> edges) {
  for (int k = 0; k < 3; ++k) {
    if (separates(Vector::Unit(k), 1.0, half, points)) return true;
  }
  for (const Vector& normal : normals) {
    if (separates(normal, 0.0, half, points)) return true;
  }
  for (const Vector& edge : edges) {
    for (int k = 0; k < 3; ++k) {
      if (separates(Vector::Unit(k).cross(edge), edge.squaredNorm(), half, points)) return true;
    }
  }
  return false;
}

double distance_edges_segment(const std::array<Vector, 8>& corners, const Vector& p, const Vector& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [i, k] : kEdges) {
    least = std::min(least, distance_segments(corners[static_cast<std::size_t>(i)],
                                              corners[static_cast<std::size_t>(k)], p, q));
  }
  return least;
}

}  // namespace

double distance_box_segment(const Vector& half, const Vector& p, const Vector& q) {
  const std::array<Vector, 2> points = {p, q};
  const std::array<Vector, 1> edges = {q - p};
  if (!apart(half, points, {}, edges)) return 0.0;
  return std::min({distance_box_point(half, p), distance_box_point(half, q),
                   distance_edges_segment(corners_of(half), p, q)});
}

double distance_box_triangle(const Vector& half, const Vector& a, const Vector& b, const Vector& c) {
  const std::array<Vector, 3> points = {a, b, c}, edges = {b - a, c - b, a - c};
  const std::array<Vector, 1> normals = {edges[0].cross(edges[1])};
  if (!apart(half, points, normals, edges)) return 0.0;
  const auto corners = corners_of(half);
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& p : points) least = std::min(least, distance_box_point(half, p));
  for (const Vector& p : corners) least = std::min(least, distance_point_triangle(p, a, b, c));
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, distance_edges_segment(corners, points[k], points[(k + 1) % 3]));
  }
  return least;
}

double distance_boxes(const Vector& half_a, const Vector& half_b, const Pose& X_AB) {
  const auto corners_a = corners_of(half_a), corners_b = corners_of(half_b, X_AB);
  const std::array<Vector, 3> axes_b = {X_AB.R.col(0), X_AB.R.col(1), X_AB.R.col(2)};
  if (!apart(half_a, corners_b, axes_b, axes_b)) return 0.0;
  const Pose X_BA = X_AB.inverse();
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& p : corners_b) least = std::min(least, distance_box_point(half_a, p));
  for (const Vector& p : corners_a) least = std::min(least, distance_box_point(half_b, X_BA * p));
  for (const auto& [i, k] : kEdges) {
    least = std::min(least, distance_edges_segment(corners_a, corners_b[static_cast<std::size_t>(i)],
                                                   corners_b[static_cast<std::size_t>(k)]));
  }
  return least;
}

}  // namespace preshape
