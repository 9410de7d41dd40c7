// What meshes a backend takes and what does not matter of them: B12 to B14, B17, B20, B21.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "../arena.h"
#include "preshape/base/error.h"
#include "queries.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;

Ray moved(const Ray& ray, const Pose& X) {
  return {X * ray.origin, (X.R * ray.direction).normalized()};
}

Ray random_ray(const Body& body, Random& random) {
  const Vector direction = random_unit(random);
  return {body.centre() + 0.3 * body.extent() * random.uniform() * random_unit(random) -
              1.5 * body.extent() * direction,
          direction};
}

PosedSolid random_solid(const Body& body, Random& random) {
  double numbers[kSolidNumbers] = {static_cast<double>(random.below(3))};
  for (std::size_t i = 1; i < kSolidNumbers; ++i)
    numbers[i] = i < 4 ? random.uniform(0.02, 0.2) : random.uniform(-1, 1);
  return solid_at(numbers, body.centre(), body.extent());
}

/// Whether two distances are about the same; B01 has the last digits. Both may be infinite.
bool same(double a, double b, double size) {
  return a == b || std::abs(a - b) <= 2 * distance_slack(size);
}

double seconds_of(const std::function<void()>& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace

void b12_moves_with_the_body(Context& context) {
  Scenes scenes(context);
  Random random = context.random("poses");
  for (const char* name : {"sphere", "box", "torus"}) {
    const Body& body = conformance::body(name);
    const Pose X{random_rotation(random), Vector(0.3, -2.0, 1.5)};
    const CollisionScene& before = scenes.of(body);
    const TriangleMesh elsewhere = conformance::moved(body.mesh, X);
    const auto after = scenes.build(elsewhere);
    for (int i = 0; i < context.cases(200); ++i) {
      const Ray ray = random_ray(body, random);
      const RayHit a = cast_one(before, ray), b = cast_one(*after, moved(ray, X));
      context.require(a.met() == b.met() && same(a.distance, b.distance, body.extent()),
                      "a ray meets {} at {}, moved with it at {}", name, a.distance, b.distance);
    }
    for (int i = 0; i < context.cases(10); ++i) {
      const PosedSolid solid = random_solid(body, random);
      const double a = distance_one(before, solid), b = distance_one(*after, {solid.solid, X * solid.X_OS});
      context.require(same(a, b, body.extent()), "a solid is {} m from {}, moved with it {}", a, name, b);
    }
  }
}

void b13_order_and_winding(Context& context) {
  Scenes scenes(context);
  Random random = context.random("orders");
  for (const char* name : {"sphere", "torus", "soup"}) {
    const Body& body = conformance::body(name);
    TriangleMesh turned{body.mesh.vertices, {}};
    std::vector<std::size_t> order(body.mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const std::size_t t : order) turned.triangles.push_back(body.mesh.triangles[t].reverse());
    const auto other = scenes.build(turned);
    for (int i = 0; i < context.cases(300); ++i) {
      const Ray ray = random_ray(body, random);
      const RayHit a = cast_one(scenes.of(body), ray), b = cast_one(*other, ray);
      const auto named =
          b.met() ? static_cast<std::int32_t>(order[static_cast<std::size_t>(b.triangle)]) : -1;
      context.require(
          a.triangle == named && same(a.distance, b.distance, body.extent()),
          "a ray meets triangle {} of {} at {}, with the triangles in another order and turned over {} at {}",
          a.triangle, name, a.distance, named, b.distance);
    }
    for (int i = 0; i < context.cases(10); ++i) {
      const PosedSolid solid = random_solid(body, random);
      const double a = distance_one(scenes.of(body), solid), b = distance_one(*other, solid);
      context.require(same(a, b, body.extent()),
                      "a solid is {} m from {}, with the triangles in another order and turned over {}", a,
                      name, b);
    }
  }
}

void b14_refuses_broken_meshes(Context& context) {
  const auto backend = context.create<CollisionBackend>();
  const auto refuses = [&](const TriangleMesh& mesh, const std::string& what, std::string_view number) {
    std::string message;
    const std::string instead = not_refused([&] { backend->build(mesh); }, &message);
    context.require(instead.empty(), "a mesh {}: {}", what, instead);
    context.require(message.find(number) != std::string::npos,
                    "a mesh {}: the message does not name triangle {}: \"{}\"", what, number, message);
  };
  for (const int index : {12, -1, 1000000000, std::numeric_limits<int>::min()}) {
    TriangleMesh mesh = icosphere(0);
    mesh.triangles[17][1] = index;
    refuses(mesh, fmt::format("of 12 vertices whose triangle 17 has the corner {}", index), "17");
  }
  for (const double number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = icosphere(0);
    mesh.vertices.push_back({number, 0, 0});
    mesh.triangles[17][2] = 12;
    refuses(mesh, fmt::format("whose triangle 17 has a corner at {}", number), "17");
  }
}

void b17_large_meshes(Context& context) {
  Scenes scenes(context);
  const Body large{"torus of 100000 triangles", torus(500, 100), true, {1.02, 0.03, 0.01}};
  std::shared_ptr<const CollisionScene> scene;
  const double building = seconds_of([&] { scene = scenes.build(large.mesh); });
  Random random = context.random("rays");
  std::vector<Ray> rays;
  for (int i = 0; i < 300; ++i) rays.push_back(random_ray(large, random));
  std::vector<RayHit> hits(rays.size());
  const double casting = seconds_of([&] { scene->cast(rays, hits); });
  const double looking = seconds_of([&] {
    for (std::size_t i = 0; i < 30; ++i) {
      const std::string wrong = wrong_hit(large, rays[i], hits[i]);
      context.require(wrong.empty(), "{} ({})", wrong, large.name);
    }
  });
  if (casting / 300 > looking / 30) {
    context.warn(
        fmt::format("a ray takes {:.3g} s on {}, more than looking at each; it took {:.3g} s to build",
                    casting / 300, large.name, building));
  }
}

void b20_empty_mesh(Context& context) {
  Scenes scenes(context);
  TriangleMesh lonely;
  lonely.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const TriangleMesh& mesh : {TriangleMesh{}, lonely}) {
    const auto scene = scenes.build(mesh);
    const RayHit hit = cast_one(*scene, {{0.2, 0.2, -1}, {0, 0, 1}});
    context.require(!hit.met() && hit.distance == std::numeric_limits<double>::infinity(),
                    "a ray meets triangle {} at {} of a mesh without triangles", hit.triangle, hit.distance);
    const double distance = distance_one(*scene, {{Solid::Kind::kSphere, 0.1, 0, Vector::Zero()}, {}});
    context.require(distance == std::numeric_limits<double>::infinity(),
                    "a solid is {} m from a mesh without triangles", distance);
  }
}

void b21_keeps_its_own_mesh(Context& context) {
  const auto backend = context.create<CollisionBackend>();
  const Body& body = conformance::body("sphere");
  Arena arena;
  TriangleMeshView view;
  view.vertices = arena.keep(std::span<const Vector>(body.mesh.vertices));
  view.triangles = arena.keep(std::span<const Triangle>(body.mesh.triangles));
  arena.seal();
  const auto scene = backend->build(view), other = backend->build(body.mesh);
  arena.release();
  Random random = context.random("rays");
  for (int i = 0; i < 100; ++i) {
    const Ray ray = random_ray(body, random);
    const RayHit a = cast_one(*scene, ray), b = cast_one(*other, ray);
    context.require(a.triangle == b.triangle && a.distance == b.distance,
                    "with the mesh gone a ray meets triangle {} at {}, else {} at {}", a.triangle, a.distance,
                    b.triangle, b.distance);
    const PosedSolid solid = random_solid(body, random);
    context.require(i > 10 || distance_one(*scene, solid) == distance_one(*other, solid),
                    "with the mesh gone a solid's distance differs");
  }
}

}  // namespace preshape::conformance
