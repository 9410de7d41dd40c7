// Every backend against the reference, which looks at every triangle.
#include "plugins/collision/backends.h"
#include "preshape/io/object_reader.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/collision");

namespace {

std::vector<std::string> others() {
  auto names = backend_names();
  std::erase(names, "brute");
  return names;
}

/// Same triangles at the same distances.
void check_same_hits(const std::string& name, const TriangleMesh& mesh, const std::vector<Ray>& rays) {
  const auto expected = cast(*scene("brute", mesh), rays), found = cast(*scene(name, mesh), rays);
  int met = 0, wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool same = found[i].triangle == expected[i].triangle && found[i].distance == expected[i].distance;
    wrong += !same;
    met += expected[i].met();
  }
  INFO("backend: ", name, ", triangles: ", mesh.triangles.size(), ", met: ", met);
  CHECK(wrong == 0);
  CHECK(met > static_cast<int>(rays.size()) / 20);
}

/// FCL's iterations stop at 1e-9 m; the tenfold, and that share of the size.
void check_same_distances(const std::string& name, const TriangleMesh& mesh,
                          const std::vector<PosedSolid>& solids) {
  const auto expected = distances(*scene("brute", mesh), solids),
             found = distances(*scene(name, mesh), solids);
  const double tolerance = 1e-8 * (1 + bounding_box(mesh).extents().norm());
  int touching = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    INFO("backend: ", name, ", solid ", i, " of kind ", static_cast<int>(solids[i].solid.kind));
    CHECK_NEAR(found[i], expected[i], tolerance);
    touching += expected[i] == 0.0;
  }
  CHECK(touching < static_cast<int>(solids.size()));
}

std::vector<PosedSolid> solids_at(Random& random, const Box& box, int count) {
  std::vector<PosedSolid> solids;
  const double size = 0.1 * box.extents().norm();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = box.centre() + random_vector(random).cwiseProduct(box.extents());
    solids.push_back(random_solid(random, size, p));
  }
  return solids;
}

/// Triangles as long as the body and a millionth as wide.
TriangleMesh sliver_mesh(Random& random, int count) {
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Eigen::Vector3d a = random_vector(random), along = random_vector(random);
    mesh.vertices.insert(mesh.vertices.end(),
                         {a, a + along, a + random.uniform() * along + 1e-6 * random_vector(random)});
    mesh.triangles.emplace_back(3 * t, 3 * t + 1, 3 * t + 2);
  }
  return mesh;
}

}  // namespace

TEST_CASE("Backends: all meet what the reference meets on spheres, boxes, soups and slivers") {
  Random random(51);
  for (const auto& name : others()) {
    for (int i = 0; i < 4; ++i) {
      const Eigen::Matrix3d R = random_rotation(random);
      const Eigen::Vector3d p = random_vector(random);
      for (const TriangleMesh& mesh :
           {moved(sphere_mesh(3), R, p), moved(box_mesh({-1, -2, -3}, {1, 2, 3}), R, p),
            scaled(moved(sphere_mesh(2), R, p), {1, 1, 1e-3}), soup_mesh(random, 400, 0.3)}) {
        check_same_hits(name, mesh, rays_at(random, bounding_box(mesh), 500));
      }
    }
    // Slivers are hardly ever met by chance: aim at them.
    const TriangleMesh slivers = sliver_mesh(random, 300);
    std::vector<Ray> rays;
    for (std::size_t t = 0; t < slivers.triangles.size(); ++t) {
      const Eigen::Vector3d d = random_unit(random);
      rays.push_back({(slivers.corner(t, 0) + slivers.corner(t, 1) + slivers.corner(t, 2)) / 3 - 3 * d, d});
    }
    check_same_hits(name, slivers, rays);
  }
}

TEST_CASE("Backends: all meet what the reference meets through corners and edges, with the lowest triangle") {
  Random random(52);
  for (const auto& name : others()) {
    for (const TriangleMesh& mesh :
         {sphere_mesh(2), moved(sphere_mesh(2), random_rotation(random), random_vector(random)),
          box_mesh({-1, -1, -1}, {1, 1, 1}), tetrahedron_mesh()}) {
      std::vector<Ray> rays;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d d = random_unit(random);
          rays.push_back({mesh.corner(t, k) - 3 * d, d});
          rays.push_back({(mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3)) / 2 - 3 * d, d});
        }
      }
      check_same_hits(name, mesh, rays);
    }
  }
}

TEST_CASE(
    "Backends: axis-parallel rays, the analysis's own, meet the same on a body with axis-parallel faces") {
  const TriangleMesh mesh =
      joined(box_mesh({-1, -1, -1}, {1, 1, 1}), box_mesh({-0.5, 1, -0.5}, {0.5, 2, 0.5}));
  std::vector<Ray> rays;
  for (double u = -1.25; u <= 1.25; u += 0.25) {
    for (double v = -1.25; v <= 2.25; v += 0.25) {
      rays.push_back({{u, v, 5}, {0, 0, -1}});
      rays.push_back({{u, v, 5}, {-0.0, -0.0, -1}});
      rays.push_back({{5, v, u}, {-1, 0.0, -0.0}});
      rays.push_back({{u, 5, v}, {0, -1, 0}});
    }
  }
  for (const auto& name : others()) check_same_hits(name, mesh, rays);
}

TEST_CASE("Backends: distances of solids are the reference's on spheres, boxes, slivers and soups") {
  Random random(53);
  for (const auto& name : others()) {
    for (const TriangleMesh& mesh : {sphere_mesh(2), box_mesh({-1, -2, -3}, {1, 2, 3}),
                                     sliver_mesh(random, 60), soup_mesh(random, 60, 0.3)}) {
      check_same_distances(name, mesh, solids_at(random, bounding_box(mesh), 90));
    }
  }
}

TEST_CASE("Backends: distances of pairs of solids are the reference's") {
  Random random(54);
  std::vector<PosedSolid> a, b;
  for (int i = 0; i < 600; ++i) {
    a.push_back(random_solid(random, 0.03, 0.05 * random_vector(random)));
    b.push_back(random_solid(random, 0.03, 0.05 * random_vector(random)));
  }
  std::vector<double> expected(a.size()), found(a.size());
  backend("brute")->distance(a, b, expected);
  for (const auto& name : others()) {
    backend(name)->distance(a, b, found);
    int touching = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      INFO("backend: ", name, ", kinds ", static_cast<int>(a[i].solid.kind), " ",
           static_cast<int>(b[i].solid.kind));
      CHECK_NEAR(found[i], expected[i],
                 1e-7);  // FCL stops its iterations at 1e-9 but may be off by tens of that
      touching += expected[i] == 0.0;
    }
    CHECK(touching > 50);
    CHECK(touching < 550);
  }
}

TEST_CASE("Backends: moving the body, the rays and the solids together changes no answer") {
  Random random(55);
  const TriangleMesh mesh = scaled(sphere_mesh(2), {0.1, 0.05, 0.02});
  const auto rays = rays_at(random, bounding_box(mesh), 300);
  const auto solids = solids_at(random, bounding_box(mesh), 40);
  const Pose X{random_rotation(random), random_vector(random)};
  std::vector<Ray> moved_rays;
  for (const Ray& ray : rays) moved_rays.push_back({X * ray.origin, X.R * ray.direction});
  std::vector<PosedSolid> moved_solids;
  for (const PosedSolid& solid : solids) moved_solids.push_back({solid.solid, X * solid.X_OS});
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto before = scene(name, mesh), after = scene(name, moved(mesh, X.R, X.p));
    const auto hits = cast(*before, rays), moved_hits = cast(*after, moved_rays);
    int met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      // Rounding of the place (about 2) seen along a slanted facet; rays of grazing incidence may change
      // their mind.
      if (!hits[i].met() || !moved_hits[i].met()) continue;
      CHECK_NEAR(moved_hits[i].distance, hits[i].distance, 1e-11);
      ++met;
    }
    CHECK(met > 100);
    const auto measured = distances(*before, solids), moved_measured = distances(*after, moved_solids);
    for (std::size_t i = 0; i < solids.size(); ++i) CHECK_NEAR(moved_measured[i], measured[i], 2e-8);
  }
}

TEST_CASE("Backends: ten thousand rays and some solids on scans are the reference's") {
  Random random(56);
  for (const char* object : {"mug", "scissors"}) {
    const auto file = test_data(std::string("objects/household/ycb_") + object + ".obj");
    if (file.empty()) return;
    const TriangleMesh mesh = place_object(read_object(file), {}, 0.04).mesh_O;
    for (const auto& name : others()) {
      check_same_hits(name, mesh, rays_at(random, bounding_box(mesh), 5000));
      check_same_distances(name, mesh, solids_at(random, bounding_box(mesh), 30));
    }
  }
}

TEST_SUITE_END();
