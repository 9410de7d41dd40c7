// Similarities of the crisp vectors: angles and distances that are known.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "preshape/spatial/screw.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/similarity");

namespace {

using Vector = std::array<double, 6>;
using std::numbers::pi;

const std::vector<double> kNaN(6 * 7, std::numeric_limits<double>::quiet_NaN()), kZero(6 * 7, 0.0);

/// Memberships are not looked at: NaN, unless the binding to Lua looks.
PatternView view(const Vector& v, const std::vector<double>& memberships = kNaN) {
  return {1, 7, v.data(), memberships.data()};
}

double score(const Similarity& measure, const Vector& q, const Vector& w,
             const std::vector<double>& memberships = kNaN) {
  double value = -1.0;
  measure.compare(view(q, memberships), view(w, memberships), {&value, 1});
  return value;
}

double score(const char* name, const Vector& q, const Vector& w, Value::Table parameters = {}) {
  return score(*registry().create<Similarity>(name, Value::table(std::move(parameters))), q, w);
}

Vector numbers(const Wrench& W) {
  Vector v;
  for (int k = 0; k < 6; ++k) v[static_cast<std::size_t>(k)] = W.vector()[k];
  return v;
}

Vector times(double factor, Vector v) {
  for (double& x : v) x *= factor;
  return v;
}

const Vector kNone{}, kX = {1, 0, 0, 0, 0, 0}, kXY = {1, 1, 0, 0, 0, 0};

}  // namespace

TEST_CASE("Cosine in C++: the same numbers as the component in Lua, for any sharpness") {
  Random random(1);
  for (const double sharpness : {0.5, 1.0, 3.0}) {
    const Value given = Value::table({{"sharpness", sharpness}});
    const auto crisp = registry().create<Similarity>("cosine_crisp", given),
               lua = registry().create<Similarity>("cosine", given);
    for (int i = 0; i < 200; ++i) {
      const Vector q = numbers(random_wrench(random)), w = numbers(random_wrench(random));
      CHECK_NEAR(score(*crisp, q, w), score(*lua, q, w, kZero), 1e-14);
    }
    for (const auto& [q, w] : {std::pair(kNone, kX), std::pair(kNone, kNone), std::pair(kX, times(-1, kX))}) {
      CHECK(score(*crisp, q, w) == score(*lua, q, w, kZero));
    }
  }
}

TEST_CASE("Cosine in C++: known angles, and vectors of any length that a number can tell") {
  CHECK_NEAR(score("cosine_crisp", kX, kXY), 0.5 + 0.25 * std::sqrt(2.0), 1e-15);
  for (const double factor : {1e-300, 1e-160, 1e160, 1e300}) {
    CHECK_NEAR(score("cosine_crisp", times(factor, kX), times(factor, kXY)), 0.5 + 0.25 * std::sqrt(2.0),
               1e-15);
  }
}

TEST_CASE("Screw angle: known angles between forces, couples and both") {
  CHECK(score("screw_angle", kX, times(3, kX)) == 0.0);
  CHECK_NEAR(score("screw_angle", kX, times(-2, kX)), pi, 1e-15);
  CHECK_NEAR(score("screw_angle", kX, kXY), pi / 4, 1e-15);
  CHECK_NEAR(score("screw_angle", kX, {0, 0, 0, 1, 0, 0}), pi / 2, 1e-15);
  CHECK_NEAR(score("screw_angle", {1, 0, 0, 1, 0, 0}, {1, 0, 0, -1, 0, 0}), pi / 2, 1e-15);
  // Moments weigh the square root of 3 times: vectors at 60 degrees from the force.
  CHECK_NEAR(score("screw_angle", kX, {1, 0, 0, 1, 0, 0}, {{"moment", std::sqrt(3.0)}}), pi / 3, 1e-15);
}

TEST_CASE("Screw angle: small angles are told to their last digits, where an arc cosine gives none") {
  for (const double angle : {1e-3, 1e-9, 1e-15, 1e-30}) {
    CHECK_NEAR(score("screw_angle", kX, {1, angle, 0, 0, 0, 0}) / std::atan(angle), 1.0,
               angle > 1e-12 ? 1e-6 : 1e-15);
  }
}

TEST_CASE("Screw angle: without moments it is the angle between the axes that Poinsot's reduction gives") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Wrench q = random_wrench(random), w = random_wrench(random);
    const double cosine = poinsot_reduce(q).direction.dot(poinsot_reduce(w).direction);
    // Compared as cosines: that is where the reduction's rounding is.
    CHECK_NEAR(std::cos(score("screw_angle", numbers(q), numbers(w), {{"moment", 0.0}})), cosine, 1e-14);
    const double couples = q.moment().normalized().dot(w.moment().normalized());
    CHECK_NEAR(std::cos(score("screw_angle", numbers(q), numbers(w), {{"force", 0.0}})), couples, 1e-14);
  }
}

TEST_CASE("Screw angle: at equal weights turning both screws changes nothing") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Wrench q = random_wrench(random), w = random_wrench(random);
    const Eigen::Matrix3d R = random_rotation(random);
    CHECK_NEAR(score("screw_angle", numbers(q.rotated(R)), numbers(w.rotated(R))),
               score("screw_angle", numbers(q), numbers(w)), 1e-13);
  }
}

TEST_CASE("Screw angle: what the weights leave without length is at a right angle to all but its like") {
  CHECK_NEAR(score("screw_angle", kNone, kX), pi / 2, 1e-15);
  CHECK(score("screw_angle", kNone, kNone) == 0.0);
  CHECK_NEAR(score("screw_angle", {0, 0, 0, 1, 0, 0}, kX, {{"moment", 0.0}}), pi / 2, 1e-15);
  CHECK_THROWS_SAYING(score("screw_angle", kX, kX, {{"force", 0.0}, {"moment", 0.0}}), InputError,
                      "force and moment are both 0");
}

TEST_CASE("Task distance: 3, 4, 12 are 13 apart, which is 13/14 of the scale, or a half where half is 13") {
  const Vector w = {3, 0, 4, 0, 0, 12};
  CHECK_NEAR(score("task_distance", kNone, w), 13.0 / 14.0, 1e-15);
  CHECK_NEAR(score("task_distance", kNone, w, {{"half", 13.0}}), 0.5, 1e-15);
  CHECK(score("task_distance", w, w) == 0.0);
}

TEST_CASE("Task distance: each component counts by its own weight, one of weight 0 not at all") {
  const std::vector<double> weights = {1, 2, 3, 4, 5, 6};
  for (std::size_t k = 0; k < 6; ++k) {
    Vector w{};
    w[k] = -0.5;
    const double d = 0.5 * weights[k];
    CHECK_NEAR(score("task_distance", kNone, w, {{"weights", Value::numbers(weights)}}), d / (1 + d), 1e-15);
  }
  CHECK(score("task_distance", kX, times(9, kX), {{"weights", Value::numbers({0, 1, 1, 1, 1, 1})}}) == 0.0);
  CHECK_THROWS_SAYING(score("task_distance", kX, kX, {{"weights", Value::numbers({1, 1, 1})}}), InputError,
                      "weights: expected 6 entries, got 3");
}

TEST_CASE("Task distance: its order is that of the distances, however far") {
  double before = -1.0;
  for (double d = 1e-12; d < 1e12; d *= 10) {
    const double now = score("task_distance", kNone, times(d, kX));
    CHECK(now > before);
    CHECK(now < 1.0);
    before = now;
  }
  CHECK(score("task_distance", times(-1e308, kX), times(1e308, kX)) == 1.0);
}

TEST_CASE("Similarities of crisp vectors: a component's score is that of this component alone") {
  for (const char* name : {"cosine_crisp", "screw_angle", "task_distance"}) {
    const auto measure = registry().create<Similarity>(name);
    const Vector q = {1, -2, 0, 3, 0.5, 0}, w = {-1, -1, 0, 2, 0, 4};
    Vector parts;
    measure->component_scores(view(q), view(w), parts);
    for (std::size_t k = 0; k < 6; ++k) {
      Vector qk{}, wk{};
      qk[k] = q[k], wk[k] = w[k];
      INFO(name, ", component ", k + 1);
      CHECK(parts[k] == score(*measure, qk, wk));
    }
  }
}

TEST_CASE("Similarities of crisp vectors refuse what is not finite") {
  const Vector bad = {0, 0, std::numeric_limits<double>::infinity(), 0, 0, 0};
  for (const char* name : {"cosine_crisp", "screw_angle", "task_distance"}) {
    CHECK_THROWS_SAYING(score(name, kX, bad), InputError, "a component is not finite");
    CHECK_THROWS_SAYING(score(name, bad, kX), InputError, "a component is not finite");
  }
}

TEST_SUITE_END();
