#include <cmath>
#include <limits>

#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

TEST_CASE("Result: every kind of data arrives as itself") {
  const Value v = run_text("return { b = true, i = 3, x = 0.5, whole = 3.0, t = 'text\\0end', none = nil }");
  CHECK(v.keys() == std::vector<std::string>{"b", "i", "t", "whole", "x"});
  CHECK(v.find("b")->boolean());
  CHECK(*v.find("i") == Value(3));
  CHECK(*v.find("whole") == Value(3.0));
  CHECK(v.find("x")->number() == 0.5);
  CHECK(v.find("t")->string() == std::string("text\0end", 8));
}

TEST_CASE("Result: not-a-number and infinity are numbers here, for the schema to judge") {
  const Value v = run_text("return { 0/0, math.huge, -math.huge }");
  CHECK(std::isnan(v.items()[0].number()));
  CHECK(v.items()[1].number() == std::numeric_limits<double>::infinity());
  CHECK(v.items()[2].number() == -std::numeric_limits<double>::infinity());
}

TEST_CASE("Result: the keys 1..n make a list, names a table, nothing an empty list") {
  const Value v = run_text(
      "return { list = { 1, 2, 3 }, table = { a = 1 }, empty = {}, by_key = { [2] = 'b', [1] = 'a' } }");
  CHECK(v.find("list")->items().size() == 3);
  CHECK(v.find("table")->is_table());
  CHECK((v.find("empty")->is_list() && v.find("empty")->items().empty()));
  CHECK(v.find("by_key")->items()[1].string() == "b");
}

TEST_CASE("Result: one text before named keys is the name of a component") {
  const Value v = run_text("return { contact = { 'salisbury_soft_finger', ka = 0.45 } }");
  CHECK(v.find("contact")->text() == "{ ka = 0.45, name = \"salisbury_soft_finger\" }");
}

TEST_CASE("Result: a table that is neither list nor table nor component is refused with its line") {
  CHECK(error_of("return {\n  a = { 1, k = 2 } }") ==
        "scenario.lua:2: 'a': a table has either positions or names ('k'), or one text before the names");
  CHECK(error_of("return { a = { 'x', 'y', k = 2 } }").find("either positions or names") !=
        std::string::npos);
  CHECK(error_of("return { a = { 'x', name = 'y' } }").find("the name is given twice") != std::string::npos);
  CHECK(error_of("return { [2.5] = 1 }").find("got a number 2.5") != std::string::npos);
  CHECK(error_of("return { [0] = 1 }").find("got a number 0") != std::string::npos);
  CHECK(error_of("return { [true] = 1 }").find("got a boolean") != std::string::npos);
  CHECK(error_of("return { list = { 1, nil, 3 } }") ==
        "scenario.lua:1: 'list': the list has no item 2 but an item 3");
}

TEST_CASE("Result: what is not data is refused with its key and line") {
  CHECK(error_of("return {\n  a = {\n    b = coroutine.create(print) } }") ==
        "scenario.lua:3: 'a.b': a thread is not data");
  CHECK(error_of("return { 1, coroutine.create(print) }") == "scenario.lua:1: '[2]': a thread is not data");
}

TEST_CASE("Result: a table that contains itself is an error, one that stands twice is not") {
  CHECK(error_of("local s = {}\ns.inner = { s }\nreturn s") ==
        "scenario.lua:2: 'inner[1]': the table contains itself");
  CHECK(run_text("local t = { 1 } return { t, t }").text() == "{ { 1 }, { 1 } }");
}

TEST_CASE("Result: tables in tables without end, or many times over, are refused and not a hang") {
  CHECK(error_of("local t = {} for i = 1, 200 do t = { t } end return t").find("more than 100 deep") !=
        std::string::npos);
  CHECK(
      error_of("local t = {} for i = 1, 40 do t = { t, t } end return t").find("more than 2000000 values") !=
      std::string::npos);
}

TEST_CASE("Result: a script that returns nothing gives nil, one that returns two things the first") {
  CHECK(run_text("local x = 1").is_nil());
  CHECK(run_text("return 1, 2") == Value(1));
}

TEST_CASE("Function: one inside the result can be called, with data both ways") {
  Script script =
      Script::from_text("return { add = function(t, k) return { sum = t.a + t.b[k] } end }", "s.lua");
  const auto add = script.run().find("add")->function();
  Value t;
  t.set("a", 1), t.set("b", Value::numbers({10, 20}));
  CHECK(script.call(add, std::vector<Value>{t, 2}).text() == "{ sum = 21 }");
  CHECK(script.call(add, std::vector<Value>{t, 1}).text() == "{ sum = 11 }");
}

TEST_CASE("Function: the same function is the same value, and comes back as itself") {
  Script script = Script::from_text(
      "local f = function() return 7 end return { f, f, function(g) return g() end }", "s.lua");
  const Value v = script.run();
  CHECK(v.items()[0] == v.items()[1]);
  CHECK(script.call(v.items()[2].function(), std::vector<Value>{v.items()[0]}) == Value(7));
}

TEST_CASE("Function: a number that no function of the script has is refused") {
  Script script = Script::from_text("return 1", "s.lua");
  script.run();
  CHECK_THROWS_SAYING(script.call({5}, {}), ScriptError, "another script");
}

TEST_CASE("Argument: whole and broken numbers keep their kind on the way into the script") {
  Script script =
      Script::from_text("return function(...) return { kinds = string.format('%s %s', ...) } end", "s.lua");
  const auto kinds = script.run().function();
  CHECK(script.call(kinds, std::vector<Value>{3, 3.0}).find("kinds")->string() == "3 3.0");
}

TEST_SUITE_END();
