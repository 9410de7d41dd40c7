#include <Eigen/SVD>

#include "components.h"
#include "preshape/base/error.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

/// A grasp of three contacts with a random wrench union.
struct Grasp {
  explicit Grasp(std::uint64_t seed, Eigen::Index rows = 12) {
    Random random(seed);
    for (int i = 0; i < 3; ++i) {
      contacts.push_back(ContactFrame::at(random_vector(random), random_unit(random), random_unit(random)));
      wrenches.push_back(random_wrench(random));
      resultant += wrenches.back();
    }
    rows_of.resize(rows, 6);
    for (Eigen::Index i = 0; i < rows; ++i) rows_of.row(i) = random_wrench(random).vector().transpose();
  }
  GraspView view() const { return {contacts, wrenches, rows_of, resultant, 0.18}; }

  std::vector<ContactFrame> contacts;
  std::vector<Wrench> wrenches;
  WrenchUnion rows_of;
  Wrench resultant;
};

std::vector<double> values(const QualityMeasure& measure, const GraspView& grasp) {
  std::vector<double> numbers(measure.numbers().size());
  measure.evaluate(grasp, numbers);
  return numbers;
}

std::string failing(const std::string& inside) {
  const OneComponent component("quality", "x", inside);
  try {
    values(*component->create<QualityMeasure>("x"), Grasp(1).view());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua quality: grasp_isotropy is the ratio of the extreme singular values") {
  const auto isotropy = registry().create<QualityMeasure>("grasp_isotropy");
  CHECK(isotropy->numbers()[0].name == "isotropy");
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Grasp grasp(seed);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(grasp.rows_of);
    const auto& sigma = svd.singularValues();
    CHECK_NEAR(values(*isotropy, grasp.view())[0], sigma[5] / sigma[0], 1e-12);
  }
  CHECK(values(*isotropy, Grasp(1, 5).view())[0] == 0.0);  // five wrenches leave a motion free
  CHECK(values(*isotropy, Grasp(1, 0).view())[0] == 0.0);
}

TEST_CASE("Lua quality: the script sees contacts, wrenches, union, resultant and length") {
  const OneComponent component("quality", "x",
                               "return { numbers = { { name = 'sum', lowest = -1e9, highest = 1e9 }, { name = 'second', unit = 'm', lowest = 0, highest = 1, higher_is_better = false } },\n"
                               "evaluate = function(g)\n"
                               "  local last = g.wrench_union[#g.wrench_union]\n"
                               "  return g.contacts[2].p[3] + 10 * g.contacts[3].t[1] + 100 * g.wrenches[2][5] + 1e3 * last[6] + 1e4 * g.resultant[4] + #g.contacts, g.length\n"
                               "end }");
  const Grasp g(4);
  const auto measure = component->create<QualityMeasure>("x");
  REQUIRE(measure->numbers().size() == 2);
  CHECK(measure->numbers()[1].unit == "m");
  CHECK_FALSE(measure->numbers()[1].higher_is_better);
  const auto numbers = values(*measure, g.view());
  const double expected = g.contacts[1].p_OC.z() + 10 * g.contacts[2].t.x() + 100 * g.wrenches[1].moment().y() +
                          1e3 * g.rows_of(11, 5) + 1e4 * g.resultant.moment().x() + 3;
  CHECK_NEAR(numbers[0], expected, 1e-9);
  CHECK(numbers[1] == 0.18);
  std::vector<double> one(1);
  CHECK_THROWS_SAYING(measure->evaluate(g.view(), one), InputError, "values: expected 2 entries, got 1");
}

TEST_CASE("Lua quality: wrong keys and values are errors with file and line") {
  const std::string number = "numbers = { { name = 'a', lowest = 0, highest = 1 } },";
  CHECK(failing("return { " + number + "\n evaluate = function() return 2 end }").find("x.plugin.lua:5: quality 'x': 'evaluate' must return 'a' in 0 .. 1, got 2 for the grasp of 3 contacts with resultant (") != std::string::npos);
  CHECK(failing("return { " + number + " evaluate = function() end }").find("'evaluate' must return a list of 1 finite numbers, got nil") != std::string::npos);
  CHECK(failing("return { " + number + " evaluate = function() return { 1 } end }").empty());
  CHECK(failing("return { numbers = {}, evaluate = print }").find("'numbers' must be a list of at least one number's table") != std::string::npos);
  CHECK(failing("return { numbers = { { name = 'a', lowest = 1, highest = 1 } }, evaluate = print }").ends_with("quality 'x', number 1: 'lowest' must be below 'highest'"));
  CHECK(failing("return { numbers = { { nam = 'a', lowest = 0, highest = 1 } }, evaluate = print }").find("x.plugin.lua:4: quality 'x', number 1: unknown key 'nam'; did you mean 'name'?") != std::string::npos);
}

TEST_SUITE_END();
