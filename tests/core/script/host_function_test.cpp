#include <stdexcept>

#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

namespace {

/// Counts how many of it live.
struct Witness {
  explicit Witness(int& alive) : alive_(alive) { ++alive_; }
  ~Witness() { --alive_; }
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  int& alive_;
};

}  // namespace

TEST_CASE("Host function: gets its arguments and the caller's line, and gives its result") {
  Script script =
      Script::from_text("local x = 1\nreturn preshape.sum(x, { 2, 3 },\n nil, { k = 4 })", "s.lua");
  script.add_function("sum", "(...): number", "adds",
                      [](std::span<const Value> a, const SourcePlace& caller) {
                        CHECK(a.size() == 4);
                        CHECK(a[2].is_nil());
                        CHECK(caller.text() == "s.lua:2");
                        return Value(a[0].number() + a[1].items()[1].number() + a[3].find("k")->number());
                      });
  CHECK(script.run().number() == 8);
}

TEST_CASE("Host function: its error gets the caller's line, once") {
  std::string message = "object 'mgu' is unknown; did you mean 'mug'?";
  Script script = Script::from_text("\nlocal function f()\n  preshape.fail()\nend\nf()", "s.lua");
  script.add_function("fail", "()", "fails", [&](auto, const auto&) -> Value { throw InputError(message); });
  CHECK_THROWS_SAYING(script.run(), ScriptError, "s.lua:3: object 'mgu' is unknown; did you mean 'mug'?");
  CHECK(script.last_traceback().find("s.lua:5: in main chunk") != std::string::npos);
  for (const char* placed : {"s.lua:7: 'mu' is wrong", "objects/mug/object.lua:2: no mesh"}) {
    message = placed;
    try {
      script.run();
      FAIL("no error");
    } catch (const ScriptError& error) {
      CHECK(error.what() == message);
    }
  }
}

TEST_CASE("Host function: the line is found through pcall and in coroutines") {
  Script script = Script::from_text(
      "local ok, a = pcall(preshape.fail)\nlocal ok, b = coroutine.resume(coroutine.create(function()\n"
      "  preshape.fail() end))\nreturn { a, b }",
      "s.lua");
  script.add_function("fail", "()", "fails", [](auto, const auto&) -> Value { throw InputError("bad"); });
  CHECK(script.run().text() == "{ \"s.lua:1: bad\", \"s.lua:3: bad\" }");
}

TEST_CASE("Host function: a long message arrives whole, and an exception that is not ours too") {
  Script script = Script::from_text("preshape.fail()", "s.lua");
  const std::string message(5000, 'm');
  script.add_function("fail", "()", "fails",
                      [&](auto, const auto&) -> Value { throw std::runtime_error(message); });
  CHECK_THROWS_SAYING(script.run(), ScriptError, message);
}

TEST_CASE("Host function: what lives in C++ dies when Lua's error passes through") {
  int alive = 0;
  Script script = Script::from_text(R"(
    for i = 1, 100 do
      pcall(preshape.call, function() error("x") end)
      pcall(preshape.call, function() local t = nil; return t.x end)
      pcall(preshape.give)
      pcall(preshape.take, coroutine.create(print))
    end)",
                                    "s.lua");
  script.add_function("call", "(f: function)", "calls", [&](auto arguments, const auto&) {
    const Witness witness(alive);
    return script.call(arguments[0].function(), {});
  });
  script.add_function("give", "(): function", "gives a function that is not there", [&](auto, const auto&) {
    const Witness witness(alive);
    return Value(Value::Function{12345});
  });
  script.add_function("take", "(t: table)", "takes", [&](auto, const auto&) {
    const Witness witness(alive);
    return Value();
  });
  script.run();
  CHECK(alive == 0);
}

TEST_CASE("Host function: what it holds is gone with the script") {
  int alive = 0;
  {
    Script script = Script::from_text("return 1", "s.lua");
    auto witness = std::make_shared<Witness>(alive);
    script.add_function("hold", "()", "holds", [witness](auto, const auto&) { return Value(); });
    witness.reset();
    CHECK(alive == 1);
  }
  CHECK(alive == 0);
}

TEST_CASE("Host function: a callback may run in the coroutine that asked for it") {
  Script script = Script::from_text(R"(
    local co = coroutine.wrap(function(x)
      local y = preshape.apply(function(z) return z + 1 end, x)
      local ok, why = pcall(preshape.apply, function() coroutine.yield() end)
      coroutine.yield(y)
      return preshape.apply(function() return why end)
    end)
    return { co(5), co(), pcall(preshape.apply, preshape.apply, print) })",
                                    "s.lua");
  script.add_function("apply", "(f: function, ...): any", "calls f", [&](auto arguments, const auto&) {
    return script.call(arguments[0].function(), arguments.subspan(1));
  });
  const Value v = script.run();
  CHECK(v.items()[0] == Value(6));
  CHECK(v.items()[1].string().find("attempt to yield across a C-call boundary") != std::string::npos);
}

TEST_CASE("Host function: a failure in a coroutine that is gone does not disturb the next call") {
  Script script = Script::from_text(R"(
    pcall(coroutine.wrap(function() preshape.fail() end))
    for i = 1, 1e5 do local garbage = { i } end
    return function() return 7 end)",
                                    "s.lua");
  script.add_function("fail", "()", "fails", [](auto, const auto&) -> Value { throw InputError("bad"); });
  const auto f = script.run().function();
  CHECK(script.call(f, {}) == Value(7));
}

TEST_CASE("Host function: calls that go round between C++ and Lua without end are an error") {
  Script script = Script::from_text(
      "local function f() return preshape.apply(f) end\nlocal function g() "
      "return preshape.apply(g) end return g()",
      "s.lua");
  script.add_function("apply", "(f: function): any", "calls f",
                      [&](auto arguments, const auto&) { return script.call(arguments[0].function(), {}); });
  CHECK_THROWS_SAYING(script.run(), ScriptError, "stack overflow");
}

TEST_CASE("Module preshape: constants are there, and the records tell what was added") {
  Script script = Script::from_text(
      "return { preshape.version, preshape.limits.most, require('preshape').version }", "s.lua");
  script.add_constant("version", "the version of preshape", "1.2.3");
  script.add_constant("limits", "bounds", Value::table({{"most", 9}}));
  script.add_function("run", "(scenario: table): table", "runs a scenario",
                      [](auto, const auto&) { return Value(); });
  CHECK(script.run().text() == "{ \"1.2.3\", 9, \"1.2.3\" }");
  CHECK(script.records().size() == 3);
  CHECK(script.records()[0].signature == "string");
  CHECK(script.records()[2].name == "run");
  CHECK(script.records()[2].signature == "(scenario: table): table");
  CHECK(script.records()[2].text == "runs a scenario");
}

TEST_CASE("Script: can be moved, and its functions go with it") {
  Script first = Script::from_text("return function() return preshape.answer() end", "s.lua");
  first.add_function("answer", "(): number", "answers", [](auto, const auto&) { return Value(42); });
  const auto f = first.run().function();
  Script second = std::move(first);
  CHECK(second.call(f, {}) == Value(42));
  second = Script::from_text("return 1", "t.lua");
  CHECK(second.run() == Value(1));
}

TEST_SUITE_END();
