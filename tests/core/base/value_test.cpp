#include "preshape/base/value.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/base");

TEST_CASE("Value: tables keep their keys sorted whatever the order of setting") {
  Value a, b;
  a.set("x", 1), a.set("b", 2), a.set("m", 3);
  b.set("m", 3), b.set("x", 1), b.set("b", 2);
  CHECK(a == b);
  CHECK(a.keys() == std::vector<std::string>{"b", "m", "x"});
}

TEST_CASE("Value: setting a key again replaces it, erasing removes it") {
  Value a;
  a.set("x", 1), a.set("x", "two");
  CHECK(a.entries().size() == 1);
  CHECK(a.find("x")->string() == "two");
  a.erase("x");
  CHECK(a.find("x") == nullptr);
}

TEST_CASE("Value: text is what a person would write in Lua") {
  Value a;
  a.set("name", "mug"), a.set("fit", 0.1), a.set("n", 3), a.set("on", true);
  a.set("t", Value::numbers({1.0, 0.5}));
  CHECK(a.text() == "{ fit = 0.1, n = 3, name = \"mug\", on = true, t = { 1, 0.5 } }");
}

TEST_CASE("Value: numbers print as the shortest text that reads back the same") {
  for (const double x : {0.1, 1.0 / 3.0, 1e-300, 123456789.125}) CHECK(std::stod(number_text(x)) == x);
  CHECK(number_text(0.1) == "0.1");
}

TEST_SUITE_END();
