#include "preshape/geometry/collision.h"
#include "core/geometry/shapes.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

/// Writes down who dies when.
struct Diary {
  std::vector<std::string> entries;
};

class EmptyScene : public CollisionScene {
 public:
  explicit EmptyScene(Diary& diary) : diary_(diary) {}
  ~EmptyScene() override { diary_.entries.emplace_back("scene"); }
  void cast(std::span<const Ray>, std::span<RayHit> hits) const override {
    for (auto& hit : hits) hit = {};
  }
  void distance(std::span<const PosedSolid>, std::span<double>) const override {}

 private:
  Diary& diary_;
};

class EmptyBackend : public CollisionBackend {
 public:
  explicit EmptyBackend(Diary& diary) : diary_(diary) {}
  ~EmptyBackend() override { diary_.entries.emplace_back("backend"); }
  std::unique_ptr<CollisionScene> build(TriangleMeshView mesh) const override {
    diary_.entries.push_back("built of " + std::to_string(mesh.triangles.size()));
    return std::make_unique<EmptyScene>(diary_);
  }
  void distance(std::span<const PosedSolid>, std::span<const PosedSolid>, std::span<double>) const override {}

 private:
  Diary& diary_;
};

}  // namespace

TEST_CASE("Scene: it keeps its backend alive and goes before it") {
  Diary diary;
  auto scene = build_scene(std::make_shared<EmptyBackend>(diary), box_mesh({0, 0, 0}, {1, 1, 1}));
  CHECK(diary.entries == std::vector<std::string>{"built of 12"});
  auto copy = scene;
  scene.reset();
  std::vector<Ray> rays(1, {{0, 0, 0}, {1, 0, 0}});
  std::vector<RayHit> hits(1, {1.0, 3});
  copy->cast(rays, hits);
  CHECK_FALSE(hits[0].met());
  copy.reset();
  CHECK(diary.entries == std::vector<std::string>{"built of 12", "scene", "backend"});
}

TEST_CASE("Backend: an extension that it does not have is null") {
  Diary diary;
  CHECK(EmptyBackend(diary).extension("anything/1") == nullptr);
}

TEST_SUITE_END();
