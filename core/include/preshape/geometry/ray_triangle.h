#pragma once

#include <limits>
#include <vector>

#include "preshape/geometry/collision.h"

namespace preshape {

/// Hits whose distances differ by less than this share of (distance + extent of the mesh) count as equal, and
/// the lowest triangle wins: on a shared edge the triangles' own distances differ by rounding.
inline constexpr double kEqualDistance = 1e-12;

/// A ray prepared for many triangles, with the watertight test of [Woop2013] in double: triangles are moved
/// and sheared into a frame in which the ray is the z axis, so that whether the ray passes left or right of
/// an edge is decided from the same numbers for both triangles of the edge. Rounding may give a ray to both,
/// never to none.
class PRESHAPE_API RayProbe {
 public:
  /// @param ray of unit or any other positive length; distances are in units of its direction
  explicit RayProbe(const Ray& ray);

  /// Distance at which the ray meets the triangle, edges and corners included, from either side; infinite
  /// when it does not. A triangle that the ray sees edge on, or one without area, is not met: its neighbours
  /// are. Where rounding lets one seem met all the same, it is met within its box, so that any tree of boxes
  /// finds it too.
  double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const;

 private:
  Eigen::Vector3d origin_;
  int x_, y_, z_;  ///< coordinates in the order in which the ray runs most along the last
  double shear_x_, shear_y_, scale_;
};

/// Collects hits in any order and answers with the nearest one; of equal ones (kEqualDistance) the lowest
/// triangle, whatever the order was.
class PRESHAPE_API NearestHit {
 public:
  /// @param extent of the mesh [m], for kEqualDistance
  explicit NearestHit(double extent) : extent_(extent) {}

  void offer(double distance, std::int32_t triangle);
  /// Nothing beyond this can change the answer.
  double limit() const { return nearest_ + kEqualDistance * (nearest_ + extent_); }
  RayHit hit() const;

 private:
  double extent_;
  double nearest_ = std::numeric_limits<double>::infinity();
  std::vector<RayHit> near_;  ///< within the limit when they were offered
};

}  // namespace preshape
