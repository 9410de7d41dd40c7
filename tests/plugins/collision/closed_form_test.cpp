#include <thread>

#include "plugins/collision/backends.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/collision");

TEST_CASE("Backends: the reference is there") {
  const auto names = backend_names();
  CHECK(std::find(names.begin(), names.end(), "brute") != names.end());
}

TEST_CASE("Cast: a box is met where its sides are, from outside and from inside") {
  const TriangleMesh box = box_mesh({-1, -2, -3}, {1, 2, 3});
  Random random(41);
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto prepared = scene(name, box);
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d inside = random_vector(random).cwiseProduct(Eigen::Vector3d(0.9, 1.9, 2.9));
      const Eigen::Vector3d d = random_unit(random);
      // Slabs: out through the nearest of the three sides ahead.
      const Eigen::Vector3d ahead =
          ((d.array() > 0).select(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(-1, -2, -3)) - inside)
              .cwiseQuotient(d);
      const double out = ahead.minCoeff();
      const auto hits =
          cast(*prepared, {{inside, d}, {inside + (out + 5) * d, -d}, {inside + (out + 1e-6) * d, d}});
      CHECK_NEAR(hits[0].distance, out, 1e-12);
      CHECK_NEAR(hits[1].distance, 5.0, 1e-12);
      CHECK_FALSE(hits[2].met());
      CHECK(std::isinf(hits[2].distance));
      // Along the first touched axis, to the side that it runs at.
      int axis;
      ahead.minCoeff(&axis);
      const Eigen::Vector3d n = box.area_vector(static_cast<std::size_t>(hits[0].triangle)).normalized();
      CHECK(n[axis] * d[axis] > 0.0);
    }
  }
}

TEST_CASE("Cast: along the axes, with zeros of either sign, through faces, edges and corners of a box") {
  const TriangleMesh box = box_mesh({-1, -2, -3}, {1, 2, 3});
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto prepared = scene(name, box);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double zero : {0.0, -0.0}) {
        for (const double sign : {1.0, -1.0}) {
          Eigen::Vector3d direction = Eigen::Vector3d::Constant(zero);
          direction[axis] = sign;
          for (int corner = 0; corner < 27; ++corner) {
            Eigen::Vector3d origin(corner % 3 - 1, 2 * (corner / 3 % 3 - 1), 3 * (corner / 9 - 1));
            origin[axis] = -10.0 * sign;
            const auto hits = cast(*prepared, {{origin, direction}});
            CHECK(hits[0].distance == 10.0 - (axis + 1));
          }
        }
      }
    }
  }
}

TEST_CASE("Cast: no ray from inside a closed mesh slips through, not even at corners and edge middles") {
  Random random(42);
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    for (int i = 0; i < 6; ++i) {
      const TriangleMesh mesh =
          moved(i % 2 ? sphere_mesh(3) : box_mesh({-1, -1, -1}, {1, 1, 1}),
                i < 2 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_rotation(random),
                i < 4 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(30 * random_vector(random)));
      const Eigen::Vector3d inside = bounding_box(mesh).centre() + 0.2 * random_vector(random);
      std::vector<Ray> rays;
      const auto aim = [&](const Eigen::Vector3d& p) { rays.push_back({inside, (p - inside).normalized()}); };
      for (const auto& v : mesh.vertices) aim(v);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) aim((mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3)) / 2);
      }
      int missed = 0;
      for (const RayHit& hit : cast(*scene(name, mesh), rays)) missed += !hit.met();
      CHECK(missed == 0);
    }
  }
}

TEST_CASE("Cast: triangles without area are never met") {
  TriangleMesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  mesh.vertices.emplace_back(0, 0, 2);
  mesh.vertices.emplace_back(0, 1, 2);
  mesh.vertices.emplace_back(0, 3, 2);
  mesh.triangles.insert(mesh.triangles.begin(), {8, 9, 10});  // a needle in front of the box
  mesh.triangles.insert(mesh.triangles.begin(), {8, 8, 9});
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto hits = cast(*scene(name, mesh), {{{0, 0.5, 5}, {0, 0, -1}}, {{0.0, 2, 5}, {0, 0, -1}}});
    CHECK(hits[0].distance == 4.0);
    CHECK(hits[0].triangle >= 2);
    CHECK_FALSE(hits[1].met());
    CHECK_NEAR(distances(*scene(name, mesh), {sphere_at({0, 2, 2}, 0.1)})[0], std::hypot(1, 1) - 0.1, 1e-8);
  }
}

TEST_CASE("Cast: on a shared edge or corner the lowest triangle answers") {
  const TriangleMesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    // The middle of a face, on its diagonal; then a corner, of up to six triangles.
    const auto hits = cast(*scene(name, box),
                           {{{0, 0, 5}, {0, 0, -1}}, {{5, 5, 5}, -Eigen::Vector3d(1, 1, 1).normalized()}});
    CHECK(hits[0].triangle == 2);
    CHECK(hits[1].triangle == 3);
  }
}

TEST_CASE("Distance: a sphere to a box in closed form; inside counts from the surface") {
  const TriangleMesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto found = distances(
        *scene(name, box), {sphere_at({4, 0, 0}, 1), sphere_at({4, 5, 0}, 1), sphere_at({0, 0, 0}, 0.25),
                            sphere_at({1, 0, 0}, 0.1), sphere_at({1.5, 0, 0}, 0.5)});
    CHECK_NEAR(found[0], 2.0, 1e-8);
    CHECK_NEAR(found[1], 4.0, 1e-8);
    CHECK_NEAR(found[2], 0.75, 1e-8);
    CHECK(found[3] == 0.0);
    CHECK_NEAR(found[4], 0.0, 1e-8);
  }
}

TEST_CASE("Scenes: nothing is met of an empty mesh, and everything is infinitely far") {
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto prepared = scene(name, {});
    CHECK_FALSE(cast(*prepared, {{{0, 0, 0}, {1, 0, 0}}})[0].met());
    CHECK(std::isinf(distances(*prepared, {sphere_at({0, 0, 0}, 1)})[0]));
  }
}

TEST_CASE("Scenes: they keep what they need of the mesh") {
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    auto mesh = std::make_unique<TriangleMesh>(box_mesh({-1, -1, -1}, {1, 1, 1}));
    const auto prepared = scene(name, *mesh);
    for (auto& v : mesh->vertices) v.setConstant(NAN);
    mesh.reset();
    CHECK(cast(*prepared, {{{-3, 0, 0}, {1, 0, 0}}})[0].distance == 2.0);
    CHECK_NEAR(distances(*prepared, {sphere_at({3, 0, 0}, 1)})[0], 1.0, 1e-8);
  }
}

TEST_CASE("Refusals: bad rays, solids and meshes are refused by name") {
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto prepared = scene(name, box_mesh({0, 0, 0}, {1, 1, 1}));
    CHECK_THROWS_SAYING(cast(*prepared, {{{0, 0, 0}, {1, 1, 0}}}), InputError,
                        "ray 0 has a direction that is not of unit length");
    CHECK_THROWS_SAYING(cast(*prepared, {{{0, 0, 0}, {NAN, 0, 0}}}), InputError, "ray 0 has a direction");
    CHECK_THROWS_SAYING(prepared->cast(std::vector<Ray>(2), {}), InputError,
                        "there are 2 rays but room for 0 hits");
    CHECK_THROWS_SAYING(distances(*prepared, {sphere_at({0, 0, 0}, -1)}), InputError, "solid 0 has a size");
    CHECK_THROWS_SAYING(scene(name, {{{0, 0, 0}}, {{0, 1, 2}}}), InputError,
                        "triangle 0 has no finite corner 1");
    std::vector<PosedSolid> two(2, sphere_at({0, 0, 0}, 1));
    std::vector<double> one(1);
    CHECK_THROWS_SAYING(backend(name)->distance(two, two, one), InputError,
                        "there are 2 solids but room for 1");
  }
}

TEST_CASE("Threads: the same scene answers several at once as it answers one") {
  Random random(43);
  const TriangleMesh mesh = sphere_mesh(2);
  const auto rays = rays_at(random, bounding_box(mesh), 400);
  std::vector<PosedSolid> solids;
  for (int i = 0; i < 20; ++i) solids.push_back(random_solid(random, 0.2, 2 * random_vector(random)));
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto alone = scene(name, mesh), shared = scene(name, mesh);
    const auto hits = cast(*alone, rays);
    const auto measured = distances(*alone, solids);
    std::vector<int> differing(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < differing.size(); ++i) {
      threads.emplace_back([&, i] {
        const auto my_measured = distances(*shared, solids);
        const auto my_hits = cast(*shared, rays);
        for (std::size_t k = 0; k < rays.size(); ++k)
          differing[i] += my_hits[k].triangle != hits[k].triangle || my_hits[k].distance != hits[k].distance;
        for (std::size_t k = 0; k < solids.size(); ++k) differing[i] += my_measured[k] != measured[k];
      });
    }
    for (auto& thread : threads) thread.join();
    for (const int count : differing) CHECK(count == 0);
  }
}

TEST_SUITE_END();
