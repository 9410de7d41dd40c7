#include <numbers>

#include "core/geometry/shapes.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

TEST_CASE("Box: vertices that no triangle uses do not count") {
  TriangleMesh mesh = box_mesh({-1, -2, -3}, {4, 5, 6});
  mesh.vertices.emplace_back(100, 100, 100);
  CHECK_NEAR(bounding_box(mesh).lower, Eigen::Vector3d(-1, -2, -3), 0);
  CHECK_NEAR(bounding_box(mesh).upper, Eigen::Vector3d(4, 5, 6), 0);
  CHECK_NEAR(bounding_box(mesh).centre(), Eigen::Vector3d(1.5, 1.5, 1.5), 0);
}

TEST_CASE(
    "Volume: a box has the product of its sides and its middle, wherever it is and however it is turned") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d R = random_rotation(random);
    const Eigen::Vector3d p = 100 * random_vector(random);
    const TriangleMesh mesh = moved(box_mesh({-1, -2, -3}, {4, 5, 6}), R, p);
    const VolumeProperties properties = volume_properties(mesh);
    CHECK_NEAR(properties.volume, 315.0, 1e-10);  // 315 * eps * (100 / 9, from the far place) and some
    CHECK_NEAR(properties.centroid, Eigen::Vector3d(R * Eigen::Vector3d(1.5, 1.5, 1.5) + p), 1e-12 * 200);
  }
}

TEST_CASE("Volume: an inward mesh has the negative volume and the same centroid") {
  const TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  CHECK(volume_properties(inside_out(mesh)).volume == -volume_properties(mesh).volume);
  CHECK_NEAR(volume_properties(inside_out(mesh)).centroid, Eigen::Vector3d(0.5, 1, 1.5), 4 * kEps);
}

TEST_CASE("Volume: finer and finer spheres come up to 4/3 pi from below, four times nearer each time") {
  const double exact = 4.0 / 3.0 * std::numbers::pi;
  double before = exact - volume_properties(sphere_mesh(2)).volume;
  for (int level = 3; level < 6; ++level) {
    const double error = exact - volume_properties(sphere_mesh(level)).volume;
    CHECK(error > 0.0);
    CHECK_NEAR(before / error, 4.0, 0.1);  // second order in the side, which halves
    before = error;
  }
}

TEST_CASE("Flat: collinear and coincident corners have no area, thin slivers have one") {
  CHECK(is_flat({0, 0, 0}, {1, 1, 1}, {3, 3, 3}));
  CHECK(is_flat({1, 2, 3}, {1, 2, 3}, {0, 0, 0}));
  CHECK(is_flat({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
  CHECK_FALSE(is_flat({0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}));
  CHECK_FALSE(is_flat({0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}));
}

TEST_CASE("Topology: closed solids have no fault and one piece") {
  for (const auto& mesh : {box_mesh({0, 0, 0}, {1, 1, 1}), tetrahedron_mesh(), sphere_mesh(3)}) {
    const MeshTopology topology = mesh_topology(mesh);
    CHECK(topology.watertight());
    CHECK(topology.bounds_volume());
    CHECK(topology.inconsistent_edges == 0);
    CHECK(topology.pieces == 1);
  }
}

TEST_CASE("Topology: a missing triangle opens three edges") {
  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  CHECK(mesh_topology(mesh).open_edges == 3);
  CHECK_FALSE(mesh_topology(mesh).watertight());
}

TEST_CASE("Topology: one reversed triangle disagrees with its three neighbours and encloses no volume") {
  TriangleMesh mesh = tetrahedron_mesh();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  CHECK(mesh_topology(mesh).inconsistent_edges == 3);
  CHECK(mesh_topology(mesh).watertight());
  CHECK_FALSE(mesh_topology(mesh).bounds_volume());
}

TEST_CASE("Topology: three triangles on one edge make it non-manifold") {
  const TriangleMesh fan{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}},
                         {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  const MeshTopology topology = mesh_topology(fan);
  CHECK(topology.non_manifold_edges == 1);
  CHECK(topology.open_edges == 6);
  CHECK(topology.pieces == 1);
}

TEST_CASE("Topology: solids that share a corner but no edge are two pieces") {
  TriangleMesh mesh =
      joined(tetrahedron_mesh(), moved(tetrahedron_mesh(), Eigen::Matrix3d::Identity(), {5, 0, 0}));
  CHECK(mesh_topology(mesh).pieces == 2);
  for (auto& triangle : mesh.triangles) {
    for (auto& v : triangle) v = v == 4 ? 0 : v;  // join one corner of each
  }
  CHECK(mesh_topology(mesh).pieces == 2);
  CHECK(mesh_topology(mesh).watertight());
}

TEST_CASE("Topology: solids that share an edge bound a volume although the edge has four triangles") {
  TriangleMesh mesh = joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1}));
  for (auto& triangle : mesh.triangles) {
    for (auto& v : triangle) v = v == 8 ? 3 : v == 12 ? 7 : v;  // the common edge from (1, 1, 0) to (1, 1, 1)
  }
  const MeshTopology topology = mesh_topology(mesh);
  CHECK(topology.non_manifold_edges == 1);
  CHECK_FALSE(topology.watertight());
  CHECK(topology.bounds_volume());
  CHECK_NEAR(volume_properties(mesh).volume, 2.0, 8 * kEps);
}

TEST_SUITE_END();
