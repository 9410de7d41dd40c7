#pragma once

#include <vector>

#include "device.h"
#include "preshape/geometry/collision.h"

struct Face {
  Eigen::Vector3d a, b, c;  ///< [m]
  std::int32_t triangle;
};

/// Where a mesh lies in the cube [-1, 1]^3 of unit lengths, so that Embree's single precision does as well
/// for a body of micrometres or far from the origin as for any other.
struct UnitCube {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
  double size = 1.0;                                 ///< [m] half of the longest side

  Eigen::Vector3d to_unit(const Eigen::Vector3d& p) const { return (p - centre) / size; }
};

/// Embree's tree [Wald2014] over the boxes of triangles. Embree finds the boxes in single precision, each
/// grown by more than its rounding; whether and where a triangle is met is decided in double by the core's
/// tests. So the answers are those of looking at every triangle, to the last bit. Const calls may come from
/// several threads.
class BoxTree {
 public:
  /// @param extent of the whole mesh [m], for what counts as equal distances
  BoxTree(const DeviceHandle& device, std::vector<Face> faces, double extent);

  preshape::RayHit cast(const preshape::Ray& ray) const;
  /// Infinite without faces.
  double distance(const preshape::PosedSolid& solid) const;

 private:
  preshape::RayHit cast_at_all(const preshape::Ray& ray) const;
  double distance_to_all(const preshape::PosedSolid& solid) const;

  std::vector<Face> faces_;
  double extent_;
  UnitCube cube_;
  DeviceHandle device_;
  SceneHandle scene_;
};
