#pragma once

#include <string>

#include "bodies.h"

namespace preshape::conformance {

// What rays and solids meet, found by looking at every triangle with simple means, independent of the plugins
// and of core's own geometry.

/// "" or a sentence that says why `hit` is no answer to the ray. Whether a ray that passes an edge within
/// rounding meets its triangle is left open, and so is the distance of a triangle that it grazes.
std::string wrong_hit(const Body& body, const Ray& ray, const RayHit& hit);

/// A number that is surely between two others.
struct Bounds {
  double lower = 0.0, upper = 0.0;
};

/// Distance of two filled solids.
Bounds solid_distance(const PosedSolid& a, const PosedSolid& b);
/// Distance of a filled solid to a mesh's surface; infinite for a mesh without triangles of an area.
Bounds surface_distance(const TriangleMesh& mesh, const PosedSolid& solid);

/// How far off a distance may be [m]. `size` is the length that the rounding of a backend goes with: those
/// that iterate may stop early (FCL 0.7 between a thin box and a capsule: up to 2.4e-5 of the size in 10000
/// pairs).
inline double distance_slack(double size) {
  return 1e-7 + 5e-5 * size;
}

/// "" or a sentence that says that the distance is not between the bounds.
std::string wrong_distance(double distance, const Bounds& bounds, double size);

}  // namespace preshape::conformance
