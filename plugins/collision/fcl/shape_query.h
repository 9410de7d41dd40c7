#pragma once

#include <memory>

#include <fcl/geometry/collision_geometry.h>

#include "preshape/geometry/collision.h"

/// FCL's shape for a solid, centred on its frame as ours is.
std::unique_ptr<fcl::CollisionGeometryd> shape_of(const preshape::Solid& solid);

fcl::Transform3d transform_of(const preshape::Pose& pose);

/// Distance of two FCL geometries by FCL, 0 where they touch or overlap.
/// @param tolerance at which its iterations stop [m]
/// @throws PluginError when FCL fails
double fcl_distance(const fcl::CollisionGeometryd& a, const fcl::Transform3d& X_WA,
                    const fcl::CollisionGeometryd& b, const fcl::Transform3d& X_WB, double tolerance);
