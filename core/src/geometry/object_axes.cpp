#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Eigenvalues>

#include "geometry/convex_hull.h"
#include "geometry/second_moments.h"
#include "geometry/smallest_box.h"
#include "preshape/geometry/object.h"

namespace preshape {

namespace {

// Extents that differ by less are equal: single precision rounds coordinates to 6e-8.
constexpr double kEqualExtents = 1e-6;
// Moments that differ by less have no direction between them worth trusting: rounding of 1e-7 would turn it
// by a milliradian.
constexpr double kEqualMoments = 1e-4;
// A body between two spheres whose radii differ by less is round: facets, not shape, would turn it.
constexpr double kRound = 0.95;

bool is_round(const ConvexHull& hull) {
  if (hull.facets.empty()) return false;
  const TriangleMesh body{hull.points, hull.facets};
  const Eigen::Vector3d centre = volume_properties(body).centroid;
  double inner = std::numeric_limits<double>::infinity(), outer = 0.0;
  for (std::size_t f = 0; f < body.triangles.size(); ++f) {
    const Eigen::Vector3d normal = body.area_vector(f);
    if (normal.norm() > 0.0) inner = std::min(inner, normal.normalized().dot(body.corner(f, 0) - centre));
  }
  for (const auto& p : body.vertices) outer = std::max(outer, (p - centre).norm());
  return inner >= kRound * outer;
}

Eigen::Vector3d extents_along(const TriangleMesh& mesh, const Eigen::Matrix3d& axes) {
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = axes.transpose() * mesh.corner(t, k);
      lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
    }
  }
  return upper - lower;
}

/// The axis with its largest component positive, the first of about equal ones.
Eigen::Vector3d pointing_up(const Eigen::Vector3d& axis) {
  int largest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(axis[k]) > std::abs(axis[largest]) + 1e-9) largest = k;
  }
  return axis[largest] < 0.0 ? Eigen::Vector3d(-axis) : axis;
}

/// Orders axes by falling extent, equal ones as near to the file's axes as they go, and fixes the signs.
Eigen::Matrix3d arranged(const TriangleMesh& mesh, const Eigen::Matrix3d& axes) {
  const Eigen::Vector3d extents = extents_along(mesh, axes);
  const double equal = kEqualExtents * extents.maxCoeff();
  std::array<int, 3> order = {0, 1, 2}, best = order;
  double nearest = -1.0;
  do {
    if (extents[order[1]] > extents[order[0]] + equal || extents[order[2]] > extents[order[1]] + equal)
      continue;
    const double near =
        std::abs(axes(0, order[0])) + std::abs(axes(1, order[1])) + std::abs(axes(2, order[2]));
    if (near > nearest + 1e-9) nearest = near, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  Eigen::Matrix3d R_FO;
  R_FO.col(0) = pointing_up(axes.col(best[0]));
  R_FO.col(1) = pointing_up(axes.col(best[1]));
  R_FO.col(2) = R_FO.col(0).cross(R_FO.col(1));
  return R_FO;
}

/// Axes of a plane of equal moments, across `third`: the file's axis that lies in it best, and its neighbour.
Eigen::Matrix3d axes_across(const Eigen::Vector3d& third) {
  int along = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(third[k]) < std::abs(third[along]) - 1e-9) along = k;
  }
  const Eigen::Vector3d file_axis = Eigen::Vector3d::Unit(along);
  Eigen::Matrix3d axes;
  axes.col(0) = (file_axis - third * third.dot(file_axis)).normalized();
  axes.col(1) = third.cross(axes.col(0));
  axes.col(2) = third;
  return axes;
}

Eigen::Matrix3d eigen_axes(const Eigen::Matrix3d& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  const Eigen::Vector3d& m = solver.eigenvalues();
  const bool low_pair = m[1] - m[0] <= kEqualMoments * m[2], high_pair = m[2] - m[1] <= kEqualMoments * m[2];
  if (low_pair && high_pair) return Eigen::Matrix3d::Identity();
  if (low_pair) return axes_across(solver.eigenvectors().col(2));
  if (high_pair) return axes_across(solver.eigenvectors().col(0));
  return solver.eigenvectors();
}

}  // namespace

Eigen::Matrix3d principal_axes(const TriangleMesh& mesh) {
  if (is_round(convex_hull(mesh.vertices))) return Eigen::Matrix3d::Identity();
  return arranged(mesh, eigen_axes(second_moments(mesh)));
}

Eigen::Matrix3d smallest_box_axes(const TriangleMesh& mesh) {
  const ConvexHull hull = convex_hull(mesh.vertices);
  if (is_round(hull)) return Eigen::Matrix3d::Identity();
  const std::array<Eigen::Matrix3d, 2> guesses = {Eigen::Matrix3d::Identity(),
                                                  eigen_axes(second_moments(mesh))};
  const Eigen::Matrix3d axes =
      smallest_box(hull.facets.empty() ? mesh.vertices : hull.points, hull.facets, guesses);
  const double turned = extents_along(mesh, axes).prod();
  const double as_in_file = extents_along(mesh, Eigen::Matrix3d::Identity()).prod();
  const bool tie = as_in_file <= turned * (1.0 + kEqualExtents);
  return arranged(mesh, tie ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : axes);
}

}  // namespace preshape
