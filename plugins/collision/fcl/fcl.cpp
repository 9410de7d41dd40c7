#include <limits>
#include <mutex>

#include "fcl_mesh.h"
#include "preshape/geometry/query_checks.h"
#include "preshape/plugin/entry.h"
#include "ray_tree.h"
#include "shape_query.h"

namespace {

using namespace preshape;

/// One tree for rays, and another for solids, of the only kind of volumes that FCL measures distances with at
/// a fair speed; it costs ten times the first to build, so it waits for the first solid.
class FclScene final : public CollisionScene {
 public:
  FclScene(TriangleMeshView mesh, double tolerance)
      : mesh_{{mesh.vertices.begin(), mesh.vertices.end()}, {mesh.triangles.begin(), mesh.triangles.end()}},
        touchable_(touchable_triangles(mesh)),
        rays_(mesh, touchable_),
        tolerance_(tolerance) {}

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check_rays(rays, hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = rays_.cast(rays[i]);
  }

  void distance(std::span<const PosedSolid> solids_O, std::span<double> distances) const override {
    check_solids(solids_O, distances.size());
    std::call_once(filled_, [&] { fill(solids_, mesh_, touchable_); });
    for (std::size_t i = 0; i < solids_O.size(); ++i) {
      distances[i] = touchable_.empty()
                         ? std::numeric_limits<double>::infinity()
                         : fcl_distance(solids_, fcl::Transform3d::Identity(), *shape_of(solids_O[i].solid),
                                        transform_of(solids_O[i].X_OS), tolerance_);
    }
  }

 private:
  TriangleMesh mesh_;
  std::vector<std::int32_t> touchable_;
  RayTree rays_;
  mutable std::once_flag filled_;
  mutable fcl::BVHModel<fcl::RSSd> solids_;
  double tolerance_;
};

class Fcl final : public CollisionBackend {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::number("tolerance", 1e-9, 1e-12, 1e-3, "m",
                                         "at which FCL's iterations for distances of solids stop")};
  }
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "watertight"}; }
  explicit Fcl(const Parameters& parameters) : tolerance_(parameters.number("tolerance")) {}

  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const override {
    return std::make_unique<FclScene>(mesh_O, tolerance_);
  }

  void distance(std::span<const PosedSolid> solids_a, std::span<const PosedSolid> solids_b,
                std::span<double> distances) const override {
    check_solids(solids_a, distances.size());
    check_solids(solids_b, distances.size());
    for (std::size_t i = 0; i < solids_a.size(); ++i) {
      distances[i] = fcl_distance(*shape_of(solids_a[i].solid), transform_of(solids_a[i].X_OS),
                                  *shape_of(solids_b[i].solid), transform_of(solids_b[i].X_OS), tolerance_);
    }
  }

 private:
  double tolerance_;
};

}  // namespace

PRESHAPE_PLUGIN(({"fcl", "1.0.0", "BSD-3-Clause", "the preshape developers", "Collision queries by FCL 0.7"}),
                ({"collision/fcl"}),
                preshape::component<Fcl>("fcl", "Rays on FCL's bounding-volume trees, distances by FCL"))
