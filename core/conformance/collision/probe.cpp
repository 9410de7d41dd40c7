#include "../probe.h"

#include <cmath>

#include "queries.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;

const CollisionBackend& backend_at(void* component) {
  return *static_cast<const CollisionBackend*>(component);
}

std::vector<Ray> drawn_rays(const Body& body, Random& random, std::size_t count) {
  std::vector<Ray> rays;
  while (rays.size() < count) {
    double numbers[kRayNumbers];
    for (double& x : numbers) x = random.uniform(-0.6, 0.6);
    numbers[6] = 1.5;
    const Ray ray = ray_at(body, numbers);
    if (ray.direction.norm() > 0.5) rays.push_back(ray);
  }
  return rays;
}

std::vector<PosedSolid> drawn_solids(const Body& body, Random& random, std::size_t count) {
  std::vector<PosedSolid> solids;
  while (solids.size() < count) {
    double numbers[kSolidNumbers];
    for (double& x : numbers) x = random.uniform(0.05, 0.6);
    numbers[0] = static_cast<double>(random.below(3));
    for (std::size_t i = 4; i < kSolidNumbers; ++i) numbers[i] = random.uniform(-1, 1);
    solids.push_back(solid_at(numbers, body.centre(), 0.5 * body.extent()));
  }
  return solids;
}

/// Where nothing is met the distance is rightly infinite; -1 stands for it.
double finite(const RayHit& hit) {
  return hit.triangle == -1 && hit.distance > 0 && std::isinf(hit.distance) ? -1.0 : hit.distance;
}

void add(std::vector<double>& numbers, std::span<const RayHit> hits) {
  for (const RayHit& hit : hits)
    numbers.insert(numbers.end(), {finite(hit), static_cast<double>(hit.triangle)});
}

std::vector<double> distances_of(const CollisionScene& scene, std::span<const PosedSolid> solids) {
  std::vector<double> distances(solids.size(), -1.0);
  scene.distance(solids, distances);
  return distances;
}

std::vector<double> distances_of(const CollisionBackend& backend, std::span<const PosedSolid> a,
                                 std::span<const PosedSolid> b) {
  std::vector<double> distances(a.size(), -1.0);
  backend.distance(a, b, distances);
  return distances;
}

void append(std::vector<double>& numbers, const std::vector<double>& more) {
  numbers.insert(numbers.end(), more.begin(), more.end());
}

/// Everything about one mesh.
std::vector<double> asked(const CollisionBackend& backend, TriangleMeshView mesh, std::span<const Ray> rays,
                          std::span<const PosedSolid> solids) {
  const auto scene = backend.build(mesh);
  std::vector<RayHit> hits(rays.size());
  scene->cast(rays, hits);
  std::vector<double> numbers;
  add(numbers, hits);
  append(numbers, distances_of(*scene, solids));
  const auto half = solids.size() / 2;
  append(numbers, distances_of(backend, solids.first(half), solids.subspan(half, half)));
  return numbers;
}

class CollisionProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name,
                               const Value& given) const override {
    return registry.create<CollisionBackend>(name, given);
  }
  const void* extension(void* component, const char* id) const override {
    return backend_at(component).extension(id);
  }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    Random random(seed);
    std::vector<double> numbers;
    for (const char* name : {"box", "doubled triangles", "soup", "flat triangles"}) {
      const Body& body = conformance::body(name);
      append(numbers, asked(backend_at(component), body.mesh, drawn_rays(body, random, 20),
                            drawn_solids(body, random, 4)));
    }
    return numbers;
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const Body& body = conformance::body("box");
    TriangleMeshView view;
    view.vertices = arena.keep(std::span<const Vector>(body.mesh.vertices));
    view.triangles = arena.keep(std::span<const Triangle>(body.mesh.triangles));
    const auto rays = arena.keep(std::span<const Ray>(drawn_rays(body, random, 20)));
    const auto solids = arena.keep(std::span<const PosedSolid>(drawn_solids(body, random, 6)));
    arena.seal();
    return asked(backend_at(component), view, rays, solids);
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    std::vector<Attempt> attempts;
    for (const std::size_t room : {3, 5}) {
      const std::vector<std::string> named = {"4", fmt::format("{}", room)};
      attempts.push_back({fmt::format("cast of 4 rays with room for {} hits", room),
                          [=] {
                            Random random(1);
                            const Body& box = body("box");
                            const auto rays = drawn_rays(box, random, 4);
                            std::vector<RayHit> hits(
                                room + 8);  // so that a plugin that does not look breaks nothing
                            backend_at(component).build(box.mesh)->cast(rays, std::span(hits).first(room));
                            std::vector<double> numbers;
                            add(numbers, hits);
                            return numbers;
                          },
                          named});
      attempts.push_back({fmt::format("distances of 4 solids to a mesh with room for {}", room),
                          [=] {
                            Random random(1);
                            const Body& box = body("box");
                            const auto solids = drawn_solids(box, random, 4);
                            std::vector<double> numbers(room + 8);
                            backend_at(component).build(box.mesh)->distance(solids,
                                                                            std::span(numbers).first(room));
                            return numbers;
                          },
                          named});
      attempts.push_back({fmt::format("distances of 4 and {} solids with room for 4", room),
                          [=] {
                            Random random(1);
                            const auto solids = drawn_solids(body("box"), random, 12);
                            std::vector<double> numbers(12);
                            backend_at(component).distance(std::span(solids).first(4),
                                                           std::span(solids).first(room),
                                                           std::span(numbers).first(4));
                            return numbers;
                          },
                          named});
    }
    return attempts;
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    const auto with_ray = [=](const char* what, Ray ray) {
      return Attempt{fmt::format("cast with {} in a ray's {}", number, what),
                     [=] {
                       return std::vector<double>{
                           cast_one(*backend_at(component).build(body("box").mesh), ray).distance};
                     },
                     {}};
    };
    const auto with_solid = [=](const char* what, PosedSolid solid) {
      return Attempt{fmt::format("distance with {} in a solid's {}", number, what),
                     [=] {
                       const PosedSolid plain{{Solid::Kind::kSphere, 0.1, 0, Vector::Zero()},
                                              {Eigen::Matrix3d::Identity(), {3, 0, 0}}};
                       const double pair = distance_one(backend_at(component), plain, solid);
                       return std::vector<double>{
                           pair, distance_one(*backend_at(component).build(body("box").mesh), solid)};
                     },
                     {}};
    };
    const Vector bad(0.1, number, 0.2);
    const PosedSolid sphere{{Solid::Kind::kSphere, 0.1, 0, Vector::Zero()}, {}};
    PosedSolid displaced = sphere, sized = sphere;
    displaced.X_OS.p = bad, sized.solid.radius = number;
    return {with_ray("origin", {bad, {0, 0, 1}}),
            with_ray("direction", {{0, 0, -3}, bad}),
            with_solid("place", displaced),
            with_solid("radius", sized),
            {fmt::format("build with {} in a corner", number),
             [=] {
               TriangleMesh mesh = body("box").mesh;
               mesh.vertices[3].x() = number;
               return std::vector<double>{
                   cast_one(*backend_at(component).build(mesh), {{0.1, 0.2, -3}, {0, 0, 1}}).distance};
             },
             {}}};
  }

  std::optional<Answers> batch(void* component, int count, std::uint64_t seed) const override {
    Random random(seed);
    const Body& box = body("box");
    const auto size = static_cast<std::size_t>(count);
    const auto rays = drawn_rays(box, random, size);
    const auto solids = drawn_solids(box, random, size), others = drawn_solids(box, random, size);
    const auto scene = backend_at(component).build(box.mesh);
    std::vector<RayHit> hits(size);
    scene->cast(rays, hits);
    Answers answers;
    add(answers.together, hits);
    append(answers.together, distances_of(*scene, solids));
    append(answers.together, distances_of(backend_at(component), solids, others));
    for (const Ray& ray : rays) add(answers.singly, std::vector{cast_one(*scene, ray)});
    for (const PosedSolid& solid : solids) answers.singly.push_back(distance_one(*scene, solid));
    for (std::size_t i = 0; i < size; ++i)
      answers.singly.push_back(distance_one(backend_at(component), solids[i], others[i]));
    return answers;
  }
};

}  // namespace

const Probe& collision_probe() {
  static const CollisionProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
