#include "box_tree.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "preshape/geometry/distance.h"
#include "preshape/geometry/ray_triangle.h"

namespace {

using namespace preshape;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// By how much boxes are grown, in the unit cube. A ray begins within 3 of the centre and leaves the cube
/// within 5: rounding its beginning (1.2e-7), its direction (3e-8 over 5) and the box (6e-8), and the walk's
/// own (a few 1e-7) come to less than 1e-6.
constexpr double kMargin = 2e-6;

/// Where a ray enters the ball around the unit cube.
constexpr double kBall = 2.0;

/// Beyond this many sizes of the body, rounding of the place itself nears the margin.
constexpr double kFar = 1e6;

Eigen::Vector3d low(const Face& face) {
  return face.a.cwiseMin(face.b).cwiseMin(face.c);
}
Eigen::Vector3d high(const Face& face) {
  return face.a.cwiseMax(face.b).cwiseMax(face.c);
}

UnitCube cube_around(const std::vector<Face>& faces) {
  if (faces.empty()) return {};
  Eigen::Vector3d lower = low(faces.front()), upper = high(faces.front());
  for (const Face& face : faces) lower = lower.cwiseMin(low(face)), upper = upper.cwiseMax(high(face));
  return {lower / 2 + upper / 2, (upper / 2 - lower / 2).maxCoeff()};  // halved first: neither overflows
}

struct Boxes {
  const std::vector<Face>& faces;
  UnitCube cube;
};

void bounds(const RTCBoundsFunctionArguments* of) {
  const Boxes& boxes = *static_cast<const Boxes*>(of->geometryUserPtr);
  const Face& face = boxes.faces[of->primID];
  const Eigen::Vector3f lower = (boxes.cube.to_unit(low(face)).array() - kMargin).cast<float>(),
                        upper = (boxes.cube.to_unit(high(face)).array() + kMargin).cast<float>();
  RTCBounds& box = *of->bounds_o;
  box.lower_x = lower.x(), box.lower_y = lower.y(), box.lower_z = lower.z();
  box.upper_x = upper.x(), box.upper_y = upper.y(), box.upper_z = upper.z();
}

/// What a ray meets, filled as Embree walks along it.
struct RayWalk : RTCIntersectContext {
  RayWalk(const Ray& ray, const std::vector<Face>& candidates, double extent, double size_of_unit)
      : faces(candidates), probe(ray), nearest(extent), size(size_of_unit) {
    rtcInitIntersectContext(this);
  }
  const std::vector<Face>& faces;
  RayProbe probe;
  NearestHit nearest;
  double size;
  double begin = 0.0;  ///< [unit] where Embree's ray begins on the asked one
  std::exception_ptr failure;
};

void meet(const RTCIntersectFunctionNArguments* at) {
  RayWalk& walk = *static_cast<RayWalk*>(at->context);
  if (!at->valid[0] || walk.failure) return;
  const Face& face = walk.faces[at->primID];
  float& farthest = reinterpret_cast<RTCRayHit*>(at->rayhit)->ray.tfar;
  const double distance = walk.probe.distance(face.a, face.b, face.c);
  if (!(distance <= walk.nearest.limit()) || std::isinf(distance)) return;
  try {
    walk.nearest.offer(distance, face.triangle);
    farthest =
        std::min(farthest, static_cast<float>(walk.nearest.limit() / walk.size - walk.begin + kMargin));
  } catch (...) {  // not through Embree
    walk.failure = std::current_exception();
    farthest = -1.0f;
  }
}

/// The least distance of a solid, found as Embree walks away from its middle.
struct SolidWalk {
  const std::vector<Face>& faces;
  const PosedSolid& solid;
  double size;    ///< [m] of a unit
  double around;  ///< [m] radius of a ball that has the solid in it
  double slack;   ///< [unit] rounding of the middle
  double least = kNever;
};

bool near(RTCPointQueryFunctionArguments* at) {
  SolidWalk& walk = *static_cast<SolidWalk*>(at->userPtr);
  if (walk.least == 0.0) return false;
  const Face& face = walk.faces[at->primID];
  const double distance = distance_solid_triangle(walk.solid, face.a, face.b, face.c);
  if (!(distance < walk.least)) return false;
  walk.least = distance;
  const double reach = (distance + walk.around) / walk.size;
  const auto radius = static_cast<float>(walk.least == 0.0 ? 0.0 : reach + walk.slack + kMargin * reach);
  if (!(radius < at->query->radius)) return false;
  at->query->radius = radius;
  return true;
}

/// Radius of a ball about the solid's frame that has it in it.
double radius_around(const PosedSolid& posed) {
  const Solid& solid = posed.solid;
  if (solid.kind == Solid::Kind::kSphere) return solid.radius;
  if (solid.kind == Solid::Kind::kCapsule) return solid.radius + solid.half_length;
  return solid.half_extents.norm();
}

SceneHandle scene_of(RTCDevice device, Boxes& boxes) {
  SceneHandle scene(rtcNewScene(device), rtcReleaseScene);
  GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER), rtcReleaseGeometry);
  throw_noted(device);
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.faces.size()));
  rtcSetGeometryUserData(geometry.get(), &boxes);  // asked for while committing only
  rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), meet);
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene.get(), geometry.get());
  // Not rtcCommitScene: that asks TBB for workers, which may start as late as when the device goes, and then
  // run code that has left memory.
  rtcJoinCommitScene(scene.get());
  throw_noted(device);
  return scene;
}

}  // namespace

BoxTree::BoxTree(const DeviceHandle& device, std::vector<Face> faces, double extent)
    : faces_(std::move(faces)),
      extent_(extent),
      cube_(cube_around(faces_)),
      device_(device),
      scene_(nullptr, rtcReleaseScene) {
  if (faces_.empty()) return;
  Boxes boxes{faces_, cube_};
  scene_ = scene_of(device.get(), boxes);
}

RayHit BoxTree::cast_at_all(const Ray& ray) const {
  const RayProbe probe(ray);
  NearestHit nearest(extent_);
  for (const Face& face : faces_) nearest.offer(probe.distance(face.a, face.b, face.c), face.triangle);
  return nearest.hit();
}

RayHit BoxTree::cast(const Ray& ray) const {
  if (faces_.empty()) return {};
  const Eigen::Vector3d origin = cube_.to_unit(ray.origin), &along = ray.direction;
  if (!(origin.cwiseAbs().maxCoeff() < kFar)) return cast_at_all(ray);
  RayWalk walk(ray, faces_, extent_, cube_.size);
  walk.begin = std::max(0.0, -origin.dot(along) / along.squaredNorm() - kBall);
  const Eigen::Vector3d entry = origin + walk.begin * along;
  if (entry.norm() > 1.5 * kBall) return {};  // passes the ball by, or runs away from it
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(entry.x());
  query.ray.org_y = static_cast<float>(entry.y());
  query.ray.org_z = static_cast<float>(entry.z());
  query.ray.dir_x = static_cast<float>(along.x());
  query.ray.dir_y = static_cast<float>(along.y());
  query.ray.dir_z = static_cast<float>(along.z());
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &walk, &query);
  if (walk.failure) std::rethrow_exception(walk.failure);
  return walk.nearest.hit();
}

double BoxTree::distance_to_all(const PosedSolid& solid) const {
  double least = kNever;
  for (const Face& face : faces_)
    least = std::min(least, distance_solid_triangle(solid, face.a, face.b, face.c));
  return least;
}

double BoxTree::distance(const PosedSolid& solid) const {
  if (faces_.empty()) return kNever;
  const Eigen::Vector3d middle = cube_.to_unit(solid.X_OS.p);
  if (!(middle.cwiseAbs().maxCoeff() < kFar)) return distance_to_all(solid);
  SolidWalk walk{faces_, solid, cube_.size, radius_around(solid), kMargin * (1.0 + middle.norm())};
  RTCPointQuery query{};
  query.x = static_cast<float>(middle.x());
  query.y = static_cast<float>(middle.y());
  query.z = static_cast<float>(middle.z());
  query.radius = static_cast<float>(middle.norm() + kBall + walk.slack);  // all of the cube
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_.get(), &query, &context, near, &walk);
  return walk.least;
}
