#include "preshape/grasp/approach_volume.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "geometry/convex_hull.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/hand/posture.h"

namespace preshape {

namespace {

constexpr double kUnit = 1e-6;     // of an axis's length, and of the axes' inner product
constexpr double kOnALine = 1e-9;  // of the fingertips' extent squared

using Points = std::vector<Eigen::Vector3d>;

void check_axes(const OpenPreshape& preshape) {
  const Eigen::Vector3d &a = preshape.approach_O, &o = preshape.opposition_O;
  if (std::abs(a.norm() - 1.0) <= kUnit && std::abs(o.norm() - 1.0) <= kUnit && std::abs(a.dot(o)) <= kUnit)
    return;
  throw InputError(fmt::format(
      "approach_volume: approach ({:g}, {:g}, {:g}) and opposition ({:g}, {:g}, {:g}) must be of unit length "
      "and at a right angle",
      a.x(), a.y(), a.z(), o.x(), o.y(), o.z()));
}

void check(const OpenPreshape& preshape) {
  check_axes(preshape);
  require_size("posture", preshape.hand.joints().size(), preshape.posture.size());
  const int count = static_cast<int>(preshape.hand.fingers().size());
  if (preshape.fingers.size() < 2)
    throw InputError(
        fmt::format("approach_volume: expected two fingers or more, got {}", preshape.fingers.size()));
  for (std::size_t i = 0; i < preshape.fingers.size(); ++i) {
    const int finger = preshape.fingers[i];
    if (finger < 0 || finger >= count)
      throw InputError(fmt::format(
          "approach_volume: finger {} is not one of the hand's {}, which count from 0", finger, count));
    if (std::count(preshape.fingers.begin(), preshape.fingers.end(), finger) > 1)
      throw InputError(fmt::format("approach_volume: finger {} is given twice", finger));
  }
}

/// A point moved to either side.
void add_both(Points& points, const Eigen::Vector3d& p, const Eigen::Vector3d& aside) {
  points.push_back(p - aside);
  points.push_back(p + aside);
}

/// What bounds the volume, and what the entrance.
struct Outline {
  Points volume_O, entrance_O;
};

Outline outline_of(const OpenPreshape& preshape) {
  Outline outline;
  const Eigen::Vector3d t = preshape.opposition_O.cross(preshape.approach_O);
  for (const int finger : preshape.fingers) {
    const Eigen::Vector3d aside = fingertip_radius(preshape.hand, finger) * t;
    const auto poses_H = finger_poses(preshape.hand, finger, preshape.posture);
    for (const Pose& X_HL : poses_H) add_both(outline.volume_O, preshape.X_OH * X_HL.p, aside);
    const Eigen::Vector3d tip = preshape.X_OH * poses_H.back().p;
    if (preshape.fingers.size() == 2)
      add_both(outline.entrance_O, tip, aside);
    else
      outline.entrance_O.push_back(tip);
  }
  return outline;
}

Eigen::Vector3d mean_of(const Points& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Puts corners in turn about their mean, anticlockwise where the approach comes towards the eye: no two
/// sides cross.
void put_in_turn(Points& corners, const OpenPreshape& preshape) {
  const Eigen::Vector3d mean = mean_of(corners), x = preshape.opposition_O, y = preshape.approach_O.cross(x);
  const auto angle = [&](const Eigen::Vector3d& p) {
    return std::atan2((p - mean).dot(y), (p - mean).dot(x));
  };
  std::sort(corners.begin(), corners.end(),
            [&](const auto& p, const auto& q) { return angle(p) < angle(q); });
}

/// Normal and centroid of the corners' surface; false when it is none as the hand sees it.
bool measure_entrance(ApproachVolume& volume, const Eigen::Vector3d& approach_O) {
  const Points& corners = volume.entrance_O;
  const Eigen::Vector3d mean = mean_of(corners);
  double extent = 0.0;
  Points areas;
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    extent = std::max(extent, (corners[i] - mean).norm());
    areas.push_back((corners[i] - mean).cross(corners[(i + 1) % corners.size()] - mean));
    area += areas.back();
  }
  if (!(area.dot(approach_O) > kOnALine * extent * extent)) return false;
  volume.normal_O = area.normalized();
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    moved +=
        areas[i].dot(volume.normal_O) / 3.0 * (corners[i] + corners[(i + 1) % corners.size()] - 2.0 * mean);
  volume.centroid_O = mean + moved / area.norm();
  return true;
}

double half_least_side(const Solid& solid) {
  return solid.kind == Solid::Kind::kBox ? solid.half_extents.minCoeff() : solid.radius;
}

}  // namespace

double ApproachVolume::angle_to(const Eigen::Vector3d& approach_O) const {
  return std::atan2(normal_O.cross(approach_O).norm(), normal_O.dot(approach_O));
}

double fingertip_radius(const HandModel& hand, int finger) {
  int outermost = -1;
  double radius = 0.0;
  for (const LinkSolid& solid : hand.solids()) {
    if (solid.finger != finger || solid.link < outermost) continue;
    radius = solid.link > outermost ? half_least_side(solid.solid)
                                    : std::max(radius, half_least_side(solid.solid));
    outermost = solid.link;
  }
  return radius;
}

std::optional<ApproachVolume> approach_volume(const OpenPreshape& preshape) {
  check(preshape);
  Outline outline = outline_of(preshape);
  ConvexHull hull = convex_hull(outline.volume_O);
  if (hull.facets.empty()) return std::nullopt;
  ApproachVolume volume;
  volume.mesh_O = {std::move(hull.points), std::move(hull.facets)};
  volume.volume_m3 = volume_properties(volume.mesh_O).volume;
  volume.entrance_O = std::move(outline.entrance_O);
  put_in_turn(volume.entrance_O, preshape);
  if (!measure_entrance(volume, preshape.approach_O)) return std::nullopt;
  return volume;
}

}  // namespace preshape
