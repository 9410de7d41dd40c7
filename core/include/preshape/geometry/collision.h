#pragma once

#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "preshape/geometry/triangle_mesh.h"
#include "preshape/spatial/pose.h"

namespace preshape {

/// p(s) = origin + s * direction, s >= 0. The direction is of unit length.
struct Ray {
  Eigen::Vector3d origin;     ///< [m]
  Eigen::Vector3d direction;  ///< unit
};

/// The nearest triangle that a ray meets, from either side.
struct RayHit {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinite when nothing is met
  std::int32_t triangle = -1;  ///< of triangles met at the same distance (a shared edge) the lowest index
  bool met() const { return triangle >= 0; }
};

/// A convex solid of a hand's link or a probe, centred on its own frame S.
struct Solid {
  enum class Kind : std::int32_t { kSphere, kCapsule, kBox };
  Kind kind = Kind::kSphere;
  double radius = 0.0;       ///< [m] sphere, capsule
  double half_length = 0.0;  ///< [m] capsule: along z, from the middle to the centre of an end
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();  ///< [m] box
};

struct PosedSolid {
  Solid solid;
  Pose X_OS;
};

/// A mesh prepared for queries. Const calls may come from several threads at once.
class PRESHAPE_API CollisionScene {
 public:
  virtual ~CollisionScene();

  /// The nearest hit of each ray; `hits` has the size of `rays`. Triangles without area are never met. A ray
  /// through an edge or a corner of a closed mesh meets it. Distances are accurate to 1e-9 of the larger of
  /// the mesh's extent and the distance of the origin.
  /// @throws InputError on a direction that is not finite or not of unit length (1e-6), or a size mismatch
  virtual void cast(std::span<const Ray> rays, std::span<RayHit> hits) const = 0;

  /// Distance [m] of each solid to the surface of the mesh, 0 where they touch or cross. The inside of the
  /// mesh is not told from the outside: the surface counts.
  virtual void distance(std::span<const PosedSolid> solids_O, std::span<double> distances) const = 0;
};

/// Kind `collision`: builds scenes and compares solids.
class PRESHAPE_API CollisionBackend {
 public:
  virtual ~CollisionBackend();

  /// The scene keeps what it needs; the view need not outlive the call. [any thread, const]
  virtual std::unique_ptr<CollisionScene> build(TriangleMeshView mesh_O) const = 0;

  /// Distance [m] of the pairs solids_a[i], solids_b[i]; 0 where they touch or overlap. [any thread, const]
  virtual void distance(std::span<const PosedSolid> solids_a, std::span<const PosedSolid> solids_b,
                        std::span<double> distances) const = 0;

  /// Growth without a change of this interface: an extension by its id, or null.
  virtual const void* extension(const char* id) const noexcept;
};

/// A scene that keeps its backend (and so the backend's library) alive.
PRESHAPE_API std::shared_ptr<const CollisionScene> build_scene(
    std::shared_ptr<const CollisionBackend> backend, const TriangleMesh& mesh_O);

}  // namespace preshape
