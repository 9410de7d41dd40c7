#include "preshape/geometry/ray_triangle.h"
#include "core/geometry/shapes.h"
#include "preshape/base/error.h"
#include "preshape/geometry/query_checks.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/geometry");

namespace {

double met_at(const Ray& ray, const TriangleMesh& mesh, std::size_t t = 0) {
  return RayProbe(ray).distance(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

int count_met(const Ray& ray, const TriangleMesh& mesh) {
  int count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) count += std::isfinite(met_at(ray, mesh, t));
  return count;
}

}  // namespace

TEST_CASE("Ray: it meets a point inside a triangle at its distance, from either side") {
  Random random(21);
  for (int i = 0; i < 2000; ++i) {
    const TriangleMesh mesh = soup_mesh(random, 1, 1.0);
    const Eigen::Vector3d n = mesh.area_vector(0);
    double u = random.uniform(0.01, 0.98), v = random.uniform(0.01, 0.99 - u);
    const Eigen::Vector3d p = mesh.corner(0, 0) + u * (mesh.corner(0, 1) - mesh.corner(0, 0)) +
                              v * (mesh.corner(0, 2) - mesh.corner(0, 0));
    const Eigen::Vector3d direction = random_unit(random);
    const double slant = std::abs(n.normalized().dot(direction));
    if (slant < 0.01 || n.norm() < 0.01) continue;
    const double distance = random.uniform(0.1, 10.0);
    // Rounding of the origin (10) and of the areas against the triangle's own, seen at the slant.
    CHECK_NEAR(met_at({p - distance * direction, direction}, mesh), distance, 1e-11 / slant);
    CHECK(std::isinf(met_at({p + distance * direction, direction}, mesh)));
    CHECK(std::isinf(met_at({p - distance * direction + 1.1 * (mesh.corner(0, 0) - p) +
                                 3 * (mesh.corner(0, 0) - mesh.corner(0, 1)),
                             direction},
                            mesh)) == true);
  }
}

TEST_CASE("Ray: one aimed at a point outside a triangle in its plane passes by") {
  Random random(22);
  for (int i = 0; i < 2000; ++i) {
    const TriangleMesh mesh = soup_mesh(random, 1, 1.0);
    if (mesh.area_vector(0).norm() < 0.05) continue;
    // Beyond the side BC, by barycentric coordinates.
    const double v = random.uniform(0.0, 1.0), beyond = random.uniform(0.001, 2.0);
    const Eigen::Vector3d side = mesh.corner(0, 1) + v * (mesh.corner(0, 2) - mesh.corner(0, 1));
    const Eigen::Vector3d p = side + beyond * (side - mesh.corner(0, 0));
    const Eigen::Vector3d direction = random_unit(random);
    if (std::abs(mesh.area_vector(0).normalized().dot(direction)) < 0.01) continue;
    CHECK(std::isinf(met_at({p - 2 * direction, direction}, mesh)));
  }
}

TEST_CASE("Ray: none slips out of a closed mesh through a corner or an edge") {
  Random random(23);
  int through_edges = 0;
  for (int i = 0; i < 40; ++i) {
    const TriangleMesh mesh =
        moved(i % 2 ? sphere_mesh(2) : box_mesh({-1, -1, -1}, {1, 1, 1}), random_rotation(random),
              i % 4 < 2 ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(random_vector(random) * 100));
    const Eigen::Vector3d inside = bounding_box(mesh).centre() + 0.3 * random_vector(random);
    const auto aim = [&](const Eigen::Vector3d& p) {
      const int met = count_met({inside, (p - inside).normalized()}, mesh);
      CHECK(met >= 1);
      through_edges += met > 1;
    };
    for (const auto& corner : mesh.vertices) aim(corner);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        aim((mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3)) / 2);
        aim(mesh.corner(t, k) + random.uniform() * (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)));
      }
    }
  }
  CHECK(through_edges > 500);  // exactly on an edge both triangles answer
}

TEST_CASE("Ray: along the axes, with zeros of either sign, a box is met at its face") {
  const TriangleMesh mesh = box_mesh({-1, -2, -3}, {1, 2, 3});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double zero : {0.0, -0.0}) {
      for (const double sign : {1.0, -1.0}) {
        Eigen::Vector3d direction = Eigen::Vector3d::Constant(zero);
        direction[axis] = sign;
        for (const Eigen::Vector3d& aside : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3),
                                             Eigen::Vector3d(-1, 2, 0), Eigen::Vector3d(0.5, -1, 3)}) {
          Eigen::Vector3d origin = aside;
          origin[axis] = -10.0 * sign;
          double nearest = 1e300;
          for (std::size_t t = 0; t < 12; ++t)
            nearest = std::min(nearest, met_at({origin, direction}, mesh, t));
          CHECK(nearest == 10.0 - (axis + 1));
        }
      }
    }
  }
}

TEST_CASE("Ray: an origin on the surface meets it at once, one just beyond does not") {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK(met_at({{0.25, 0.25, 0}, {0, 0, 1}}, mesh) == 0.0);
  CHECK(std::isinf(met_at({{0.25, 0.25, 1e-300}, {0, 0, 1}}, mesh)));
}

TEST_CASE("Ray: a triangle seen edge on is not met") {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  CHECK(std::isinf(met_at({{-1, 0.25, 0}, {1, 0, 0}}, mesh)));
}

TEST_CASE("Ray: one in a triangle's plane, to rounding, is met in the triangle's box or not at all") {
  Random random(24);
  int seemingly = 0;
  for (int i = 0; i < 20000; ++i) {
    const TriangleMesh mesh = moved(soup_mesh(random, 1, 0.3), random_rotation(random), random_vector(random));
    const Eigen::Vector3d &a = mesh.corner(0, 0), &b = mesh.corner(0, 1), &c = mesh.corner(0, 2);
    const Eigen::Vector3d along = (b - a).normalized(), across = ((c - a) - (c - a).dot(along) * along).normalized();
    const double width = (c - a).dot(across);
    if (width < 1e-3) continue;
    const double height = random.uniform(-1.0, 2.0) * width;
    const Ray ray{a + height * across - random.uniform(0.0, 2.0) * along, along};
    const double distance = met_at(ray, mesh);
    if (std::isinf(distance)) continue;
    ++seemingly;
    const Box box = bounding_box(mesh);
    const Eigen::Vector3d p = ray.origin + distance * ray.direction;
    CHECK(((p - box.lower).minCoeff() > -1e-9 && (box.upper - p).minCoeff() > -1e-9));
  }
  CHECK(seemingly > 20);  // rounding lets some seem met
}

TEST_CASE("Nearest hit: of equal distances the lowest triangle wins, whatever the order") {
  const std::vector<RayHit> offers = {{2.0, 7}, {1.0 + 1e-13, 5}, {1.0, 9}, {1.0 + 1e-9, 1}, {3.0, 0}};
  std::vector<std::size_t> order = {0, 1, 2, 3, 4};
  do {
    NearestHit nearest(1.0);
    CHECK_FALSE(nearest.hit().met());
    for (const std::size_t i : order) nearest.offer(offers[i].distance, offers[i].triangle);
    nearest.offer(std::numeric_limits<double>::infinity(), 0);
    CHECK(nearest.hit().triangle == 5);
    CHECK(nearest.hit().distance == 1.0);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("Checks: rays, solids and meshes that cannot be answered for are refused by name") {
  const Ray good{{0, 0, 0}, {1, 0, 0}};
  check_rays(std::vector<Ray>{good}, 1);
  CHECK_THROWS_SAYING(check_rays(std::vector<Ray>{good}, 2), InputError,
                      "there are 1 rays but room for 2 hits");
  for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 0),
                                   Eigen::Vector3d(NAN, 0, 0), Eigen::Vector3d(INFINITY, 0, 0)}) {
    const std::vector<Ray> rays = {good, {{0, 0, 0}, d}};
    CHECK_THROWS_SAYING(check_rays(rays, 2), InputError, "ray 1 has a direction that is not of unit length");
  }
  CHECK_THROWS_SAYING(check_rays(std::vector<Ray>{{{0, NAN, 0}, {1, 0, 0}}}, 1), InputError,
                      "ray 0 has an origin that is not finite");

  PosedSolid solid;
  solid.solid.radius = -1;
  CHECK_THROWS_SAYING(check_solids(std::vector<PosedSolid>{solid}, 1), InputError,
                      "solid 0 has a size that is negative");
  CHECK_THROWS_SAYING(check_solids({}, 1), InputError, "there are 0 solids but room for 1 distances");
  solid.solid.radius = 1;
  solid.solid.half_length = NAN;  // of no sphere
  check_solids(std::vector<PosedSolid>{solid}, 1);
  solid.X_OS.p.x() = NAN;
  CHECK_THROWS_SAYING(check_solids(std::vector<PosedSolid>{solid}, 1), InputError,
                      "solid 0 has a pose that is not finite");

  TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles.emplace_back(0, 0, 1);
  CHECK(touchable_triangles(mesh).size() == 12);
  CHECK_NEAR(extent_of(mesh), std::sqrt(3.0), kEps);
  mesh.triangles.emplace_back(0, 1, 99);
  CHECK_THROWS_SAYING(touchable_triangles(mesh), InputError, "triangle 13 has no finite corner 2");
  CHECK(extent_of(TriangleMesh{}) == 0.0);
}

TEST_SUITE_END();
