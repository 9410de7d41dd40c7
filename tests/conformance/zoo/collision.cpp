// Collision backends that are broken on purpose: each fails the check that its name begins with, and nothing
// else.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/geometry/distance.h"
#include "preshape/geometry/query_checks.h"
#include "preshape/geometry/ray_triangle.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;
using Vector = Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Fault {
  kNone,
  kFloat,
  kLeaksAtEdges,
  kThickLines,
  kSeesBehind,
  kDividesByZero,
  kNegativeZero,
  kNormalises,
  kNoDirection,
  kCornersOnly,
  kRoundBoxes,
  kKnowsTheShape,
  kInsideOut,
  kDropsBroken,
  kShortIndex,
  kHighest,
  kNeedsTriangles,
  kBorrows,
};

struct Face {
  Vector a, b, c;
  std::int32_t triangle;
};

std::vector<Face> faces_of(TriangleMeshView mesh, const std::vector<std::int32_t>& which) {
  std::vector<Face> faces;
  for (const std::int32_t t : which) {
    const Triangle& k = mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int i) { return mesh.vertices[static_cast<std::size_t>(k[i])]; };
    faces.push_back({corner(0), corner(1), corner(2), t});
  }
  return faces;
}

/// How near the ray's line passes to the segment.
double passes(const Ray& ray, const Vector& a, const Vector& b) {
  return distance_segments(ray.origin, ray.origin + 1e3 * ray.direction, a, b);
}

/// Looks at every triangle, and breaks one rule.
template <Fault fault>
class Scene final : public CollisionScene {
 public:
  explicit Scene(TriangleMeshView mesh) : view_(mesh), extent_(extent_of(mesh)) {
    if (fault == Fault::kDropsBroken) mesh = without_broken(mesh);
    if (fault == Fault::kNeedsTriangles && mesh.triangles.empty()) throw InputError("there are no triangles");
    auto touchable = touchable_triangles(mesh);
    if (fault == Fault::kShortIndex) {
      for (std::int32_t& t : touchable) t %= 65536;
    }
    if (fault == Fault::kInsideOut && is_inside_out(mesh)) touchable.clear();
    faces_ = faces_of(mesh, touchable);
    if (fault == Fault::kThickLines) add_lines(mesh, touchable);
  }

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check(rays, hits.size());
    const auto faces = fault == Fault::kBorrows ? faces_of(view_, touchable_triangles(view_)) : faces_;
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i], faces);
  }

  void distance(std::span<const PosedSolid> solids, std::span<double> distances) const override {
    check_solids(solids, distances.size());
    for (std::size_t i = 0; i < solids.size(); ++i) {
      distances[i] = kInfinity;
      for (const Face& face : faces_) distances[i] = std::min(distances[i], between(solids[i], face));
    }
  }

 private:
  static TriangleMeshView without_broken(TriangleMeshView mesh) {
    static thread_local std::vector<Triangle> whole;
    whole.clear();
    for (const Triangle& t : mesh.triangles) {
      const auto there = [&](std::int32_t k) {
        return k >= 0 && static_cast<std::size_t>(k) < mesh.vertices.size();
      };
      if (there(t[0]) && there(t[1]) && there(t[2])) whole.push_back(t);
    }
    mesh.triangles = whole;
    return mesh;
  }

  static bool is_inside_out(TriangleMeshView view) {
    if (view.triangles.empty()) return false;
    const TriangleMesh mesh{{view.vertices.begin(), view.vertices.end()},
                            {view.triangles.begin(), view.triangles.end()}};
    return mesh_topology(mesh).bounds_volume() && volume_properties(mesh).volume < 0.0;
  }

  void add_lines(TriangleMeshView mesh, const std::vector<std::int32_t>& touchable) {
    std::vector<std::int32_t> flat;
    for (std::int32_t t = 0; t < std::ssize(mesh.triangles); ++t) {
      if (!std::binary_search(touchable.begin(), touchable.end(), t)) flat.push_back(t);
    }
    lines_ = faces_of(mesh, flat);
  }

  static void check(std::span<const Ray> rays, std::size_t hits) {
    std::vector<Ray> mended(rays.begin(), rays.end());
    for (Ray& ray : mended) {
      const bool none = ray.direction.norm() == 0.0;
      if (fault == Fault::kNormalises && !none) ray.direction.normalize();
      if (fault == Fault::kNoDirection && none) ray.direction = Vector::UnitX();
    }
    check_rays(mended, hits);
  }

  RayHit nearest(Ray ray, const std::vector<Face>& faces) const {
    if (fault == Fault::kNormalises) ray.direction.normalize();
    if (ray.direction.norm() == 0.0) return {};
    if (fault == Fault::kSeesBehind) ray.origin -= 3e-7 * extent_ * ray.direction;
    const RayProbe probe(ray);
    NearestHit found(extent_);
    RayHit highest;
    for (const Face& face : faces) {
      double distance = probe.distance(face.a, face.b, face.c);
      if (fault == Fault::kLeaksAtEdges && on_an_edge(ray, face)) distance = kInfinity;
      if (fault == Fault::kDividesByZero && lies_in(ray, face)) return {std::nan(""), face.triangle};
      found.offer(distance, face.triangle);
      if (distance <= highest.distance) highest = {distance, distance < kInfinity ? face.triangle : -1};
    }
    for (const Face& line : lines_) {
      if (passes(ray, line.a, line.c) < 1e-9) found.offer((line.a - ray.origin).norm(), line.triangle);
    }
    RayHit hit = fault == Fault::kHighest ? highest : found.hit();
    if (fault == Fault::kSeesBehind && hit.met()) hit.distance = std::max(0.0, hit.distance - 3e-7 * extent_);
    if (fault == Fault::kNegativeZero && has_negative_zero(ray.direction)) hit.distance *= 1.001;
    if (fault == Fault::kFloat) hit.distance = static_cast<double>(static_cast<float>(hit.distance));
    return hit;
  }

  static bool has_negative_zero(const Vector& v) {
    return std::any_of(v.begin(), v.end(), [](double x) { return x == 0.0 && std::signbit(x); });
  }

  bool on_an_edge(const Ray& ray, const Face& f) const {
    const double near = 1e-9 * extent_;
    return std::min({passes(ray, f.a, f.b), passes(ray, f.b, f.c), passes(ray, f.c, f.a)}) < near;
  }

  static bool lies_in(const Ray& ray, const Face& f) {
    const Vector normal = (f.b - f.a).cross(f.c - f.a);
    return normal.dot(ray.direction) == 0.0 && normal.dot(ray.origin - f.a) == 0.0;
  }

  static double between(const PosedSolid& solid, const Face& f) {
    if (fault == Fault::kCornersOnly && solid.solid.kind == Solid::Kind::kSphere) {
      const double corner =
          std::min({(f.a - solid.X_OS.p).norm(), (f.b - solid.X_OS.p).norm(), (f.c - solid.X_OS.p).norm()});
      return std::max(0.0, corner - solid.solid.radius);
    }
    return distance_solid_triangle(solid, f.a, f.b, f.c);
  }

  TriangleMeshView view_;
  std::vector<Face> faces_, lines_;
  double extent_;
};

template <Fault fault>
class Backend final : public CollisionBackend {
 public:
  static std::vector<std::string> capabilities() {
    if constexpr (fault == Fault::kNone) return {"rejects_nonfinite", "watertight"};
    if constexpr (fault == Fault::kLeaksAtEdges) return {"watertight"};
    return {};
  }
  explicit Backend(const Parameters&) {}

  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh) const override {
    return std::make_unique<Scene<fault>>(mesh);
  }

  void distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                std::span<double> distances) const override {
    check_solids(a, distances.size());
    check_solids(b, distances.size());
    for (std::size_t i = 0; i < a.size(); ++i) distances[i] = distance_solids(rounded(a[i]), rounded(b[i]));
  }

 private:
  static PosedSolid rounded(PosedSolid solid) {
    if (fault == Fault::kRoundBoxes && solid.solid.kind == Solid::Kind::kBox) {
      solid.solid.kind = Solid::Kind::kSphere;
      solid.solid.radius = solid.solid.half_extents.norm();
    }
    return solid;
  }
};

/// Remembers meshes by what does not change when they move, and so does not see that they moved.
class Remembers final : public CollisionBackend {
 public:
  explicit Remembers(const Parameters&) {}
  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh) const override {
    Key key;
    double area = 0.0;
    for (const Triangle& t : mesh.triangles) key.insert(key.end(), {t[0], t[1], t[2]});
    for (const Face& f : faces_of(mesh, touchable_triangles(mesh)))
      area += (f.b - f.a).cross(f.c - f.a).norm();
    key.push_back(area > 0.0 ? static_cast<int>(std::lround(1e5 * std::log(area))) : 0);
    const std::lock_guard lock(mutex_);
    auto& known = known_[key];
    if (known.vertices.empty())
      known = {{mesh.vertices.begin(), mesh.vertices.end()}, {mesh.triangles.begin(), mesh.triangles.end()}};
    return std::make_unique<Scene<Fault::kNone>>(known);
  }
  void distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                std::span<double> distances) const override {
    Backend<Fault::kNone>(Parameters{}).distance(a, b, distances);
  }

 private:
  using Key = std::vector<int>;
  mutable std::mutex mutex_;
  mutable std::map<Key, TriangleMesh> known_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"zoo_collision", "1.0.0", "BSD-3-Clause", "the preshape developers", "Broken collision backends"}),
    ({"collision/good", "collision/b01_float", "collision/b02_leaks_at_edges", "collision/b03_thick_lines",
      "collision/b04_sees_behind", "collision/b05_divides_by_zero", "collision/b06_negative_zero",
      "collision/b07_normalises", "collision/b08_no_direction", "collision/b09_corners_only",
      "collision/b10_round_boxes", "collision/b12_knows_the_shape", "collision/b13_inside_out",
      "collision/b14_drops_broken", "collision/b17_short_index", "collision/b19_highest",
      "collision/b20_needs_triangles", "collision/b21_borrows"}),
    component<Backend<Fault::kNone>>("good", "Looks at every triangle"),
    component<Backend<Fault::kFloat>>("b01_float", "Tells distances in single precision"),
    component<Backend<Fault::kLeaksAtEdges>>("b02_leaks_at_edges", "Lets rays pass at edges"),
    component<Backend<Fault::kThickLines>>("b03_thick_lines", "Meets triangles without area"),
    component<Backend<Fault::kSeesBehind>>("b04_sees_behind", "Meets what lies just behind a ray"),
    component<Backend<Fault::kDividesByZero>>("b05_divides_by_zero", "Has no number for a ray in a face"),
    component<Backend<Fault::kNegativeZero>>("b06_negative_zero", "Measures too far along negative zeros"),
    component<Backend<Fault::kNormalises>>("b07_normalises", "Takes directions of any length"),
    component<Backend<Fault::kNoDirection>>("b08_no_direction", "Takes a direction of zero for a miss"),
    component<Backend<Fault::kCornersOnly>>("b09_corners_only", "Measures from spheres to corners"),
    component<Backend<Fault::kRoundBoxes>>("b10_round_boxes", "Takes boxes of a pair for balls"),
    component<Remembers>("b12_knows_the_shape", "Does not see that a mesh has moved"),
    component<Backend<Fault::kInsideOut>>("b13_inside_out", "Loses bodies whose faces look inwards"),
    component<Backend<Fault::kDropsBroken>>("b14_drops_broken", "Leaves triangles out that lack a corner"),
    component<Backend<Fault::kShortIndex>>("b17_short_index", "Numbers triangles with sixteen bits"),
    component<Backend<Fault::kHighest>>("b19_highest", "Names the highest of equal triangles"),
    component<Backend<Fault::kNeedsTriangles>>("b20_needs_triangles", "Refuses a mesh without triangles"),
    component<Backend<Fault::kBorrows>>("b21_borrows", "Looks into the caller's mesh later"))
