#include "preshape/geometry/distance.h"
#include "core/geometry/shapes.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

using Vector = Eigen::Vector3d;

Solid sphere(double radius) {
  return {Solid::Kind::kSphere, radius, 0, {0, 0, 0}};
}
Solid capsule(double radius, double half_length) {
  return {Solid::Kind::kCapsule, radius, half_length, {0, 0, 0}};
}
Solid box(const Vector& half) {
  return {Solid::Kind::kBox, 0, 0, half};
}

PosedSolid at(const Solid& solid, const Vector& p, const Eigen::Matrix3d& R = Eigen::Matrix3d::Identity()) {
  return {solid, {R, p}};
}

Solid random_solid(Random& random) {
  switch (random.below(3)) {
    case 0:
      return sphere(random.uniform(0.0, 0.5));
    case 1:
      return capsule(random.uniform(0.0, 0.3), random.uniform(0.0, 1.0));
    default:
      return box({random.uniform(0.0, 0.6), random.uniform(0.0, 0.6), random.uniform(0.0, 0.6)});
  }
}

/// A point of the solid.
Vector inside(const PosedSolid& s, Random& random) {
  const Vector v = random_vector(random);
  if (s.solid.kind == Solid::Kind::kBox) return s.X_OS * Vector(v.cwiseProduct(s.solid.half_extents));
  const double along =
      s.solid.kind == Solid::Kind::kCapsule ? random.uniform(-1, 1) * s.solid.half_length : 0.0;
  return s.X_OS * Vector(Vector(0, 0, along) + random.uniform() * s.solid.radius * random_unit(random));
}

/// How far the solid reaches along a direction.
double support(const PosedSolid& s, const Vector& direction) {
  const Vector d = s.X_OS.R.transpose() * direction;
  const double base = direction.dot(s.X_OS.p);
  if (s.solid.kind == Solid::Kind::kBox) return base + s.solid.half_extents.dot(d.cwiseAbs());
  const double along = s.solid.kind == Solid::Kind::kCapsule ? s.solid.half_length * std::abs(d.z()) : 0.0;
  return base + along + s.solid.radius * direction.norm();
}

double support(const std::vector<Vector>& points, const Vector& direction) {
  double most = -1e300;
  for (const auto& p : points) most = std::max(most, direction.dot(p));
  return most;
}

/// Distance of convex bodies by their supports alone: the widest gap over all directions, climbed from many
/// of them by smaller and smaller random steps. Never more than the distance, and equal to it in the end.
template <class A, class B>
double gap_by_supports(const A& a, const B& b, Random& random) {
  const auto gap = [&](const Vector& n) { return -support(a, n) - support(b, Vector(-n)); };
  double widest = 0.0;
  for (int start = 0; start < 12; ++start) {
    Vector n = random_unit(random);
    double best = gap(n);
    for (double step = 1.0; step > 1e-9; step *= 0.9) {
      for (int i = 0; i < 12; ++i) {
        const Vector m = (n + step * random_vector(random)).normalized();
        if (gap(m) > best) best = gap(m), n = m;
      }
    }
    widest = std::max(widest, best);
  }
  return widest;
}

}  // namespace

TEST_CASE("Distance: points and segments in closed form, degenerate ones included") {
  CHECK(distance_point_segment({0, 3, 4}, {-1, 0, 0}, {1, 0, 0}) == 5.0);
  CHECK(distance_point_segment({4, 4, 0}, {-1, 0, 0}, {1, 0, 0}) == 5.0);
  CHECK(distance_point_segment({0, 3, 4}, {0, 0, 0}, {0, 0, 0}) == 5.0);
  CHECK(distance_segments({-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 1, 2}) == 2.0);  // crossing
  CHECK(distance_segments({-1, 0, 0}, {1, 0, 0}, {-1, 3, 0}, {1, 3, 0}) == 3.0);  // parallel
  CHECK(distance_segments({-1, 0, 0}, {1, 0, 0}, {4, 4, 0}, {9, 4, 0}) == 5.0);   // parallel, apart
  CHECK(distance_segments({-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {5, 0, 0}) == 0.0);   // overlapping on a line
  CHECK(distance_segments({0, 0, 0}, {0, 0, 0}, {0, 3, 4}, {0, 3, 4}) == 5.0);    // two points
}

TEST_CASE("Distance: nearly parallel segments lose no digits that count") {
  Random random(31);
  for (const double angle : {1e-3, 1e-5, 1e-7, 1e-9}) {
    for (int i = 0; i < 100; ++i) {
      const double height = random.uniform(0, 1e-3);
      const Eigen::Matrix3d R = random_rotation(random);
      const double found = distance_segments(R * Vector(-1, 0, 0), R * Vector(1, 0, 0),
                                             R * Vector(-1, -angle, height), R * Vector(1, angle, height));
      CHECK_NEAR(found, height,
                 2e-8);  // the crossing is found to eps / angle, ends are no farther than the angle
    }
  }
}

TEST_CASE("Distance: a point over a triangle, beside a side and off a corner") {
  const Vector a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  CHECK(distance_point_triangle({1, 1, -2}, a, b, c) == 2.0);
  CHECK(distance_point_triangle({2, -3, 4}, a, b, c) == 5.0);
  CHECK(distance_point_triangle({-3, -4, 12}, a, b, c) == 13.0);
  CHECK(distance_point_triangle({1, 1, 0}, a, b, c) == 0.0);
}

TEST_CASE("Distance: a segment through a triangle touches it, one in its plane outside does not") {
  const Vector a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  CHECK(distance_segment_triangle({1, 1, -5}, {1, 1, 5}, a, b, c) == 0.0);
  CHECK(distance_segment_triangle({1, 1, 1}, {1, 1, 5}, a, b, c) == 1.0);
  CHECK(distance_segment_triangle({5, 5, -5}, {5, 5, 5}, a, b, c) > 3.0);
  CHECK(distance_segment_triangle({1, 1, 0}, {1.5, 1, 0}, a, b, c) == 0.0);
  Random random(32);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Matrix3d R = random_rotation(random);
    CHECK_NEAR(distance_segment_triangle(R * Vector(-1, -2, 0), R * Vector(5, -2, 0), R * a, R * b, R * c),
               2.0, 1e-14 * 8);
  }
}

TEST_CASE("Distance: solids against a triangle agree with their supports, and touching is 0") {
  Random random(33);
  int apart = 0, touching = 0;
  for (int i = 0; i < 250; ++i) {
    const PosedSolid solid = at(random_solid(random), 0.7 * random_vector(random), random_rotation(random));
    const TriangleMesh t = soup_mesh(random, 1, 1.0);
    const double d = distance_solid_triangle(solid, t.corner(0, 0), t.corner(0, 1), t.corner(0, 2));
    const double gap = gap_by_supports(solid, t.vertices, random);
    CHECK(gap <= d + 1e-12);
    CHECK_NEAR(d, gap, 1e-4);  // the climb's own error; a wrong feature would be off by hundredths and more
    apart += d > 0, touching += d == 0;
  }
  CHECK(apart > 50);
  CHECK(touching > 15);
}

TEST_CASE("Distance: solids against solids agree with their supports, either way round") {
  Random random(34);
  int apart = 0, touching = 0;
  for (int i = 0; i < 300; ++i) {
    const PosedSolid a = at(random_solid(random), random_vector(random), random_rotation(random));
    const PosedSolid b = at(random_solid(random), 0.8 * random_vector(random), random_rotation(random));
    const double d = distance_solids(a, b);
    CHECK_NEAR(distance_solids(b, a), d, 1e-14 * 4);
    const double gap = gap_by_supports(a, b, random);
    CHECK(gap <= d + 1e-12);
    CHECK_NEAR(d, gap, 1e-4);
    for (int k = 0; k < 20; ++k) CHECK((inside(a, random) - inside(b, random)).norm() >= d - 1e-14);
    apart += d > 0, touching += d == 0;
  }
  CHECK(apart > 80);
  CHECK(touching > 30);
}

TEST_CASE("Distance: boxes face to face, edge to edge and corner to corner") {
  const Solid cube = box({1, 1, 1});
  const double r = std::sqrt(2.0);
  CHECK(distance_solids(at(cube, {0, 0, 0}), at(cube, {5, 0.5, 0.5})) == 3.0);
  CHECK_NEAR(distance_solids(at(cube, {0, 0, 0}), at(cube, {5, 6, 0})), 5.0, 4 * kEps * 5);
  CHECK_NEAR(distance_solids(at(cube, {0, 0, 0}), at(cube, {3, 4, 4})), 3.0, 4 * kEps * 5);
  CHECK(distance_solids(at(cube, {0, 0, 0}), at(cube, {2, 0, 0})) == 0.0);
  CHECK(distance_solids(at(cube, {0, 0, 0}), at(box({0.1, 0.1, 0.1}), {0, 0, 0})) ==
        0.0);  // one in the other
  // Crossed edges: each box turned by 45 degrees about a horizontal axis, across each other.
  const Eigen::Matrix3d about_x = Eigen::AngleAxisd(M_PI / 4, Vector::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d about_y = Eigen::AngleAxisd(M_PI / 4, Vector::UnitY()).toRotationMatrix();
  CHECK_NEAR(distance_solids(at(cube, {0, 0, 0}, about_x), at(cube, {0, 0, 4}, about_y)), 4 - 2 * r,
             8 * kEps * 4);
}

TEST_CASE("Distance: it is the same wherever both bodies are taken") {
  Random random(35);
  for (int i = 0; i < 300; ++i) {
    const PosedSolid a = at(random_solid(random), random_vector(random), random_rotation(random));
    const PosedSolid b = at(random_solid(random), random_vector(random), random_rotation(random));
    const Pose X{random_rotation(random), 10 * random_vector(random)};
    const PosedSolid a_moved{a.solid, X * a.X_OS}, b_moved{b.solid, X * b.X_OS};
    CHECK_NEAR(distance_solids(a_moved, b_moved), distance_solids(a, b), 1e-13 * 20);
  }
}

TEST_SUITE_END();
