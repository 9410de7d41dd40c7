// What rays meet: B01 to B08 and B19.
#include <array>
#include <cmath>
#include <limits>

#include "queries.h"

namespace preshape::conformance {

namespace {

using Vector = Eigen::Vector3d;

std::string in_body(const Body& body, const std::string& sentence) {
  return sentence.empty() ? "" : fmt::format("{} ({})", sentence, body.name);
}

std::string ray_text(const Ray& ray) {
  return fmt::format("the ray from ({}, {}, {}) along ({}, {}, {})", ray.origin.x(), ray.origin.y(),
                     ray.origin.z(), ray.direction.x(), ray.direction.y(), ray.direction.z());
}

/// A corner, the middle of a side, or a place on a side.
Vector on_the_net(const TriangleMesh& mesh, Random& random) {
  const auto t = random.below(mesh.triangles.size());
  const int k = static_cast<int>(random.below(3));
  const Vector &a = mesh.corner(t, k), &b = mesh.corner(t, (k + 1) % 3);
  const double share = std::array{0.0, 0.5, random.uniform()}[random.below(3)];
  return a + share * (b - a);
}

/// Rays that lie in the plane of the box's face x = 1, exactly, through its square.
Ray in_a_face(double slope, double height, int sign) {
  const Vector direction = sign * Vector(0.0, 1.0, slope).normalized();
  const Vector middle(1.0, 0.0, height);
  // Zeros are added so that none of them is negative.
  return {middle - 4.0 * direction, direction + Vector::Zero()};
}

}  // namespace

void b01_nearest_hit(Context& context) {
  Scenes scenes(context);
  auto blocks = ray_blocks();
  blocks.insert(blocks.begin(), body_block());
  context.for_all(blocks, context.cases(1200), [&](Case c) -> std::string {
    const Body& body = body_of(c);
    const Ray ray = ray_at(body, c.subspan(1));
    if (ray.direction.norm() < 0.5) return "";
    return in_body(body, wrong_hit(body, ray, cast_one(scenes.of(body), ray)));
  });
}

void b02_watertight(Context& context) {
  Scenes scenes(context);
  Random random = context.random("aims");
  for (const Body& body : bodies()) {
    if (!body.closed) continue;
    const CollisionScene& scene = scenes.of(body);
    for (int i = 0; i < context.cases(1000); ++i) {
      const Vector aim = on_the_net(body.mesh, random);
      const Ray ray{body.inside, (aim - body.inside).normalized()};
      context.require(cast_one(scene, ray).met(), "{}, from inside of a closed mesh ({}), meets nothing",
                      ray_text(ray), body.name);
    }
  }
  for (int i = 0; i < context.cases(100); ++i) {
    const Ray ray = in_a_face(random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), i % 2 ? 1 : -1);
    context.require(cast_one(scenes.of(body("box")), ray).met(),
                    "{}, through two edges of a box, meets nothing", ray_text(ray));
  }
}

void b03_flat_triangles(Context& context) {
  Scenes scenes(context);
  const Body& with = body("flat triangles");
  TriangleMesh without{with.mesh.vertices, {}};
  std::vector<std::int32_t> kept;
  for (std::size_t t = 0; t < with.mesh.triangles.size(); ++t) {
    if (with.mesh.area_vector(t).norm() == 0.0) continue;
    kept.push_back(static_cast<std::int32_t>(t));
    without.triangles.push_back(with.mesh.triangles[t]);
  }
  const auto clean = scenes.build(without);
  Random random = context.random("rays");
  for (int i = 0; i < context.cases(1000); ++i) {
    const Vector direction = random_unit(random);
    Vector aim = 1.4 * random.uniform() * random_unit(random);
    if (i % 2) {  // at a flat one
      std::size_t t = random.below(with.mesh.triangles.size());
      while (with.mesh.area_vector(t).norm() > 0.0) t = (t + 1) % with.mesh.triangles.size();
      aim = with.mesh.corner(t, 0) + random.uniform() * (with.mesh.corner(t, 2) - with.mesh.corner(t, 0));
    }
    const Ray ray{aim - 3.0 * direction, direction};
    const RayHit a = cast_one(scenes.of(with), ray), b = cast_one(*clean, ray);
    const std::int32_t expected = b.met() ? kept[static_cast<std::size_t>(b.triangle)] : -1;
    context.require(a.triangle == expected && (!b.met() || std::abs(a.distance - b.distance) <= 1e-12 * 3.0),
                    "{} meets triangle {} at {}, but {} at {} without the triangles that have no area",
                    ray_text(ray), a.triangle, a.distance, expected, b.distance);
  }
}

void b04_rays_from_the_surface(Context& context) {
  Scenes scenes(context);
  Random random = context.random("rays");
  for (const char* name : {"sphere", "box", "far sphere"}) {
    const Body& body = conformance::body(name);
    const double step = 1e-7 * body.extent();
    for (int i = 0; i < context.cases(300); ++i) {
      const auto t = random.below(body.mesh.triangles.size());
      const double u = random.uniform(0.1, 0.4), v = random.uniform(0.1, 0.4);
      const Vector place =
          (1 - u - v) * body.mesh.corner(t, 0) + u * body.mesh.corner(t, 1) + v * body.mesh.corner(t, 2);
      const Vector normal = body.mesh.area_vector(t).normalized();
      Vector direction = random_unit(random);
      if (direction.dot(normal) < 0.0) direction = -direction;
      if (direction.dot(normal) < 0.1) continue;
      const Ray outside{place + step * normal, direction}, inside{place - step * normal, direction},
          on{place, direction};
      const RayHit away = cast_one(scenes.of(body), outside), through = cast_one(scenes.of(body), inside),
                   start = cast_one(scenes.of(body), on);
      context.require(!away.met(), "{} begins {} m outside of {} and leaves it, but meets triangle {} at {}",
                      ray_text(outside), step, name, away.triangle, away.distance);
      context.require(through.met() && through.distance <= 11.0 * step,
                      "{} begins {} m inside of {} and leaves it, but meets triangle {} at {}",
                      ray_text(inside), step, name, through.triangle, through.distance);
      context.require(!start.met() || (start.distance >= 0.0 && start.distance <= 1e-6 * body.extent()),
                      "{} begins on {} and leaves it, but meets triangle {} at {}", ray_text(on), name,
                      start.triangle, start.distance);
    }
  }
}

void b05_rays_in_a_face(Context& context) {
  Scenes scenes(context);
  const CollisionScene& scene = scenes.of(body("box"));
  const std::vector<Block> blocks = {
      {"slope", 1, -0.2, 0.2, {0.0}}, {"height", 1, -0.1, 0.1, {0.0}}, {"beside", 1, -0.5, 0.5, {0.0}}};
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    Ray there = in_a_face(c[0], c[1], 1), back = in_a_face(c[0], c[1], -1);
    there.origin.x() += c[2], back.origin.x() += c[2];
    const RayHit hit = cast_one(scene, there), turned = cast_one(scene, back);
    for (const RayHit& h : {hit, turned}) {
      if (std::isnan(h.distance) || h.met() != std::isfinite(h.distance)) {
        return fmt::format("{}, parallel to a face, meets triangle {} at {}", ray_text(there), h.triangle,
                           h.distance);
      }
    }
    if (hit.met() != turned.met())
      return fmt::format("{} is told to meet the box, turned round it is not, or the other way",
                         ray_text(there));
    if (std::abs(c[2]) < 1e-6 || hit.met() == (c[2] < 0.0)) return "";
    return fmt::format("{}, {} m beside a face, {} the box", ray_text(there), c[2],
                       hit.met() ? "meets" : "misses");
  });
}

void b06_signed_zeros(Context& context) {
  Scenes scenes(context);
  const Body thin{"plate without thickness", box_mesh({-1, -0.5, 0}, {1, 0.5, 0}), false, Vector::Zero()};
  const auto thin_scene = scenes.build(thin.mesh);
  const std::vector<Block> blocks = {{"axis", 1, 0, 2, {}, true},
                                     {"sign", 1, 0, 1, {}, true},
                                     {"at", 2, -8, 8, {}, true},
                                     {"plate", 1, 0, 1, {}, true}};
  context.for_all(blocks, context.cases(500), [&](Case c) -> std::string {
    const Body& asked = c[4] > 0 ? thin : body("box");
    const CollisionScene& scene = c[4] > 0 ? *thin_scene : scenes.of(asked);
    const int axis = static_cast<int>(c[0]);
    Ray plus, minus;
    // Places at odd sixteenths: never in a face's plane, and exact.
    plus.origin[axis] = c[1] > 0 ? -3.0 : 3.0;
    plus.origin[(axis + 1) % 3] = (2.0 * c[2] + 1.0) / 16.0,
                             plus.origin[(axis + 2) % 3] = (2.0 * c[3] + 1.0) / 16.0;
    plus.direction = Vector::Zero(), plus.direction[axis] = c[1] > 0 ? 1.0 : -1.0;
    minus = plus;
    for (double& x : minus.direction) x = x == 0.0 ? -0.0 : x;
    const RayHit first = cast_one(scene, plus), second = cast_one(scene, minus);
    if (first.triangle != second.triangle || first.distance != second.distance) {
      return fmt::format("{} meets triangle {} at {}, with negative zeros {} at {}", ray_text(plus),
                         first.triangle, first.distance, second.triangle, second.distance);
    }
    return in_body(asked, wrong_hit(asked, plus, first));
  });
}

void b07_unit_directions(Context& context) {
  Scenes scenes(context);
  const CollisionScene& scene = scenes.of(body("sphere"));
  for (const double length : {1e-3, 0.5, 1.001, 2.0, 1e6}) {
    const Ray ray{{-3, 0.1, 0.2}, {length, 0, 0}};
    const std::string instead = not_refused([&] { cast_one(scene, ray); });
    context.require(instead.empty(), "a direction of length {}: {}", length, instead);
  }
  for (const double length : {1.0 - 5e-7, 1.0, 1.0 + 5e-7}) {
    const RayHit hit = cast_one(scene, {{-3, 0.1, 0.2}, {length, 0, 0}});
    context.require(
        hit.met() && hit.distance > 2.0 && hit.distance < 2.2,
        "a direction of length {}, which is 1 to 1e-6, meets a sphere of radius 1 at {} from 3 away", length,
        hit.distance);
  }
}

void b08_no_direction(Context& context) {
  Scenes scenes(context);
  const CollisionScene& scene = scenes.of(body("sphere"));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  for (const Vector& direction : {Vector(0, 0, 0), Vector(-0.0, 0, 0), Vector(kNan, 0, 0), Vector(1, kNan, 0),
                                  Vector(kInf, 0, 0), Vector(1, 0, -kInf)}) {
    const Ray ray{{-3, 0.1, 0.2}, direction};
    const std::string instead = not_refused([&] { cast_one(scene, ray); });
    context.require(instead.empty(), "{}: {}", ray_text(ray), instead);
  }
}

void b19_lowest_of_equals(Context& context) {
  Scenes scenes(context);
  const Body& body = conformance::body("doubled triangles");
  const auto half = static_cast<std::int32_t>(body.mesh.triangles.size() / 2);
  context.for_all(ray_blocks(), context.cases(500), [&](Case c) -> std::string {
    const Ray ray = ray_at(body, c);
    if (ray.direction.norm() < 0.5) return "";
    const RayHit hit = cast_one(scenes.of(body), ray);
    return hit.triangle < half ? ""
                               : fmt::format("triangle {} is told, {} is the same and has a lower index",
                                             hit.triangle, hit.triangle - half);
  });
}

}  // namespace preshape::conformance
