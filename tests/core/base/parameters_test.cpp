#include <cmath>

#include "preshape/base/error.h"
#include "preshape/base/parameters.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/base");

namespace {

ParameterSchema schema() {
  return {"contact 'soft'",
          {ParameterDeclaration::number("mu", 1.0, 0.0, 10.0, "1", "friction coefficient"),
           ParameterDeclaration::integer("edges", 8, 3, 64, "1", "cone edges"),
           ParameterDeclaration::choice("law", "coulomb", {"coulomb", "viscous"}, "friction law"),
           ParameterDeclaration::flag("strict", true, "refuse doubtful input"),
           ParameterDeclaration::list("weights", {1.0, 2.0}, 0.0, 5.0, "1", "weights")}};
}

std::string mistake(const char* key, Value value) {
  const auto mistakes = schema().check(Value::table({{key, std::move(value).at({"s.lua", 4})}}));
  REQUIRE(mistakes.size() == 1);
  return mistakes.front().text();
}

}  // namespace

TEST_CASE("Parameters: what is not given takes its default, what is given stays") {
  const Parameters p = schema().resolve(Value::table({{"mu", 0.5}}));
  CHECK(p.number("mu") == 0.5);
  CHECK(p.integer("edges") == 8);
  CHECK(p.text("law") == "coulomb");
  CHECK(p.flag("strict"));
  CHECK(p.numbers("weights") == std::vector<double>{1.0, 2.0});
}

TEST_CASE("Parameters: a misspelt key is told with file, line and the nearest right key") {
  CHECK(mistake("edgse", 3) == "s.lua:4: contact 'soft': unknown key 'edgse'; did you mean 'edges'?");
}

TEST_CASE("Parameters: a key like nothing known lists what is known") {
  CHECK(mistake("zzzzzz", 3).find("known: mu, edges, law, strict, weights") != std::string::npos);
}

TEST_CASE("Parameters: wrong type, bounds, fraction for a count, NaN and unknown choice are each refused") {
  CHECK(mistake("mu", "high").find("'mu' must be a number, got string \"high\"") != std::string::npos);
  CHECK(mistake("mu", -0.1).find("'mu' must be in 0 .. 10, got -0.1") != std::string::npos);
  CHECK(mistake("edges", 3.5).find("'edges' must be a whole number, got 3.5") != std::string::npos);
  CHECK(mistake("mu", std::nan("")).find("NaN") != std::string::npos);
  CHECK(mistake("law", "coulom").find("did you mean 'coulomb'?") != std::string::npos);
  CHECK(mistake("weights", Value::numbers({1.0, 9.0})).find("element 2 must be in 0 .. 5") != std::string::npos);
}

TEST_CASE("Parameters: check names every mistake at once, resolve throws the first") {
  const Value given = Value::table({{"mu", -1.0}, {"edges", 1}, {"lew", "coulomb"}});
  CHECK(schema().check(given).size() == 3);
  CHECK_THROWS_SAYING(schema().resolve(given), InputError, "edges");
}

TEST_CASE("Parameters: a whole number written as 3.0 is accepted for a count") {
  CHECK(schema().resolve(Value::table({{"edges", 4.0}})).integer("edges") == 4);
}

TEST_SUITE_END();
