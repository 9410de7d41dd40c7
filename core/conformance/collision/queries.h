#pragma once

#include "../context.h"
#include "oracle.h"

namespace preshape::conformance {

/// The bodies' scenes, made as they are asked for.
class Scenes {
 public:
  explicit Scenes(Context& context)
      : backend_(context.create<CollisionBackend>()), scenes_(bodies().size()) {}
  const CollisionScene& of(const Body& body);
  const CollisionBackend& backend() const { return *backend_; }
  std::shared_ptr<const CollisionScene> build(const TriangleMesh& mesh) const {
    return build_scene(backend_, mesh);
  }

 private:
  std::shared_ptr<const CollisionBackend> backend_;
  std::vector<std::shared_ptr<const CollisionScene>> scenes_;
};

/// A ray through a place in the box around a body: numbers of a case.
std::vector<Block> ray_blocks();
inline constexpr std::size_t kRayNumbers = 7;
/// @returns a direction of length 0 when the numbers give none
Ray ray_at(const Body& body, Case numbers);

/// A solid near a body, in parts of its extent.
std::vector<Block> solid_blocks(const std::string& name = "solid");
inline constexpr std::size_t kSolidNumbers = 11;
PosedSolid solid_at(Case numbers, const Eigen::Vector3d& centre, double size);

/// The block that names a body by its place in bodies().
Block body_block();
const Body& body_of(Case numbers);

/// Calls that shall be refused as InputError: "" or a sentence that says what came instead.
std::string not_refused(const std::function<void()>& call, std::string* message = nullptr);

void b01_nearest_hit(Context& context);
void b02_watertight(Context& context);
void b03_flat_triangles(Context& context);
void b04_rays_from_the_surface(Context& context);
void b05_rays_in_a_face(Context& context);
void b06_signed_zeros(Context& context);
void b07_unit_directions(Context& context);
void b08_no_direction(Context& context);
void b09_distances_to_the_surface(Context& context);
void b10_distances_of_pairs(Context& context);
void b12_moves_with_the_body(Context& context);
void b13_order_and_winding(Context& context);
void b14_refuses_broken_meshes(Context& context);
void b17_large_meshes(Context& context);
void b19_lowest_of_equals(Context& context);
void b20_empty_mesh(Context& context);
void b21_keeps_its_own_mesh(Context& context);

}  // namespace preshape::conformance
