// The lazy hull against Qhull, which makes all facets of the same points.
#include <algorithm>
#include <cmath>

#include "preshape/contact/wrench_hull.h"
#include "support/cones.h"
#include "support/enumerated.h"
#include "support/near.h"
#include "support/qhull.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/contact");

namespace {

/// The factor of the ellipsoid by every facet of Qhull's hull.
double by_facets(const Hull& hull, const WrenchEllipsoid& task) {
  double factor = INFINITY;
  for (std::size_t i = 0; i < hull.normals.size(); ++i) {
    const double reach = task.reach(hull.normals[i]), offset = std::max(0.0, hull.offsets[i]);
    if (reach > 1e-9) factor = std::min(factor, offset / reach);
  }
  return factor;
}

void check_same(const GraspWrenchSpace& space, const WrenchEllipsoid& task, double tolerance) {
  const Hull hull = qhull(enumerated(space));
  const auto fit = largest_ellipsoid(space, task);
  CHECK(fit.spans == hull.made);
  CHECK_NEAR(fit.factor, hull.made ? by_facets(hull, task) : 0.0, tolerance);
}

/// Contacts evenly round the equator, moved by up to `off`.
std::vector<PointContact> ring(Random& random, int count, double off) {
  std::vector<PointContact> contacts;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const Eigen::Vector3d p(std::cos(angle), std::sin(angle), 0.0);
    contacts.push_back({p + off * random_vector(random), -p, 0.6, 0.3});
  }
  return contacts;
}

}  // namespace

TEST_CASE("Epsilon: on random grasps of two to five contacts it is the least offset of Qhull's facets") {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    check_same(wrench_space(random_grasp(random, 2 + i % 4, 0.5, i % 2 ? 0.2 : 0.0), 8, ForceBound::kSum), {}, 1e-12);
  }
}

TEST_CASE("Epsilon: it is so too where each contact has its own bound, without the sum being enumerated") {
  Random random(2);
  for (int i = 0; i < 12; ++i) check_same(wrench_space(random_grasp(random, 2 + i % 2, 0.7, 0.2), 4, ForceBound::kEach), {}, 1e-12);
}

TEST_CASE("Epsilon: on symmetric rings of contacts, whole and disturbed by 1e-5 to 1e-13 of their radius, it is Qhull's") {
  Random random(3);
  for (int count = 2; count <= 5; ++count) {
    check_same(wrench_space(ring(random, count, 0.0), 8, ForceBound::kSum), {}, 1e-12);
    for (int digits = 5; digits <= 13; ++digits) {
      // Qhull merges facets that differ by little and moves them by up to some 1e-8.
      const auto space = wrench_space(ring(random, count, std::pow(10.0, -digits)), 8, ForceBound::kSum);
      const Hull hull = qhull(enumerated(space));
      if (hull.made) CHECK_NEAR(largest_ellipsoid(space).factor, by_facets(hull, {}), 1e-7);
    }
  }
}

TEST_CASE("Task ellipsoid: with any axes and centre it is the first that one of Qhull's facets meets") {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    WrenchEllipsoid task;
    for (double& x : task.half_axes) x = random.uniform(0.0, 2.0);
    for (double& x : task.centre) x = random.uniform(-1.0, 1.0);
    check_same(wrench_space(random_grasp(random, 3 + i % 2, 0.8, 0.2), 6, ForceBound::kSum), task, 1e-12);
  }
}

TEST_SUITE_END();
