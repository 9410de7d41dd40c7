#include <algorithm>
#include <limits>

#include "preshape/geometry/distance.h"
#include "preshape/geometry/query_checks.h"
#include "preshape/geometry/ray_triangle.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

struct Face {
  Eigen::Vector3d a, b, c;
  std::int32_t triangle;
};

std::vector<Face> faces_of(TriangleMeshView mesh) {
  std::vector<Face> faces;
  for (const std::int32_t t : touchable_triangles(mesh)) {
    const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(corners[k])]; };
    faces.push_back({corner(0), corner(1), corner(2), t});
  }
  return faces;
}

/// Every query looks at every triangle.
class BruteScene final : public CollisionScene {
 public:
  explicit BruteScene(TriangleMeshView mesh) : faces_(faces_of(mesh)), extent_(extent_of(mesh)) {}

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check_rays(rays, hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const RayProbe probe(rays[i]);
      NearestHit nearest(extent_);
      for (const Face& face : faces_) nearest.offer(probe.distance(face.a, face.b, face.c), face.triangle);
      hits[i] = nearest.hit();
    }
  }

  void distance(std::span<const PosedSolid> solids_O, std::span<double> distances) const override {
    check_solids(solids_O, distances.size());
    for (std::size_t i = 0; i < solids_O.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (const Face& face : faces_) {
        least = std::min(least, distance_solid_triangle(solids_O[i], face.a, face.b, face.c));
      }
      distances[i] = least;
    }
  }

 private:
  std::vector<Face> faces_;
  double extent_;
};

class Brute final : public CollisionBackend {
 public:
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "watertight"}; }
  explicit Brute(const Parameters&) {}

  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const override {
    return std::make_unique<BruteScene>(mesh_O);
  }

  void distance(std::span<const PosedSolid> solids_a, std::span<const PosedSolid> solids_b,
                std::span<double> distances) const override {
    check_solids(solids_a, distances.size());
    check_solids(solids_b, distances.size());
    for (std::size_t i = 0; i < solids_a.size(); ++i)
      distances[i] = distance_solids(solids_a[i], solids_b[i]);
  }
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"brute", "1.0.0", "BSD-3-Clause", "the preshape developers",
      "Collision queries that look at every triangle"}),
    ({"collision/brute"}),
    preshape::component<Brute>("brute", "Looks at every triangle: slow, exact, the reference of the others"))
