#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

namespace {

ScriptOptions with_instructions(std::int64_t count) {
  ScriptOptions options;
  options.limits.instructions = count;
  return options;
}

const std::string kStopped = "stopped after 1000000 instructions (an endless loop?)";

std::string endless(const std::string& text) {
  return error_of(text, with_instructions(1'000'000));
}

}  // namespace

TEST_CASE("Limit: an endless loop is stopped with its line") {
  CHECK(endless("local x = 1\nwhile true do\n  x = x + 1\nend").find("scenario.lua:") == 0);
  CHECK(endless("\n\nwhile true do end") == "scenario.lua:3: " + kStopped);
  CHECK(endless("::again:: goto again").find(kStopped) != std::string::npos);
}

TEST_CASE("Limit: no loop around pcall outlives the limit") {
  CHECK(endless("while true do\n  pcall(function() while true do end end) end") ==
        "scenario.lua:2: " + kStopped);
  CHECK(endless("local function f() return pcall(function() while true do end end) end return f()")
            .find(kStopped) != std::string::npos);
  CHECK(endless("local function f() xpcall(function() while true do end end, function() while true do end "
                "end) f() end f()")
            .find(kStopped) != std::string::npos);
  CHECK(endless("return (pcall(pcall, function() while true do end end))").find(kStopped) !=
        std::string::npos);
}

TEST_CASE("Limit: what many short coroutines do is not forgotten") {
  Script script = Script::from_text(R"(
    local n = 0
    local function work() for i = 1, 20 do n = n + 1 end end
    return { function() while true do coroutine.wrap(work)() end end, function() return n end })",
                                    "s.lua", with_instructions(1'000'000));
  const Value v = script.run();
  CHECK_THROWS_SAYING(script.call(v.items()[0].function(), {}), ScriptError, kStopped);
  CHECK(script.call(v.items()[1].function(), {}).integer() <=
        500'000);  // a step takes two instructions at least
}

TEST_CASE("Limit: nor does code that Lua runs with its hooks off after the stop") {
  const std::string closing =
      "local t <close> = setmetatable({}, { __close = function() while true do end end }) ";
  CHECK(endless(closing + "while true do end").find(kStopped) != std::string::npos);
  CHECK(endless("coroutine.wrap(function() " + closing + "while true do end end)()").find(kStopped) !=
        std::string::npos);
  CHECK(endless("local co = coroutine.create(function() " + closing +
                "while true do end end) "
                "coroutine.resume(co) coroutine.close(co)")
            .find(kStopped) != std::string::npos);
  CHECK(
      endless("xpcall(function() while true do end end, function() while true do end end)").find(kStopped) !=
      std::string::npos);
  CHECK(endless(
            "for _ in next, {}, nil, setmetatable({}, { __close = function() while true do end end }) do end")
            .find(kStopped) != std::string::npos);
  Script script = Script::from_text(
      "local co return function() if not co then co = coroutine.create(function() " + closing +
          "while true do end end) return coroutine.resume(co) end "
          "return coroutine.close(co) end",
      "s.lua", with_instructions(1'000'000));
  const auto f = script.run().function();
  CHECK_THROWS_SAYING(script.call(f, {}), ScriptError, kStopped);
  CHECK_THROWS_SAYING(script.call(f, {}), ScriptError, "coroutine.close: the coroutine was stopped");
}

TEST_CASE("Coroutine: wrapped ones behave as in Lua, closing what they leave open") {
  const Value log = run_text(R"(
    local log = {}
    local f = coroutine.wrap(function(...)
      local t <close> = setmetatable({}, { __close = function() log.closed = true end })
      log.arguments = select("#", ...)
      log.sent = coroutine.yield("yielded")
      error("bad", 0)
    end)
    log.got = f(1, nil, 3)
    log.failed = select(2, pcall(f, "again"))
    log.dead = select(2, pcall(f))
    return log)");
  CHECK(log.text() ==
        "{ arguments = 3, closed = true, dead = \"cannot resume dead coroutine\", failed = \"bad\", "
        "got = \"yielded\", sent = \"again\" }");
}

TEST_CASE("Limit: each run counts anew, and a stopped script can be called again") {
  Script script = Script::from_text(R"(
    local loop = coroutine.wrap(function() while true do for i = 1, 1e5 do end coroutine.yield(1) end end)
    return { function() while true do end end, function() for i = 1, 4e5 do end return 7 end, loop })",
                                    "s.lua", with_instructions(1'000'000));
  const Value v = script.run();
  CHECK_THROWS_SAYING(script.call(v.items()[0].function(), {}), ScriptError, kStopped);
  for (int i = 0; i < 5; ++i) CHECK(script.call(v.items()[1].function(), {}) == Value(7));
  for (int i = 0; i < 5; ++i) CHECK(script.call(v.items()[2].function(), {}) == Value(1));
}

TEST_CASE("Limit: a callback counts with the call that leads to it") {
  Script script = Script::from_text("preshape.twice(function() for i = 1, 6e5 do end end)", "s.lua",
                                    with_instructions(1'000'000));
  script.add_function("twice", "(f: function)", "calls f twice", [&](auto arguments, const auto&) {
    script.call(arguments[0].function(), {});
    return script.call(arguments[0].function(), {});
  });
  CHECK_THROWS_SAYING(script.run(), ScriptError, kStopped);
}

TEST_CASE("Limit: zero instructions means none are counted") {
  CHECK(run_text("local n = 0 for i = 1, 3e6 do n = n + 1 end return n", with_instructions(0)) ==
        Value(3000000));
}

TEST_CASE("Limit: memory that runs out is told with line and limit") {
  CHECK(error_of("local t = {}\nfor i = 1, 1e9 do\n  t[i] = {}\nend") ==
        "scenario.lua:3: needs more than 64 MiB");
  CHECK(error_of("\nlocal s = ('x'):rep(1e9)") == "scenario.lua:2: needs more than 64 MiB");
  CHECK(error_of("local s = 'x'\nwhile true do s = s .. s end") == "scenario.lua:2: needs more than 64 MiB");
  for (const char* raised : {"error(why, 0)", "error(why)"}) {
    CHECK(error_of(std::string("local ok, why = pcall(string.rep, 'x', 1e9)\n") + raised) ==
          "scenario.lua:1: needs more than 64 MiB");
  }
  CHECK(error_of("coroutine.wrap(function()\nlocal s = ('x'):rep(1e9)\nend)()")
            .find("needs more than 64 MiB") != std::string::npos);
  ScriptOptions small;
  small.limits.memory_bytes = 1 << 20;
  CHECK(error_of("return ('x'):rep(2e6)", small) == "scenario.lua:1: needs more than 1 MiB");
}

TEST_CASE("Limit: a state that is too small for its libraries is an error, not an abort") {
  for (std::size_t size = 1; size < 20'000; size = size * 5 / 4 + 1) {
    ScriptOptions tiny;
    tiny.limits.memory_bytes = size;
    CHECK(error_of("return 1", tiny).find("needs more than") != std::string::npos);
  }
}

TEST_CASE("Limit: after memory ran out the script can be called again") {
  Script script =
      Script::from_text("return { function() return ('x'):rep(1e9) end, function() return 7 end }", "s.lua");
  const Value v = script.run();
  for (int i = 0; i < 20; ++i) {
    CHECK_THROWS_SAYING(script.call(v.items()[0].function(), {}), ScriptError,
                        "s.lua:1: needs more than 64 MiB");
    CHECK(script.call(v.items()[1].function(), {}) == Value(7));
  }
}

TEST_CASE("Limit: garbage does not count") {
  ScriptOptions small;
  small.limits.memory_bytes = 4 << 20;
  CHECK(run_text("local n = 0 for i = 1, 1e5 do n = n + #{ i, i, i } end return n", small) == Value(300000));
}

TEST_SUITE_END();
