#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

namespace {

std::string error_with_plan(const std::string& text) {
  Script script = Script::from_text(text, "scenario.lua");
  script.add_function("plan", "(t: table): table", "plans", [](auto, const auto&) { return Value(1); });
  script.add_constant("version", "the version", "0.1.0");
  try {
    script.run();
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("Strict: an unknown global is an error with the nearest known one") {
  CHECK(error_of("\nlocal x = maht.pi") == "scenario.lua:2: unknown global 'maht'; did you mean 'math'?");
  CHECK(error_of("return conatct") ==
        "scenario.lua:1: unknown global 'conatct'; a variable is made with 'local'");
}

TEST_CASE("Strict: setting a global is an error") {
  CHECK(error_of("\nx = 1") == "scenario.lua:2: global 'x' cannot be set; write 'local x'");
  CHECK(error_of("function f() end").find("global 'f' cannot be set") != std::string::npos);
  CHECK(error_of("print = 1").find("global 'print' cannot be set") != std::string::npos);
}

TEST_CASE("Strict: a misspelt name of a module is an error with the nearest right one") {
  CHECK(error_with_plan("\npreshape.paln({})") ==
        "scenario.lua:2: preshape: unknown name 'paln'; did you mean 'plan'?");
  CHECK(error_with_plan("return preshape.zzz") ==
        "scenario.lua:1: preshape: unknown name 'zzz'; known: plan, version");
  CHECK(error_of("return math.sine(1)").find("math: unknown name 'sine'; did you mean 'sin'?") !=
        std::string::npos);
  CHECK(error_of("return string.fromat('x')").find("did you mean 'format'?") != std::string::npos);
  CHECK(error_of("return table.isnert").find("did you mean 'insert'?") != std::string::npos);
  CHECK(error_of("return ('x'):uper()").find("string: unknown name 'uper'; did you mean 'upper'?") !=
        std::string::npos);
}

TEST_CASE("Strict: modules are read-only by every way there is") {
  CHECK(error_with_plan("preshape.plan = 1") ==
        "scenario.lua:1: preshape: 'plan' cannot be set, the module is read-only");
  CHECK(error_of("math.pi = 3").find("math: 'pi' cannot be set") != std::string::npos);
  CHECK(error_of("rawset(math, 'pi', 3)").find("rawset: the table is read-only") != std::string::npos);
  CHECK(error_of("rawset(_G, 'x', 3)").find("rawset: the table is read-only") != std::string::npos);
  CHECK(error_of("table.insert(preshape, 3)").find("read-only") != std::string::npos);
  CHECK(error_of("setmetatable(preshape, {})").find("cannot change a protected metatable") !=
        std::string::npos);
  CHECK(error_of("setmetatable(_G, nil)").find("cannot change a protected metatable") != std::string::npos);
  CHECK(run_text("return { getmetatable(preshape), getmetatable(''), getmetatable(_G) }").text() ==
        "{ false, false, false }");
  CHECK(run_text("local t = setmetatable({}, {}) rawset(t, 'x', 3) return t.x") == Value(3));
}

TEST_CASE("Strict: what scripts know is there and is what it should be") {
  const Value v = run_text(R"(
    local names = {}
    for name in pairs(_G) do names[#names + 1] = name end
    return names)");
  std::string names;
  for (const auto& name : v.items()) names += name.string() + " ";
  CHECK(
      names ==
      "_G _VERSION __place assert collectgarbage coroutine error getmetatable ipairs load math next pairs "
      "pcall preshape print rawequal rawget rawlen rawset require select setmetatable string table tonumber "
      "tostring type utf8 xpcall ");
}

TEST_CASE("Strict: the libraries work as in Lua") {
  CHECK(run_text("return ('%d|%s|%q|%%|%5.1f'):format(3, 'a', 'b', 0.25)").string() == "3|a|\"b\"|%|  0.2");
  CHECK(run_text("local t = { 3, 1, 2 } table.sort(t) return table.concat(t, ',')").string() == "1,2,3");
  CHECK(run_text("return utf8.len('grün') + #utf8.char(228)") == Value(6));
  CHECK(run_text("local f = coroutine.wrap(function(a) local b = coroutine.yield(a + 1) return b * 2 end) "
                 "return { f(1), f(5) }")
            .text() == "{ 2, 10 }");
  CHECK(run_text("return load('return ...', 'x')(7)") == Value(7));
  CHECK(run_text("return load('return y', 'x', 't', { y = 8 })()") == Value(8));
  CHECK(run_text("local ok, message = pcall(error, 'x') return { ok, message }").text() ==
        "{ false, \"x\" }");
  CHECK(
      run_text("return { select('#', 1, 2), tonumber('0x10'), type(nil), rawlen({ 1 }), next({}) }").text() ==
      "{ 2, 16, \"nil\", 1 }");
}

TEST_CASE("Strict: print goes to the host, one line a call") {
  std::string printed;
  ScriptOptions options;
  options.print = [&](std::string_view line) { printed += std::string(line) + "\n"; };
  run_text("print('a', 1, nil, true, 0.5) print() print({}, print)", options);
  CHECK(printed == "a\t1\tnil\ttrue\t0.5\n\ntable\tfunction\n");
}

TEST_SUITE_END();
