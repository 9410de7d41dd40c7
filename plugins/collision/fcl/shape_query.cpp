#include "shape_query.h"

#include <algorithm>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "preshape/base/error.h"

std::unique_ptr<fcl::CollisionGeometryd> shape_of(const preshape::Solid& solid) {
  switch (solid.kind) {
    case preshape::Solid::Kind::kSphere:
      return std::make_unique<fcl::Sphered>(solid.radius);
    case preshape::Solid::Kind::kCapsule:
      return std::make_unique<fcl::Capsuled>(solid.radius, 2 * solid.half_length);
    case preshape::Solid::Kind::kBox:
      return std::make_unique<fcl::Boxd>(2 * solid.half_extents);
  }
  throw preshape::InputError("a solid is neither sphere, capsule nor box");
}

fcl::Transform3d transform_of(const preshape::Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = pose.R;
  transform.translation() = pose.p;
  return transform;
}

double fcl_distance(const fcl::CollisionGeometryd& a, const fcl::Transform3d& X_WA,
                    const fcl::CollisionGeometryd& b, const fcl::Transform3d& X_WB, double tolerance) try {
  // Asked first: FCL's distance of bodies that overlap is -1 or worse, and slow to find.
  fcl::CollisionRequestd contact;
  contact.gjk_tolerance = tolerance;
  fcl::CollisionResultd met;
  if (fcl::collide(&a, X_WA, &b, X_WB, contact, met) > 0) return 0.0;
  fcl::DistanceRequestd request;
  request.distance_tolerance = tolerance;
  fcl::DistanceResultd result;
  return std::max(0.0, fcl::distance(&a, X_WA, &b, X_WB, request, result));
} catch (const std::exception& error) {
  throw preshape::PluginError(std::string("collision 'fcl': FCL failed: ") + error.what());
}
