// Test of @NAME@. Its one argument is the folder of the plugin.
#include <cmath>
#include <cstdio>

#include "preshape/base/error.h"
#include "preshape/geometry/collision.h"
#include "preshape/plugin/registry.h"

namespace {

int failures = 0;

void check(bool holds, const char* sentence) {
  if (!holds) std::printf("FAILED: %s\n", sentence);
  failures += !holds;
}

}  // namespace

int main(int, char** argv) {
  using namespace preshape;
  const Registry registry({{argv[1], "test"}});
  const auto backend = registry.create<CollisionBackend>("@NAME@");
  TriangleMesh square_O;  // of side 2 in the plane z = 0, about the origin
  square_O.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square_O.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto scene = backend->build(square_O);

  const Ray rays[3] = {{{0.5, -0.5, 2}, {0, 0, -1}}, {{0, 0, 2}, {0, 0, -1}}, {{3, 0, 2}, {0, 0, -1}}};
  RayHit hits[3];
  scene->cast(rays, hits);
  check(hits[0].triangle == 0 && std::abs(hits[0].distance - 2) < 1e-12, "a ray meets the triangle below it");
  check(hits[1].triangle == 0, "on the common edge the lower triangle is named");
  check(!hits[2].met() && std::isinf(hits[2].distance), "a ray beside the square meets nothing");

  PosedSolid ball;
  ball.solid.radius = 0.25;
  ball.X_OS.p = {0, 0, 1};
  double distance = 0.0;
  scene->distance({&ball, 1}, {&distance, 1});
  check(std::abs(distance - 0.75) < 1e-12, "the distance of a ball is that of its surface");
  backend->distance({&ball, 1}, {&ball, 1}, {&distance, 1});
  check(distance == 0.0, "solids that overlap are at distance 0");

  bool refused = false;
  try {
    const Ray bent{{0, 0, 2}, {0, 0, -2}};
    scene->cast({&bent, 1}, {hits, 1});
  } catch (const InputError&) {
    refused = true;
  }
  check(refused, "a direction that is not of unit length is refused");
  std::printf("@NAME@: %s\n", failures == 0 ? "all checks hold" : "see above");
  return failures == 0 ? 0 : 1;
}
