#pragma once

#include <string>
#include <vector>

#include "preshape/base/random.h"
#include "preshape/geometry/collision.h"

namespace preshape::conformance {

/// A mesh to ask about.
struct Body {
  std::string name;
  TriangleMesh mesh;
  bool closed = false;  ///< and `inside` is a point in it
  Eigen::Vector3d inside = Eigen::Vector3d::Zero();

  Eigen::Vector3d centre() const;
  double extent() const;  ///< diagonal of the box around it
};

/// Spheres, boxes, a torus, slivers, soup, doubled, flat and missing triangles, far away, tiny and huge. None
/// is empty.
const std::vector<Body>& bodies();
const Body& body(std::string_view name);

TriangleMesh icosphere(int subdivisions);
TriangleMesh box_mesh(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);
/// A ring of radius 1 and a tube of radius 0.4 around z.
TriangleMesh torus(int around, int across);
TriangleMesh moved(TriangleMesh mesh, const Pose& X);
TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other);

Eigen::Vector3d random_unit(Random& random);
Eigen::Matrix3d random_rotation(Random& random);

RayHit cast_one(const CollisionScene& scene, const Ray& ray);
double distance_one(const CollisionScene& scene, const PosedSolid& solid);
double distance_one(const CollisionBackend& backend, const PosedSolid& a, const PosedSolid& b);

}  // namespace preshape::conformance
