#include "preshape/base/error.h"
#include "preshape/fuzzy/partition.h"
#include "preshape/fuzzy/pattern.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/fuzzy");

namespace {

Value set_value(const char* name, const char* shape, std::vector<double> points) {
  return Value::table({{"name", name}, {shape, Value::numbers(points)}});
}

}  // namespace

TEST_CASE("Partition: the thesis's sets cover the line, each point in one set wholly or in two in part") {
  const auto partition = FuzzyPartition::thesis();
  REQUIRE(partition.size() == 7);
  for (double x = -3; x <= 3; x += 0.001) {
    std::vector<double> degrees(7);
    partition.fuzzify(x, degrees);
    int members = 0;
    for (const double degree : degrees) members += degree > 0;
    CHECK_MESSAGE((members == 1 || members == 2), x);
  }
}

TEST_CASE("Partition: the degrees of figure 3.19 come out") {
  const auto partition = FuzzyPartition::thesis();
  const Patterns task(partition, {1.14, 1.02, 0.10, 0.06, 0.79, 0.08});
  const double* m = task.view().memberships;
  const auto degree = [&](int row, int set) { return m[row * 7 + set]; };
  CHECK(degree(0, 6) == 1.0);
  CHECK_NEAR(degree(2, 3), 0.5, 1e-12);
  CHECK_NEAR(degree(2, 4), 0.5, 1e-12);
  CHECK_NEAR(degree(3, 3), 0.9, 1e-12);
  CHECK_NEAR(degree(4, 6), 0.2667, 1e-4);
  CHECK_NEAR(degree(5, 3), 0.7, 1e-12);
}

TEST_CASE("Partition: symbols name their own middle") {
  const auto partition = FuzzyPartition::thesis();
  for (int i = 0; i < partition.size(); ++i) CHECK(partition.best(partition[i].top_middle()) == i);
}

TEST_CASE("Partition: sets are read from a script's table, the outer two as shoulders") {
  const auto partition = FuzzyPartition::from_value(Value::list(
      {set_value("low", "trapezoid", {-1, -1, -0.5, 0}), set_value("mid", "gaussian", {0, 0.3}),
       set_value("high", "triangle", {0, 1, 2})}));
  CHECK(partition.size() == 3);
  CHECK(partition[0](-50) == 1.0);
  CHECK(partition[2](50) == 1.0);
  CHECK(partition[1](50) < 1e-12);
}

TEST_CASE("Partition: wrong counts, wrong order, unknown keys and double names are each told") {
  const auto mistakes = FuzzyPartition::check(Value::list(
      {set_value("a", "trapezoid", {0, 1, 2}).at({"s.lua", 3}), set_value("b", "triangle", {2, 1, 0}),
       set_value("c", "trapezium", {0, 1, 2, 3}), set_value("b", "gaussian", {0, 1})}));
  REQUIRE(mistakes.size() == 5);
  CHECK(mistakes[0].sentence.find("needs 4 numbers") != std::string::npos);
  CHECK(mistakes[1].sentence.find("a <= b <= c") != std::string::npos);
  CHECK(mistakes[2].sentence.find("did you mean 'trapezoid'?") != std::string::npos);
  CHECK(mistakes[3].sentence.find("has no shape") != std::string::npos);
  CHECK(mistakes[4].sentence.find("'b' is named twice") != std::string::npos);
  CHECK_THROWS_SAYING(FuzzyPartition::from_value(Value::list({})), InputError, "expected a list of sets");
}

TEST_SUITE_END();
