#include "preshape/geometry/solid_mesh.h"

#include <numbers>

#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

/// The faces' sides cancel and point outwards.
void check_closed(const TriangleMesh& mesh) {
  CHECK(mesh_topology(mesh).watertight());
  CHECK(mesh_topology(mesh).inconsistent_edges == 0);
  CHECK(volume_properties(mesh).volume > 0.0);
}

}  // namespace

TEST_CASE("Solids as triangles are closed, wound outwards, and have the solid's volume as segments grow") {
  const double r = 0.02, h = 0.03, pi = std::numbers::pi;
  const Eigen::Vector3d half(0.01, 0.02, 0.03);
  const TriangleMesh ball = solid_mesh({Solid::Kind::kSphere, r, 0.0, {}}, 192);
  const TriangleMesh capsule = solid_mesh({Solid::Kind::kCapsule, r, h, {}}, 192),
                     box = solid_mesh({Solid::Kind::kBox, 0.0, 0.0, half});
  for (const TriangleMesh* mesh : {&ball, &capsule, &box}) check_closed(*mesh);
  const double sphere = 4.0 / 3.0 * pi * r * r * r;
  CHECK_NEAR(volume_properties(ball).volume / sphere, 1.0, 1e-3);
  CHECK_NEAR(volume_properties(capsule).volume / (sphere + 2.0 * h * pi * r * r), 1.0, 1e-3);
  CHECK_NEAR(volume_properties(box).volume, 8.0 * half.prod(), 8 * kEps * half.prod());
}

TEST_CASE(
    "Arrows are closed and run from the origin to their length along z, with one head or two, however "
    "short") {
  const double radius = 0.002, pi = std::numbers::pi;
  for (const int heads : {1, 2}) {
    for (const double length : {0.1, 0.012, 0.003}) {
      INFO("heads ", heads, " length ", length);
      const TriangleMesh arrow = arrow_mesh(length, radius, heads, 16);
      check_closed(arrow);
      const Box box = bounding_box(arrow);
      CHECK_NEAR(box.lower.z(), 0.0, 0.0);
      CHECK_NEAR(box.upper.z(), length, 0.0);
      CHECK_NEAR(box.extents().x(), 4.8 * radius, 1e-12);
    }
  }
  const double shaft = (0.1 - 6 * radius) * radius * radius * pi,
               cone = 2 * radius * pi * 2.4 * 2.4 * radius * radius;
  CHECK_NEAR(volume_properties(arrow_mesh(0.1, radius, 1, 400)).volume / (shaft + cone), 1.0, 1e-3);
}

TEST_SUITE_END();
