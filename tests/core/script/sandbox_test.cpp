#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

TEST_CASE("Sandbox: there is no way to files, processes, byte code or the insides of Lua") {
  CHECK(error_of("io.open('/etc/passwd')") ==
        "scenario.lua:1: 'io' is not there unless the script is trusted (--trust)");
  CHECK(error_of("os.execute('true')").find("'os' is not there unless") != std::string::npos);
  CHECK(error_of("package.loadlib('x', '*')").find("'package' is not there unless") != std::string::npos);
  CHECK(error_of("debug.getregistry()").find("'debug' is not there for scripts") != std::string::npos);
  CHECK(error_of("dofile('x')").find("'dofile' is not there") != std::string::npos);
  CHECK(error_of("loadfile('x')").find("'loadfile' is not there") != std::string::npos);
  CHECK(error_of("string.dump(print)").find("string: unknown name 'dump'") != std::string::npos);
  CHECK(error_of("collectgarbage('stop')").find("only 'count' is there") != std::string::npos);
  CHECK(run_text("return collectgarbage('count') > 0") == Value(true));
}

TEST_CASE("Sandbox: byte code is refused in whatever mode it is asked for") {
  for (const char* mode : {"nil", "'b'", "'bt'"}) {
    const Value v =
        run_text(std::string("local f, why = load('\\27Lua', 'x', ") + mode + ") return { f == nil, why }");
    CHECK(v.items()[0] == Value(true));
    CHECK(v.items()[1].string().find("binary chunk") != std::string::npos);
  }
}

TEST_CASE("Sandbox: the methods of strings cannot be changed for everybody") {
  CHECK(error_of("getmetatable('').__index.upper = nil").find("attempt to index a boolean value") !=
        std::string::npos);
  CHECK(error_of("string.upper = nil").find("read-only") != std::string::npos);
}

TEST_CASE("Sandbox: code loaded at run time sees the same sealed globals") {
  CHECK(error_of("load('x = 1', '=y')()").find("y:1: global 'x' cannot be set") != std::string::npos);
  CHECK(error_of("load('return io')()").find("'io' is not there") != std::string::npos);
}

TEST_CASE("Sandbox: a finalizer, which no limit would stop, is refused") {
  CHECK(
      error_of("setmetatable({}, { __gc = function() while true do end end })").find("'__gc' is not there") !=
      std::string::npos);
}

TEST_CASE("Sandbox: a forged mark does not reach beyond the script's own places") {
  CHECK(run_text("return { __place(1e9, { a = 1 }), __place('x', {}), __place(-1, {}), __place(0/0, {}), "
                 "__place(nil, 3) == 3 }")
            .items()
            .size() == 5);
}

TEST_CASE("Sandbox: trust gives io, os and package as they are, and nothing else changes") {
  ScriptOptions options;
  options.trust = true;
  CHECK(run_text("return { type(io.open), type(os.time()), type(package.path) }", options).text() ==
        "{ \"function\", \"number\", \"string\" }");
  CHECK(error_of("x = 1", options).find("global 'x' cannot be set") != std::string::npos);
  CHECK(error_of("debug.traceback()", options).find("'debug' is not there") != std::string::npos);
  CHECK(error_of("return { io.stdout }", options) == "scenario.lua:1: '[1]': a userdata is not data");
  CHECK(run_text("return tostring(io.stdout):find('^file %(') ~= nil", options) == Value(true));
}

TEST_CASE("Repetition: pairs and next go in one order in every state") {
  const std::string text = R"(
    local t, seen = { z = 1, [3] = 2, [1.5] = 3, a = 4, [true] = 5, [-1] = 6, ["10"] = 7, m = 8, [false] = 9 }, {}
    for k in pairs(t) do seen[#seen + 1] = tostring(k) end
    local k = next(t)
    while k ~= nil do
      seen[#seen + 1] = tostring(k)
      k = next(t, k)
    end
    return table.concat(seen, " "))";
  for (int i = 0; i < 10; ++i) {
    CHECK(run_text(text).string() == "-1 1.5 3 10 a m z false true -1 1.5 3 10 a m z false true");
  }
}

TEST_CASE("Repetition: entries may change or go while pairs passes over them") {
  CHECK(run_text("local t, n = { a = 1, b = 2, c = 3 }, 0 for k, v in pairs(t) do t[k] = nil t.c = nil n = n "
                 "+ v end "
                 "return { n, next(t) == nil }")
            .text() == "{ 3, true }");
}

TEST_CASE("Repetition: pairs asks __pairs, and refuses keys without an order") {
  CHECK(run_text("local t = setmetatable({}, { __pairs = function() return function(_, k) if not k then "
                 "return 1, 2 end "
                 "end, nil, nil end }) local s = 0 for k, v in pairs(t) do s = s + k + v end return s") ==
        Value(3));
  CHECK(error_of("for k in pairs({ [{}] = 1, [{}] = 2 }) do end").find("have no order") != std::string::npos);
  CHECK(error_of("pairs(nil)") == "scenario.lua:1: pairs: expected table, got nil");
  CHECK(run_text("local n = 0 for k in pairs({ [print] = 1 }) do n = n + 1 end return n") == Value(1));
}

TEST_CASE("Repetition: math.random depends on the seed alone") {
  const std::string text = "return { math.random(1000000), math.random(1000000), math.random() }";
  ScriptOptions other;
  other.seed = 2;
  CHECK(run_text(text) == run_text(text));
  CHECK_FALSE(run_text(text) == run_text(text, other));
  CHECK(error_of("math.randomseed()") ==
        "scenario.lua:1: math.randomseed: expected a seed, the same for every run");
  CHECK(run_text("math.randomseed(5) local a = math.random() math.randomseed(5) return a == math.random()") ==
        Value(true));
}

TEST_CASE("Repetition: no address is ever shown") {
  CHECK(run_text(
            "return { tostring({}), tostring(print), tostring(coroutine.create(print)), tostring(preshape) }")
            .text() == "{ \"table\", \"function\", \"thread\", \"preshape\" }");
  CHECK(run_text("return ('%s %5s %% %d %-9s'):format({}, 'a', 3, print)").string() ==
        "table     a % 3 function ");
  CHECK(
      run_text("return tostring(setmetatable({}, { __tostring = function() return 'mine' end }))").string() ==
      "mine");
  CHECK(error_of("return ('%p'):format({})").find("'%p' is not there") != std::string::npos);
}

TEST_SUITE_END();
