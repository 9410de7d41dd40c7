#pragma once

#include <optional>
#include <span>
#include <vector>

#include "preshape/geometry/triangle_mesh.h"
#include "preshape/hand/hand_model.h"

namespace preshape {

/// The space between the fingers of an open preshape, which the object enters (thesis sec. 3.4, after Arbib):
/// everything in O [m].
///
/// The volume is the convex hull of the holding fingers' centre lines, each moved to both sides across the
/// hand by its fingertip's radius, so that two fingers in one plane have room between them.
///
/// The entrance is the surface that straight lines from fingertip to fingertip bound. Two fingertips bound a
/// strip, as wide as they are; of four, the surface is that of the triangles about their mean. The hand
/// should come along its normal through its centroid: how far that is from the approach axis tells how well
/// the hand fits its preshape.
struct ApproachVolume {
  TriangleMesh mesh_O;                      ///< the hull: closed, wound outwards
  double volume_m3 = 0.0;                   ///< > 0
  std::vector<Eigen::Vector3d> entrance_O;  ///< three corners or more, anticlockwise seen from the object
  Eigen::Vector3d centroid_O = Eigen::Vector3d::Zero();  ///< of the entrance
  Eigen::Vector3d normal_O = Eigen::Vector3d::UnitX();   ///< unit, normal_O . approach_O > 0

  /// Between the entrance's normal and the way that the hand comes, 0 .. pi / 2 [rad].
  PRESHAPE_API double angle_to(const Eigen::Vector3d& approach_O) const;
};

/// The hand as it stands open before a grasp.
struct OpenPreshape {
  const HandModel& hand;
  Pose X_OH;                        ///< hand base
  std::span<const double> posture;  ///< all joints in the order of HandModel::joints() [rad or m]
  std::span<const int> fingers;     ///< those that shall hold, indices into HandModel::fingers(); two or more
  Eigen::Vector3d approach_O;       ///< unit: the way the hand comes
  Eigen::Vector3d opposition_O;     ///< unit: the way the forefingers push, across the approach
};

/// The radius by which a finger is wide at its tip [m]: of the sphere, the capsule, or half the least side of
/// the box that its outermost link has; of several the largest, 0 where the finger has no solid.
PRESHAPE_API double fingertip_radius(const HandModel& hand, int finger);

/// The approach volume of an open preshape.
/// @returns nothing when the points of the fingers lie in a plane, or the fingertips bound nothing that the
/// hand could come through: seen along the approach they lie on a line (both to 1e-9 of their extent)
/// @throws InputError on fewer than two fingers, a finger that the hand has not or that is there twice, a
/// posture of another size, and axes that are not of unit length or not across each other (1e-6)
PRESHAPE_API std::optional<ApproachVolume> approach_volume(const OpenPreshape& preshape);

}  // namespace preshape
