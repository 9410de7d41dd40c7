#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/grasp/approach_plane.h"
#include "support/near.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/grasp");

TEST_CASE("Planes: the twelve are all pairs of different axes with both signs of opposition") {
  const auto planes = thesis_planes();
  REQUIRE(planes.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    CHECK(planes[i].a.minCoeff() == 0.0);  // always towards +
    CHECK(planes[i].a.dot(planes[i].n_f) == 0.0);
    CHECK(planes[i].transverse.cwiseProduct(planes[i].a + planes[i].n_f).isZero());
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE((planes[k].a == planes[i].a && planes[k].n_f == planes[i].n_f));
  }
  CHECK(planes[0].text() == "approach +X, forefingers push -Y");
  CHECK(planes[11].text() == "approach +Z, forefingers push -X");
}

TEST_CASE("Planes: a script gives them as axes or vectors, in any number") {
  const Value one = Value::table({{"approach", "-Z"}, {"push", "+X"}});
  const Value two = Value::table({{"approach", Value::numbers({1, 1, 0})}, {"push", Value::numbers({1, -1, 0})}});
  const auto planes = planes_from_value(Value::list({one, two}));
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].a == Eigen::Vector3d(0, 0, -1));
  CHECK_NEAR(planes[1].a.norm(), 1.0, 1e-15);
  CHECK_NEAR(planes[1].transverse.cwiseAbs(), Eigen::Vector3d(0, 0, 1), 1e-15);
}

TEST_CASE("Sampled planes: the directions leave no hole and lie nowhere denser than twice the mean, the rolls turn evenly") {
  for (const int count : {1, 7, 60, 500}) {
    const auto planes = sampled_planes(count, 6);
    REQUIRE(planes.size() == static_cast<std::size_t>(6 * count));
    std::vector<Eigen::Vector3d> directions;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const ApproachPlane& plane = planes[i];
      CHECK_NEAR(plane.a.norm(), 1.0, 1e-14);
      CHECK_NEAR(plane.a.dot(plane.n_f), 0.0, 1e-14);
      CHECK(std::abs(plane.transverse.dot(plane.n_f.cross(plane.a))) > 1.0 - 1e-12);
      if (i % 6 == 0) directions.push_back(plane.a);
      else CHECK(plane.a == directions.back());
    }
    for (std::size_t i = 0; i < planes.size(); i += 6) {  // 60 degrees apart: the six add up to nothing
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t k = i; k < i + 6; ++k) sum += planes[k].n_f;
      CHECK_NEAR(sum, Eigen::Vector3d::Zero(), 1e-13);
    }
    if (count == 1) continue;
    // A cap of the mean area has the angle 2 / sqrt(N): no direction is nearer to another than half of it, and no point
    // of the sphere farther from all than twice.
    const double mean = 2.0 / std::sqrt(count);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) CHECK(std::acos(std::clamp(directions[i].dot(directions[k]), -1.0, 1.0)) > 0.5 * mean);
    }
    Random random(5);
    for (int trial = 0; trial < 300; ++trial) {
      const Eigen::Vector3d point = random_unit(random);
      double nearest = 10.0;
      for (const auto& a : directions) nearest = std::min(nearest, std::acos(std::clamp(a.dot(point), -1.0, 1.0)));
      CHECK(nearest < 2.0 * mean);
    }
  }
}

TEST_CASE("Sampled planes: the first quarter is spread over the whole sphere, so that a search that ends early saw all sides") {
  const auto planes = sampled_planes(240, 1);
  Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Vector3d point = random_unit(random);
    double nearest = 10.0;
    for (std::size_t i = 0; i < 60; ++i) nearest = std::min(nearest, std::acos(std::clamp(planes[i].a.dot(point), -1.0, 1.0)));
    CHECK(nearest < 3.0 * 2.0 / std::sqrt(60.0));
  }
}

TEST_CASE("Sampled planes: a script says how many, and the thesis's twelve stand first unless it does not want them") {
  const auto both = planes_from_value(Value::table({{"directions", 5}, {"rolls", 3}}));
  REQUIRE(both.size() == 12 + 15);
  for (std::size_t i = 0; i < 12; ++i) CHECK(both[i].a == thesis_planes()[i].a);
  CHECK(planes_from_value(Value::table({{"directions", 5}, {"rolls", 3}, {"thesis", false}})).size() == 15);
  CHECK(check_planes(Value::table({{"direction", 5}})).front().sentence.find("did you mean 'directions'?") != std::string::npos);
  CHECK_THROWS_SAYING(planes_from_value(Value::table({{"directions", 0}})), InputError, "'directions' must be in 1 ..");
  CHECK_THROWS_SAYING(sampled_planes(0, 1), InputError, "at least one direction");
}

TEST_CASE("Planes: oblique, zero, unknown and incomplete ones are each told with their place") {
  const auto wrong = [](Value::Table entries) {
    const auto mistakes = check_planes(Value::list({Value::table(std::move(entries)).at({"s.lua", 7})}));
    return mistakes.empty() ? std::string() : mistakes.front().text();
  };
  CHECK(wrong({{"approach", "+X"}, {"push", "+X"}}) == "s.lua:7: planes: the approach axis and the push axis of a plane must be at right angles");
  CHECK(wrong({{"approach", "+W"}, {"push", "+X"}}).find("'+W' is no axis") != std::string::npos);
  CHECK(wrong({{"approach", "+X"}}).find("needs both") != std::string::npos);
  CHECK(wrong({{"approach", "+X"}, {"push", "+Y"}, {"pusj", "+Y"}}).find("did you mean 'push'?") != std::string::npos);
  CHECK(wrong({{"approach", Value::numbers({0, 0, 0})}, {"push", "+Y"}}).find("not zero") != std::string::npos);
  CHECK_THROWS_SAYING(planes_from_value(Value("all")), InputError, "expected a list of planes");
}

TEST_SUITE_END();
