#include <cmath>
#include <limits>

#include "preshape/script/setting.h"
#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

namespace {

/// The table after the settings, as text.
std::string after(const std::string& scenario, const std::vector<std::string>& settings) {
  Value root = run_text("return " + scenario);
  for (const auto& text : settings) {
    const Setting setting = parse_setting(text);
    set_path(root, setting.key, setting.value);
  }
  return root.text();
}

std::string fault(const std::string& text) {
  try {
    parse_setting(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("Setting: a value is read as Lua writes it") {
  CHECK(parse_value("0.6") == Value(0.6));
  CHECK(parse_value(" -3 ") == Value(-3));
  CHECK(parse_value("0x10") == Value(16));
  CHECK(parse_value("true") == Value(true));
  CHECK(parse_value("nil").is_nil());
  CHECK(parse_value("\"a b\"") == Value("a b"));
  CHECK(parse_value("{ 1, 0.5 }").text() == "{ 1, 0.5 }");
  CHECK(parse_value("{ \"knn\", k = 3 }").text() == "{ k = 3, name = \"knn\" }");
  CHECK_NEAR(parse_value("30 * math.pi / 180").number(), 0.5235987755982988, kEps);
  CHECK_NEAR(parse_value("-math.pi/2").number(), -1.5707963267948966, kEps);
  CHECK_NEAR(parse_value("math.pi/2").number(), 1.5707963267948966, kEps);
}

TEST_CASE("Setting: a bare word or a file name is a text") {
  for (const char* word :
       {"knn", "soft_finger-2", "objects/mug/mug.obj", "./a.obj", "/tmp/x.y", "trueish", "größe", "-Z", "+X"}) {
    CHECK(parse_value(word) == Value(word));
  }
}

TEST_CASE("Setting: what cannot be read is told in one sentence") {
  CHECK(fault("contact.mu") == "--set contact.mu: expected KEY=VALUE, as contact.mu=0.6");
  CHECK(fault("contact.mu=") == "--set contact.mu=: a value is missing; write \"\" for an empty text");
  CHECK(fault("contact.mu=0.6.1") ==
        "--set contact.mu=0.6.1: '0.6.1' is no value (malformed number near '0.6.1')");
  CHECK(fault("a={1,") == "--set a={1,: '{1,' is no value (unexpected symbol near <eof>)");
  CHECK(fault("a=two words").find("'two words' is no value") != std::string::npos);
  CHECK(fault("a=print(1) x=2").find("is no value") != std::string::npos);
  CHECK(fault("a={ print }").find("a function can only be given in a script") != std::string::npos);
  CHECK(fault("a={os.exit()}").find("'os' is not there") != std::string::npos);
  CHECK(fault("a=(function() while true do end end)()").find("an endless loop?") != std::string::npos);
  for (const char* key : {"", ".a", "a.", "a..b", "a b", "a[1]"}) {
    CHECK(fault(std::string(key) + "=1").find("is no key; expected names with dots between") !=
          std::string::npos);
  }
}

TEST_CASE("Setting: sets, replaces, makes tables on the way, and takes away") {
  CHECK(after("{ a = 1 }", {"a=2"}) == "{ a = 2 }");
  CHECK(after("{}", {"a.b.c=2", "a.d=x"}) == "{ a = { b = { c = 2 }, d = \"x\" } }");
  CHECK(after("{ a = 1, b = { c = 2, d = 3 } }", {"a=nil", "b.c=nil", "b.x=nil"}) == "{ b = { d = 3 } }");
}

TEST_CASE("Setting: a component given by its name alone takes a parameter") {
  const std::string expected = "{ contact = { mu = 0.6, name = \"soft\" } }";
  CHECK(after("{ contact = 'soft' }", {"contact.mu=0.6"}) == expected);
  CHECK(after("{ contact = { 'soft' } }", {"contact.mu=0.6"}) == expected);
  CHECK(after("{ contact = { 'soft', mu = 1 } }", {"contact.mu=0.6"}) == expected);
  CHECK(after("{ contact = { 'soft', mu = 1 } }", {"contact=hard"}) == "{ contact = \"hard\" }");
}

TEST_CASE("Setting: a number picks an item of a list, one past the end appends") {
  CHECK(after("{ t = { { f = 1 }, { f = 2 } } }", {"t.2.f=5"}) == "{ t = { { f = 1 }, { f = 5 } } }");
  CHECK(after("{ t = { 1 } }", {"t.2=5"}) == "{ t = { 1, 5 } }");
  CHECK_THROWS_SAYING(after("{ t = { 1 } }", {"t.3=5"}), InputError,
                      "--set t.3: 't' is a list of 1, '3' picks none of them");
  CHECK_THROWS_SAYING(after("{ t = { 1 } }", {"t.x=5"}), InputError,
                      "'t' is a list of 1, 'x' picks none of them");
}

TEST_CASE("Setting: the way through a plain value is refused") {
  CHECK_THROWS_SAYING(after("{ a = { b = 1 } }", {"a.b.c=2"}), InputError,
                      "--set a.b.c: 'a.b' is a number and has no 'c'");
}

TEST_CASE("Setting: its place is the setting itself, so that a bad value is told with it") {
  const Setting setting = parse_setting("contact.weights={1, 2}");
  CHECK(setting.key == "contact.weights");
  CHECK(setting.value.place().text() == "--set contact.weights={1, 2}");
  CHECK(setting.value.items()[1].place().text() == "--set contact.weights={1, 2}");
}

TEST_CASE("Source: a value written as Lua reads back as the same value") {
  Value v;
  v.set("name", "a \"quoted\"\n\\ text\x7f"), v.set("n", 3), v.set("x", 3.0), v.set("tenth", 0.1);
  v.set("end", true), v.set("with space", -1e-300), v.set("huge", -std::numeric_limits<double>::infinity());
  v.set("least", std::numeric_limits<std::int64_t>::min()), v.set("t", Value::numbers({0.5, 1e300}));
  v.set("deep", Value::list({Value::table({{"k", Value::list({})}}), "x"}));
  CHECK(run_text("return " + lua_source(v)) == v);
  CHECK(std::isnan(run_text("return " + lua_source(std::nan(""))).number()));
  CHECK_THROWS_SAYING(lua_source(Value(Value::Function{1})), InputError, "a function cannot be written");
}

TEST_CASE("Source: one entry a line, lists of plain values in a row") {
  Value v;
  v.set("a", Value::numbers({1.0, 0.5})), v.set("b", Value::table({{"c", "x"}}));
  CHECK(lua_source(v) == "{\n  a = { 1.0, 0.5 },\n  b = {\n    c = \"x\",\n  },\n}");
}

TEST_SUITE_END();
