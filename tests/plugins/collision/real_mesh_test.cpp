// The same questions to every backend on every object that there is, and on bodies of unheard-of sizes.
#include <cfloat>
#include <filesystem>
#include <set>
#include <thread>

#include "plugins/collision/backends.h"
#include "preshape/base/error.h"
#include "preshape/io/object_reader.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/collision");

namespace {

struct Named {
  std::string name;
  TriangleMesh mesh;
};

/// Every object below a folder that can be read; the refusals of files are tested with the reader.
std::vector<Named> objects_below(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;  // in an order that does not depend on the file system
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  std::vector<Named> objects;
  for (const auto& file : files) {
    try {
      objects.push_back({file.filename(), place_object(read_object(file), {}, 0.04).mesh_O});
    } catch (const Error&) {
    }
  }
  return objects;
}

/// As a hand asks: groups of four parallel rays towards each other from both sides, at steps of the approach,
/// in planes along the axes, so that many run through edges of what is modelled along the axes.
std::vector<Ray> grasp_rays(const Box& box, int steps) {
  std::vector<Ray> rays;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (int step = 0; step <= steps; ++step) {
        for (int finger = 0; finger < 4; ++finger) {
          Ray ray{box.centre(), Eigen::Vector3d::Zero()};
          ray.origin[axis] -= side * box.extents().norm();
          ray.origin[(axis + 1) % 3] += box.extents()[(axis + 1) % 3] * (finger / 4.0 - 0.375);
          ray.origin[(axis + 2) % 3] += box.extents()[(axis + 2) % 3] * (step / double(steps) - 0.5);
          ray.direction[axis] = side;
          rays.push_back(ray);
        }
      }
    }
  }
  return rays;
}

/// Exactly through corners and middles of sides, where several triangles are met at once.
std::vector<Ray> rays_at_the_net(Random& random, const TriangleMesh& mesh, int count) {
  std::vector<Ray> rays;
  const double away = bounding_box(mesh).extents().norm();
  for (int i = 0; i < count && !mesh.triangles.empty(); ++i) {
    const auto t = random.below(mesh.triangles.size());
    const Eigen::Vector3d &a = mesh.corner(t, i % 3), &b = mesh.corner(t, (i + 1) % 3);
    const Eigen::Vector3d direction =
        i % 4 < 2 ? random_unit(random) : Eigen::Vector3d(Eigen::Vector3d::Unit(i % 3));
    rays.push_back({(i % 2 ? a : Eigen::Vector3d((a + b) / 2)) - away * direction, direction});
  }
  return rays;
}

int differing(const std::vector<RayHit>& a, const std::vector<RayHit>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += a[i].triangle != b[i].triangle || a[i].distance != b[i].distance;
  return count;
}

/// Brute force looks at this many triangles a mesh, and at no fewer than a few rays.
int affordable(const TriangleMesh& mesh, double triangles) {
  return static_cast<int>(std::clamp(triangles / (1.0 + double(mesh.triangles.size())), 10.0, 300.0));
}

void check_same_hits_of_all(const Named& object) {
  Random random(61);
  const Box box = bounding_box(object.mesh);
  const int few = affordable(object.mesh, 1e6);
  std::vector<Ray> rays = rays_at(random, box, few);
  for (const auto& more : {rays_at_the_net(random, object.mesh, few), grasp_rays(box, std::max(1, few / 24))})
    rays.insert(rays.end(), more.begin(), more.end());
  const auto expected = cast(*scene("brute", object.mesh), rays);
  std::vector<Ray> many = rays_at(random, box, 1000);
  for (const auto& more : {rays_at_the_net(random, object.mesh, 1000), grasp_rays(box, 40)})
    many.insert(many.end(), more.begin(), more.end());
  std::vector<RayHit> first;
  for (const auto& name : backend_names()) {
    if (name == "brute") continue;
    INFO("object: ", object.name, ", backend: ", name);
    const auto prepared = scene(name, object.mesh);
    CHECK(differing(cast(*prepared, rays), expected) == 0);
    const auto found = cast(*prepared, many);
    if (first.empty()) first = found;
    CHECK(differing(found, first) == 0);
  }
}

void check_same_distances_of_all(const Named& object) {
  Random random(62);
  const Box box = bounding_box(object.mesh);
  std::vector<PosedSolid> solids;
  for (int i = 0; i < std::min(12, affordable(object.mesh, 1e5)); ++i)
    solids.push_back(random_solid(random, 0.1 * box.extents().norm(),
                                  box.centre() + random_vector(random).cwiseProduct(box.extents())));
  const auto expected = distances(*scene("brute", object.mesh), solids);
  for (const auto& name : backend_names()) {
    if (name == "brute") continue;
    INFO("object: ", object.name, ", backend: ", name);
    const auto found = distances(*scene(name, object.mesh), solids);
    // Those that end with the core's closed forms agree to the last bit; FCL's iterations stop at 1e-9 m.
    const double tolerance = name == "fcl" ? 1e-7 * (1 + box.extents().norm()) : 0.0;
    for (std::size_t i = 0; i < solids.size(); ++i)
      CHECK((found[i] == expected[i] || std::abs(found[i] - expected[i]) <= tolerance));
  }
}

void check_all_objects_below(const std::filesystem::path& folder, std::size_t at_least) {
  const auto objects = objects_below(folder);
  CHECK(objects.size() >= at_least);
  for (const Named& object : objects) {
    check_same_hits_of_all(object);
    check_same_distances_of_all(object);
  }
}

bool keeps_subnormal_numbers() {
  volatile double least = DBL_MIN;
  volatile float least_float = FLT_MIN;
  return least / 2 > 0.0 && least_float / 2 > 0.0f;
}

}  // namespace

TEST_CASE("Backends: all answer alike on every shipped object, also through edges and corners") {
  check_all_objects_below(source_file("objects"), 12);
}

TEST_CASE("Backends: all answer alike on every object of the test data, also through edges and corners") {
  const auto folder = test_data("objects");
  if (folder.empty()) return;
  check_all_objects_below(folder, 30);
}

TEST_CASE("Backends: rays that graze triangles, down to rounding, meet the same of all") {
  Random random(65);
  for (int i = 0; i < 60; ++i) {
    // A quilt of squares, most of them flat and in one plane, of any size and attitude.
    TriangleMesh mesh;
    for (int k = 0; k < 169; ++k)
      mesh.vertices.emplace_back(k / 13, k % 13, random.below(3) ? 0.0 : random.uniform());
    for (int k = 0; k < 155; ++k) {
      if (k % 13 == 12) continue;
      mesh.triangles.emplace_back(k, k + 1, k + 14);
      mesh.triangles.emplace_back(k, k + 14, k + 13);
    }
    mesh = scaled(moved(mesh, random_rotation(random), random_vector(random)),
                  Eigen::Vector3d::Constant(std::pow(10.0, random.uniform(-6, 6))));
    std::vector<Ray> rays;
    for (int k = 0; k < 300; ++k) {
      const auto t = random.below(mesh.triangles.size());
      const Eigen::Vector3d side = mesh.corner(t, 1) - mesh.corner(t, 0),
                            normal = mesh.area_vector(t).normalized();
      const Eigen::Vector3d along =
          (side.normalized() + std::pow(10.0, -random.uniform(1, 17)) * normal).normalized();
      const Eigen::Vector3d p = mesh.corner(t, 0) + random.uniform() * side +
                                random.uniform() * (mesh.corner(t, 2) - mesh.corner(t, 0));
      rays.push_back({p - random.uniform(0, 20) * side.norm() * along, along});
    }
    const auto expected = cast(*scene("brute", mesh), rays);
    for (const auto& name : backend_names()) {
      INFO("backend: ", name, ", mesh ", i);
      CHECK(differing(cast(*scene(name, mesh), rays), expected) == 0);
    }
  }
}

TEST_CASE("Backends: neither a body's size nor its place in space changes what is met") {
  Random random(63);
  const TriangleMesh round = sphere_mesh(2);
  const auto unit_rays = rays_at(random, bounding_box(round), 200);
  for (const double size : {1e-60, 1e-30, 1e-12, 1e-3, 1e6, 1e30, 1e60}) {
    for (const double away : {0.0, 1e3, 1e9}) {
      const Eigen::Vector3d p = size * away * Eigen::Vector3d(1, -1, 0.5);
      const TriangleMesh mesh =
          moved(scaled(round, Eigen::Vector3d::Constant(size)), Eigen::Matrix3d::Identity(), p);
      std::vector<Ray> rays;
      for (const Ray& ray : unit_rays) rays.push_back({p + size * ray.origin, ray.direction});
      const auto expected = cast(*scene("brute", mesh), rays);
      const auto met =
          std::count_if(expected.begin(), expected.end(), [](const RayHit& hit) { return hit.met(); });
      CHECK(met > 50);
      for (const auto& name : backend_names()) {
        INFO("backend: ", name, ", size ", size, ", away ", away);
        CHECK(differing(cast(*scene(name, mesh), rays), expected) == 0);
        if (name == "fcl") continue;  // whose iterations stop at lengths in metres
        for (int i = 0; i < 6; ++i) {
          const PosedSolid solid = random_solid(random, 0.3 * size, p + 2 * size * random_vector(random));
          CHECK(distances(*scene(name, mesh), {solid}) == distances(*scene("brute", mesh), {solid}));
        }
      }
    }
  }
}

TEST_CASE("Backends: small bodies are met beside huge ones, and by rays from very far") {
  Random random(64);
  TriangleMesh mesh = sphere_mesh(2);
  const auto n = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{-1e7, -1e7, -5}, {1e7, -1e7, -5}, {0, 2e7, -5}});
  mesh.triangles.emplace_back(n, n + 1, n + 2);
  std::vector<Ray> rays = rays_at(random, bounding_box(sphere_mesh(0)), 200);
  for (const double away : {1e3, 1e5, 1e7, 1e9, 1e12}) {
    for (int i = 0; i < 40; ++i)
      rays.push_back({0.4 * random_vector(random) + Eigen::Vector3d(0, 0, away), {0, 0, -1}});
  }
  const auto expected = cast(*scene("brute", mesh), rays);
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    CHECK(differing(cast(*scene(name, mesh), rays), expected) == 0);
  }
}

TEST_CASE("Backends: scenes that are built and asked by many threads at once answer as one alone does") {
  Random random(66);
  const TriangleMesh mesh = sphere_mesh(3);
  const auto rays = rays_at(random, bounding_box(mesh), 100);
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto shared = backend(name);
    const auto expected = cast(*scene("brute", mesh), rays);
    std::vector<int> wrong(8, 0);
    std::vector<std::thread> threads;
    for (int& count : wrong)
      threads.emplace_back([&] {
        for (int i = 0; i < 3; ++i) count += differing(cast(*build_scene(shared, mesh), rays), expected);
      });
    for (auto& thread : threads) thread.join();
    CHECK(wrong == std::vector<int>(8, 0));
  }
}

TEST_CASE("Backends: none leaves subnormal numbers flushed to zero in the caller's thread") {
  REQUIRE(keeps_subnormal_numbers());
  const TriangleMesh mesh = sphere_mesh(3);
  for (const auto& name : backend_names()) {
    INFO("backend: ", name);
    const auto prepared = scene(name, mesh);
    CHECK(keeps_subnormal_numbers());
    cast(*prepared, {{{-3, 0, 0}, {1, 0, 0}}});
    distances(*prepared, {sphere_at({3, 0, 0}, 1)});
    CHECK(keeps_subnormal_numbers());
  }
}

TEST_SUITE_END();
