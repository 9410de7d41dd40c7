#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

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

/// A mesh of which every query looks at every triangle: the place to build a tree of boxes instead. The kernels are
/// the core's: the watertight ray test [Woop2013] and closed forms for distances [Ericson2005, ch. 5].
class Scene final : public CollisionScene {
 public:
  explicit Scene(TriangleMeshView mesh) : extent_(extent_of(mesh)) {
    for (const std::int32_t t : touchable_triangles(mesh)) {
      const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
      const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(corners[k])]; };
      faces_.push_back({corner(0), corner(1), corner(2), t});
    }
  }

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check_rays(rays, hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const RayProbe probe(rays[i]);
      NearestHit nearest(extent_);  // of triangles met at the same distance it names the lowest
      for (const Face& face : faces_) nearest.offer(probe.distance(face.a, face.b, face.c), face.triangle);
      hits[i] = nearest.hit();
    }
  }

  void distance(std::span<const PosedSolid> solids_O, std::span<double> distances) const override {
    check_solids(solids_O, distances.size());
    for (std::size_t i = 0; i < solids_O.size(); ++i) {
      distances[i] = std::numeric_limits<double>::infinity();
      for (const Face& face : faces_) {
        distances[i] = std::min(distances[i], distance_solid_triangle(solids_O[i], face.a, face.b, face.c));
      }
    }
  }

 private:
  std::vector<Face> faces_;
  double extent_;  ///< [m]
};

class @CLASS@ final : public CollisionBackend {
 public:
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "watertight"}; }

  explicit @CLASS@(const Parameters&) {}

  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const override {
    return std::make_unique<Scene>(mesh_O);
  }

  void distance(std::span<const PosedSolid> solids_a, std::span<const PosedSolid> solids_b,
                std::span<double> distances) const override {
    check_solids(solids_a, distances.size());
    check_solids(solids_b, distances.size());
    for (std::size_t i = 0; i < solids_a.size(); ++i) distances[i] = distance_solids(solids_a[i], solids_b[i]);
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"@NAME@", "0.1.0", "BSD-3-Clause", "the @NAME@ authors", "Rays and distances without a tree"}),
                ({"collision/@NAME@"}),
                preshape::component<@CLASS@>("@NAME@", "Looks at every triangle of the mesh"))
