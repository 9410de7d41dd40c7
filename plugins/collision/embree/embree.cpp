#include "box_tree.h"
#include "preshape/geometry/distance.h"
#include "preshape/geometry/query_checks.h"
#include "preshape/plugin/entry.h"

namespace {

using namespace preshape;

std::vector<Face> faces_of(TriangleMeshView mesh) {
  std::vector<Face> faces;
  for (const std::int32_t t : touchable_triangles(mesh)) {
    const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(corners[k])]; };
    faces.push_back({corner(0), corner(1), corner(2), t});
  }
  return faces;
}

class EmbreeScene final : public CollisionScene {
 public:
  EmbreeScene(const DeviceHandle& device, TriangleMeshView mesh)
      : tree_(device, faces_of(mesh), extent_of(mesh)) {}

  void cast(std::span<const Ray> rays, std::span<RayHit> hits) const override {
    check_rays(rays, hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = tree_.cast(rays[i]);
  }

  void distance(std::span<const PosedSolid> solids_O, std::span<double> distances) const override {
    check_solids(solids_O, distances.size());
    for (std::size_t i = 0; i < solids_O.size(); ++i) distances[i] = tree_.distance(solids_O[i]);
  }

 private:
  BoxTree tree_;
};

class Embree final : public CollisionBackend {
 public:
  static std::vector<std::string> capabilities() { return {"rejects_nonfinite", "watertight"}; }
  explicit Embree(const Parameters&) : device_(open_device()) {}

  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const override {
    return std::make_unique<EmbreeScene>(device_, mesh_O);
  }

  /// Embree knows no solids: two of them are compared by the core's closed forms.
  void distance(std::span<const PosedSolid> solids_a, std::span<const PosedSolid> solids_b,
                std::span<double> distances) const override {
    check_solids(solids_a, distances.size());
    check_solids(solids_b, distances.size());
    for (std::size_t i = 0; i < solids_a.size(); ++i)
      distances[i] = distance_solids(solids_a[i], solids_b[i]);
  }

 private:
  DeviceHandle device_;
};

}  // namespace

PRESHAPE_PLUGIN(
    ({"embree", "1.0.0", "BSD-3-Clause", "the preshape developers", "Collision queries by Embree 3.13"}),
    ({"collision/embree"}),
    preshape::component<Embree>("embree",
                                "Rays and distances on Embree's trees, decided in double precision"))
