#include "preshape/geometry/collision.h"

#include "preshape/base/assert.h"

namespace preshape {

CollisionScene::~CollisionScene() = default;
CollisionBackend::~CollisionBackend() = default;
const void* CollisionBackend::extension(const char*) const noexcept {
  return nullptr;
}

std::shared_ptr<const CollisionScene> build_scene(std::shared_ptr<const CollisionBackend> backend,
                                                  const TriangleMesh& mesh_O) {
  PRESHAPE_DEMAND(backend != nullptr);
  // Members die last to first: the scene goes before the backend, whose library holds the scene's code.
  struct Kept {
    std::shared_ptr<const CollisionBackend> backend;
    std::unique_ptr<CollisionScene> scene;
  };
  auto kept = std::make_shared<Kept>();
  kept->backend = std::move(backend);
  kept->scene = kept->backend->build(mesh_O);
  const CollisionScene* scene = kept->scene.get();
  return {std::move(kept), scene};
}

}  // namespace preshape
