#include "core/geometry/shapes.h"
#include "preshape/base/error.h"
#include "preshape/geometry/mesh_repair.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

/// The definition, pair by pair: a vertex goes to the first kept one within the tolerance.
std::size_t kept_by_definition(const std::vector<Eigen::Vector3d>& vertices, double tolerance) {
  std::vector<Eigen::Vector3d> kept;
  for (const auto& v : vertices) {
    bool near = false;
    for (const auto& k : kept) near = near || (k - v).norm() <= tolerance;
    if (!near) kept.push_back(v);
  }
  return kept.size();
}

double nearest_pair(const TriangleMesh& mesh) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      nearest = std::min(nearest, (mesh.vertices[i] - mesh.vertices[k]).norm());
  }
  return nearest;
}

bool says(const std::vector<std::string>& warnings, const std::string& part) {
  for (const auto& warning : warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Weld: loose triangles become the solid they were cut from") {
  const TriangleMesh sphere = sphere_mesh(3);
  TriangleMesh mesh = unwelded(sphere);
  const WeldReport report = weld(mesh, 0.0);
  CHECK(mesh.vertices.size() == sphere.vertices.size());
  CHECK(mesh.triangles.size() == sphere.triangles.size());
  CHECK(report.merged_vertices == static_cast<int>(3 * sphere.triangles.size() - sphere.vertices.size()));
  CHECK(report.collapsed_triangles == 0);
  CHECK(mesh_topology(mesh).watertight());
}

TEST_CASE("Weld: zero and minus zero are the same place") {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, -0.0}, {0, 1, -0.0}, {-1, 0, 0}},
                    {{0, 1, 2}, {3, 4, 5}}};
  CHECK(weld(mesh, 0.0).merged_vertices == 2);
}

TEST_CASE("Weld: no pair within the tolerance is missed, at whatever cell boundary") {
  Random random(2);
  for (const double tolerance : {1e-9, 1e-3, 0.03, 0.3, 3.0}) {
    for (int i = 0; i < 20; ++i) {
      TriangleMesh mesh;
      for (int t = 0; t < 60; ++t) {
        for (int k = 0; k < 3; ++k) {
          // Clusters of a few tolerances, at places that lie on cell boundaries as often as not.
          const Eigen::Vector3d place = (4.0 * random_vector(random)).array().round();
          mesh.vertices.push_back(place + 2 * tolerance * random_vector(random));
        }
        mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
      }
      const std::size_t expected = kept_by_definition(mesh.vertices, tolerance);
      const std::size_t before = mesh.vertices.size();
      const WeldReport report = weld(mesh, tolerance);
      CHECK(static_cast<std::size_t>(report.merged_vertices) == before - expected);
      if (mesh.vertices.size() > 1) CHECK(nearest_pair(mesh) > tolerance);
    }
  }
}

TEST_CASE("Weld: a chain of near vertices does not collapse into one") {
  TriangleMesh mesh;
  for (int i = 0; i < 100; ++i) mesh.vertices.emplace_back(0.9 * i, 0, 0);
  for (int i = 0; i < 100; ++i) mesh.triangles.emplace_back(i, (i + 4) % 100, (i + 8) % 100);
  weld(mesh, 1.0);
  CHECK(nearest_pair(mesh) > 1.0);
  CHECK(bounding_box(mesh).extents().x() > 85.0);
}

TEST_CASE("Weld: the first vertex of a group keeps its place, and unused ones go") {
  TriangleMesh mesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-8, 0, 0}, {1, 1, 0}},
                    {{1, 2, 3}, {4, 2, 5}}};
  weld(mesh, 1e-6);
  REQUIRE(mesh.vertices.size() == 4);
  CHECK(mesh.vertices[0] == Eigen::Vector3d(0, 0, 0));
  CHECK(mesh.triangles[1] == Triangle(0, 1, 3));
}

TEST_CASE("Weld: triangles that lose a corner go, flat and duplicate ones are counted and stay") {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 1e-9, 0}},
                    {{0, 1, 3}, {3, 0, 1}, {1, 0, 3}, {0, 1, 2}, {0, 4, 1}}};
  const WeldReport report = weld(mesh, 1e-6);
  CHECK(report.collapsed_triangles == 1);
  CHECK(report.flat_triangles == 1);
  CHECK(report.duplicate_triangles == 2);
  CHECK(mesh.triangles.size() == 4);
  CHECK(drop_flat_triangles(mesh) == 1);
  CHECK(mesh.vertices.size() == 3);
}

TEST_CASE("Weld: millions of times smaller or far away, the result is the same") {
  Random random(3);
  for (const double size : {1e-6, 1.0, 1e9}) {
    TriangleMesh mesh = unwelded(scaled(sphere_mesh(2), {size, size, size}));
    for (auto& v : mesh.vertices) v += 1e-9 * size * random_vector(random) + Eigen::Vector3d(5 * size, 0, 0);
    weld(mesh, 1e-7 * size);
    CHECK(mesh.vertices.size() == 162);
  }
}

TEST_CASE("Repair: an inward solid is turned and told, an outward one is left") {
  TriangleMesh mesh = inside_out(box_mesh({0, 0, 0}, {1, 2, 3}));
  const MeshRepair repair = repair_mesh(mesh);
  CHECK(repair.turned);
  CHECK(says(repair.warnings, "the faces pointed inwards; turned"));
  CHECK_NEAR(volume_properties(mesh).volume, 6.0, 16 * kEps);
  CHECK_FALSE(repair_mesh(mesh).turned);
  CHECK(repair_mesh(mesh).warnings.empty());
}

TEST_CASE("Repair: an open or inconsistent mesh is not turned") {
  TriangleMesh open = inside_out(box_mesh({0, 0, 0}, {1, 1, 1}));
  open.triangles.pop_back();
  CHECK_FALSE(repair_mesh(open).turned);
  TriangleMesh mixed = inside_out(box_mesh({0, 0, 0}, {1, 1, 1}));
  std::swap(mixed.triangles[0][0], mixed.triangles[0][1]);
  CHECK_FALSE(repair_mesh(mixed).turned);
}

TEST_CASE("Repair: each fault is told with its number") {
  TriangleMesh mesh = joined(box_mesh({0, 0, 0}, {1, 1, 1}), tetrahedron_mesh());
  mesh.triangles.pop_back();
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.emplace_back(0, 0, 1);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshRepair repair = repair_mesh(mesh);
  CHECK(says(repair.warnings, "1 triangle without area was dropped"));
  CHECK(says(repair.warnings, "1 triangle is there more than once"));
  CHECK(says(repair.warnings, "not closed: 3 open edges"));
  CHECK(says(repair.warnings, "3 edges belong to three or more triangles"));
  CHECK(says(repair.warnings, "neighbours disagree at 3 edges"));
  CHECK(says(repair.warnings, "in 2 pieces"));
}

TEST_CASE("Repair: meshes that cannot be used are refused in one sentence") {
  const auto refused = [](TriangleMesh mesh, const std::string& saying) {
    CHECK_THROWS_SAYING(repair_mesh(mesh), InputError, saying);
  };
  refused({}, "it has no triangles");
  refused({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}, "triangle 1 names vertex 3, but there are only 2");
  refused({{{0, 0, 0}, {1, 0, 0}}, {{0, -1, 1}}}, "triangle 1 names vertex 0");
  refused({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, "none of its triangles has an area");
  refused({{{0, 0, 0}, {1, 0, 0}, {0, 1, NAN}}, {{0, 1, 2}}},
          "it has a vertex at (0, 1, nan), which is not finite");
  refused({{{0, 0, 0}, {1e300, 0, 0}, {0, -1e300, 0}}, {{0, 1, 2}}}, "too large to compute with");
}

TEST_SUITE_END();
