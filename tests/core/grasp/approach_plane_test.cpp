#include <Eigen/Geometry>

#include "preshape/base/error.h"
#include "preshape/grasp/approach_plane.h"
#include "support/near.h"

using namespace preshape;

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
