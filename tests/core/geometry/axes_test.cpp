#include "core/geometry/shapes.h"
#include "preshape/geometry/object.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

Eigen::Vector3d extents_in(const TriangleMesh& mesh, const Eigen::Matrix3d& R_FO) {
  return bounding_box(moved(mesh, R_FO.transpose(), {0, 0, 0})).extents();
}

/// The best of many random turns: an upper bound on the smallest box that knows nothing of hulls.
double volume_by_sampling(const TriangleMesh& mesh, Random& random, int count) {
  double best = extents_in(mesh, Eigen::Matrix3d::Identity()).prod();
  for (int i = 0; i < count; ++i) best = std::min(best, extents_in(mesh, random_rotation(random)).prod());
  return best;
}

void check_right_handed(const Eigen::Matrix3d& R) {
  CHECK_NEAR(Eigen::Matrix3d(R.transpose() * R), Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 16 * kEps);
  CHECK_NEAR(R.determinant(), 1.0, 16 * kEps);
}

}  // namespace

TEST_CASE("Axes: a box is found exactly at any orientation, longest side along X") {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    Eigen::Vector3d sides(1 + random.uniform(), 2.5 + random.uniform(), 4.5 + random.uniform());
    if (i % 3 == 0) sides *= 1e-3;
    const Eigen::Matrix3d R = i == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : random_rotation(random);
    const TriangleMesh mesh = moved(box_mesh(-sides / 2, sides / 2), R, random_vector(random));
    const Eigen::Vector3d expected(sides.z(), sides.y(), sides.x());
    for (const auto& axes : {smallest_box_axes(mesh), principal_axes(mesh)}) {
      check_right_handed(axes);
      // Axes are good to about 10 eps (from the vertices' own rounding, |p| / side), which turns sides by
      // that.
      CHECK_NEAR(extents_in(mesh, axes), expected, 1e-13 * (1 + expected.maxCoeff()));
      for (int k = 0; k < 2; ++k) CHECK(axes.col(k).maxCoeff() >= axes.col(k).cwiseAbs().maxCoeff() - 1e-9);
    }
  }
}

TEST_CASE("Axes: equal sides and round bodies keep the file's axes") {
  const TriangleMesh cube = box_mesh({3, 3, 3}, {5, 5, 5});
  CHECK(smallest_box_axes(cube) == Eigen::Matrix3d::Identity());
  CHECK(principal_axes(cube) == Eigen::Matrix3d::Identity());
  for (const int level : {2, 3}) {
    CHECK(smallest_box_axes(sphere_mesh(level)) == Eigen::Matrix3d::Identity());
    CHECK(principal_axes(sphere_mesh(level)) == Eigen::Matrix3d::Identity());
  }
  const TriangleMesh bar = box_mesh({0, 0, 0}, {5, 1, 1});
  CHECK(smallest_box_axes(bar) == Eigen::Matrix3d::Identity());
  CHECK(principal_axes(bar) == Eigen::Matrix3d::Identity());
}

TEST_CASE("Axes: single precision in the file does not turn a cube") {
  TriangleMesh cube = box_mesh({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
  Random random(8);
  for (auto& p : cube.vertices) p += 6e-9 * random_vector(random);  // 6e-8 of the coordinates
  CHECK_NEAR(smallest_box_axes(cube), Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 1e-6);
  CHECK_NEAR(principal_axes(cube), Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 1e-6);
}

TEST_CASE("Smallest box: a regular tetrahedron stands with its edges in the faces of a cube") {
  Random random(9);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh mesh = moved(tetrahedron_mesh(), random_rotation(random), {0, 0, 0});
    CHECK_NEAR(extents_in(mesh, smallest_box_axes(mesh)).prod(), 8.0, 1e-12 * 8);
  }
}

TEST_CASE("Smallest box: thousands of random turns never find a smaller one") {
  Random random(10);
  for (int i = 0; i < 12; ++i) {
    TriangleMesh mesh = soup_mesh(random, 12, 0.5);
    mesh = scaled(mesh, {1.0, random.uniform(0.3, 1), random.uniform(0.2, 1)});
    mesh = moved(mesh, random_rotation(random), {0, 0, 0});
    const double found = extents_in(mesh, smallest_box_axes(mesh)).prod();
    CHECK(found <= volume_by_sampling(mesh, random, 4000) * (1 + 1e-12));
  }
}

TEST_CASE("Smallest box: turning the body turns the box with it") {
  Random random(11);
  const TriangleMesh body = scaled(soup_mesh(random, 40, 0.4), {1, 0.6, 0.3});
  const Eigen::Vector3d extents = extents_in(body, smallest_box_axes(body));
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh turned = moved(body, random_rotation(random), random_vector(random));
    CHECK_NEAR(extents_in(turned, smallest_box_axes(turned)), extents, 1e-11);
  }
}

TEST_CASE("Smallest box: a flat mesh gets the smallest rectangle in its plane") {
  Random random(12);
  const TriangleMesh sheet{{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh mesh = moved(sheet, random_rotation(random), {0, 0, 0});
    CHECK_NEAR(extents_in(mesh, smallest_box_axes(mesh)), Eigen::Vector3d(3, 1, 0), 1e-14 * 4);
  }
}

TEST_CASE("Principal axes: an ellipsoid's are its own, also of an open shell") {
  Random random(13);
  const TriangleMesh ellipsoid = scaled(sphere_mesh(3), {3, 2, 1});
  TriangleMesh shell = ellipsoid;
  std::erase_if(shell.triangles, [&](const Triangle& t) {  // a hole that is symmetric in all three planes
    const Eigen::Vector3d middle =
        (shell.vertices[static_cast<std::size_t>(t[0])] + shell.vertices[static_cast<std::size_t>(t[1])] +
         shell.vertices[static_cast<std::size_t>(t[2])]) /
        3;
    return std::abs(middle.x()) > 2.7;
  });
  REQUIRE_FALSE(mesh_topology(shell).watertight());
  for (const auto& mesh : {ellipsoid, shell}) {
    const Eigen::Matrix3d R = random_rotation(random);
    const Eigen::Matrix3d axes = principal_axes(moved(mesh, R, random_vector(random)));
    CHECK_NEAR(Eigen::Matrix3d((R.transpose() * axes).cwiseAbs()),
               Eigen::Matrix3d(Eigen::Matrix3d::Identity()), 1e-12);
  }
}

TEST_SUITE_END();
