#include <optional>

#include "core/geometry/shapes.h"
#include "preshape/geometry/section_profile.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

Eigen::Vector3d unit(int axis) {
  return Eigen::Vector3d::Unit(axis);
}

/// The definition over every triangle, by clipping each to the plane from both sides.
SectionSpan cut_by_definition(const TriangleMesh& mesh, int axis, double station, int transverse) {
  SectionSpan span;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d &a = mesh.corner(t, i), &b = mesh.corner(t, k);
        const double da = a[axis] - station, db = b[axis] - station;
        if (da * db > 0.0 || (i == k && da != 0.0)) continue;
        const double share = da == db ? 0.0 : da / (da - db);
        const double value = a[transverse] + share * (b[transverse] - a[transverse]);
        span.lower = span.empty ? value : std::min(span.lower, value);
        span.upper = span.empty ? value : std::max(span.upper, value);
        span.empty = false;
      }
    }
  }
  return span;
}

}  // namespace

TEST_CASE("Section: a box has its full depth at every station, its end faces included, and nothing beyond") {
  const TriangleMesh mesh = box_mesh({-1, -2, -3}, {4, 5, 6});
  for (int axis = 0; axis < 3; ++axis) {
    const SectionProfile profile(mesh, unit(axis));
    const Box box = bounding_box(mesh);
    for (int transverse = 0; transverse < 3; ++transverse) {
      if (transverse == axis) continue;
      for (const double share : {0.0, 0.1, 0.25, 0.5, 0.75, 1.0}) {
        const double station = box.lower[axis] + share * box.extents()[axis];
        const SectionSpan span = profile.cut(station, unit(transverse));
        CHECK_FALSE(span.empty);
        CHECK(span.lower == box.lower[transverse]);
        CHECK(span.upper == box.upper[transverse]);
        CHECK(span.middle() == box.centre()[transverse]);
      }
      CHECK(profile.cut(std::nextafter(box.lower[axis], -100.0), unit(transverse)).empty);
      CHECK(profile.cut(std::nextafter(box.upper[axis], 100.0), unit(transverse)).empty);
      CHECK(profile.cut(100.0, unit(transverse)).width() == 0.0);
    }
  }
}

TEST_CASE("Section: a sphere at x is sqrt(1 - x^2) wide on either side, as near as its facets are") {
  const int level = 4;
  const TriangleMesh mesh = sphere_mesh(level);
  // Sagitta of the longest side of a facet, about 1.18 / 2^level: facets lie that far inside the sphere.
  const double side = 1.18 / (1 << level), sagitta = side * side / 2;
  const SectionProfile profile(mesh, unit(0));
  for (double x = -0.9; x <= 0.9; x += 0.0173) {
    const double exact = std::sqrt(1 - x * x);
    const SectionSpan span = profile.cut(x, unit(1));
    CHECK_NEAR(span.upper, exact, sagitta / exact);
    CHECK_NEAR(span.lower, -exact, sagitta / exact);
    CHECK(span.upper <= exact + 2 * kEps);
  }
}

TEST_CASE("Section: a corner that only touches the plane is a section of no width") {
  const TriangleMesh tip{{{0, 3, 7}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}},
                         {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  const SectionSpan span = SectionProfile(tip, unit(0)).cut(0.0, unit(1));
  CHECK_FALSE(span.empty);
  CHECK(span.lower == 3.0);
  CHECK(span.upper == 3.0);
}

TEST_CASE("Section: it is what looking at every triangle says, on any mesh and exactly on its vertices") {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const TriangleMesh mesh = i % 2 ? soup_mesh(random, 40, 0.3)
                                    : moved(sphere_mesh(1), random_rotation(random), random_vector(random));
    const int axis = static_cast<int>(random.below(3)),
              transverse = (axis + 1 + static_cast<int>(random.below(2))) % 3;
    const SectionProfile profile(mesh, unit(axis));
    for (int k = 0; k < 60; ++k) {
      const double on_vertex = mesh.vertices[random.below(mesh.vertices.size())][axis];
      const double station = k % 2 ? random.uniform(-1.5, 1.5) : on_vertex;
      const SectionSpan expected = cut_by_definition(mesh, axis, station, transverse);
      const SectionSpan span = profile.cut(station, unit(transverse));
      REQUIRE(span.empty == expected.empty);
      if (span.empty) continue;
      CHECK_NEAR(span.lower, expected.lower, 16 * kEps * 3);
      CHECK_NEAR(span.upper, expected.upper, 16 * kEps * 3);
    }
  }
}

TEST_CASE("Section: a quarter turn about the plane's normal swaps the two spans") {
  Random random(5);
  const TriangleMesh mesh = moved(soup_mesh(random, 200, 0.2), random_rotation(random), {0, 0, 0});
  TriangleMesh turned = mesh;
  for (auto& p : turned.vertices) p = Eigen::Vector3d(p.x(), -p.z(), p.y());
  const SectionProfile profile(mesh, unit(0)), profile_turned(turned, unit(0));
  for (int i = 0; i < 100; ++i) {
    const double station = random.uniform(-1, 1);
    const SectionSpan z = profile.cut(station, unit(2)), y = profile_turned.cut(station, unit(1));
    CHECK(y.lower == -z.upper);
    CHECK(y.upper == -z.lower);
    CHECK(profile_turned.cut(station, unit(2)).lower == profile.cut(station, unit(1)).lower);
  }
}

TEST_CASE("Section: a span never leaves the mesh's box") {
  Random random(6);
  const TriangleMesh mesh = moved(sphere_mesh(2), random_rotation(random), {1e3, 1e3, 1e3});
  const Box box = bounding_box(mesh);
  const SectionProfile profile(mesh, unit(2));
  for (int i = 0; i < 500; ++i) {
    const SectionSpan span = profile.cut(random.uniform(box.lower.z(), box.upper.z()), unit(0));
    CHECK(span.lower >= box.lower.x());
    CHECK(span.upper <= box.upper.x());
  }
}

TEST_CASE("Section: an oblique axis cuts as a coordinate axis cuts the mesh turned the other way") {
  Random random(11);
  const TriangleMesh mesh = sphere_mesh(2);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d R = random_rotation(random);
    TriangleMesh turned = mesh;
    for (auto& vertex : turned.vertices) vertex = R * vertex;
    const double station = random.uniform(-0.9, 0.9);
    const SectionSpan straight = SectionProfile(mesh, unit(0)).cut(station, unit(1));
    const SectionSpan oblique = SectionProfile(turned, R.col(0)).cut(station, R.col(1));
    CHECK_NEAR(oblique.lower, straight.lower, 1e-12);
    CHECK_NEAR(oblique.upper, straight.upper, 1e-12);
  }
}

TEST_SUITE_END();
