#include <fstream>
#include <thread>

#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

namespace {

/// scenario.lua with this text, beside its modules.
struct Folder {
  TemporaryDirectory folder;
  ScriptOptions options;

  std::string error(const std::string& text) {
    write_file(folder / "own/scenario.lua", text);
    try {
      Script(folder / "own/scenario.lua", options).run();
    } catch (const ScriptError& error) {
      return error.what();
    }
    return "no error";
  }
  Value run(const std::string& text) {
    write_file(folder / "own/scenario.lua", text);
    return Script(folder / "own/scenario.lua", options).run();
  }
  Folder() { options.module_roots = {folder / "installed"}; }
};

}  // namespace

TEST_CASE("require: the script's own folder comes before the installed modules") {
  Folder f;
  write_file(f.folder / "own/a.lua", "return 'own a'");
  write_file(f.folder / "installed/a.lua", "return 'installed a'");
  write_file(f.folder / "installed/deep/b.lua", "return 'installed b'");
  CHECK(f.run("return { require('a'), require('deep.b') }").text() == "{ \"own a\", \"installed b\" }");
}

TEST_CASE("require: a module runs once, knows its name, and is true when it returns nothing") {
  Folder f;
  write_file(f.folder / "own/a.lua", "local name = ...\nreturn { name = name }");
  write_file(f.folder / "own/b.lua", "local x = 1");
  CHECK(f.run("return { require('a') == require('a'), require('a').name, require('b'), require('math') == "
              "math }")
            .text() == "{ true, \"a\", true, true }");
}

TEST_CASE("require: a module that is not there is told with every path that was tried") {
  Folder f;
  const std::string error = f.error("\nreturn require('far.off')");
  CHECK(error.find("own/scenario.lua:2: require: module 'far.off' was not found; tried ") !=
        std::string::npos);
  CHECK(error.find((f.folder / "own/far/off.lua").string()) != std::string::npos);
  CHECK(error.find((f.folder / "installed/far/off.lua").string()) != std::string::npos);
  CHECK(error_of("require('x')") ==
        "scenario.lua:1: require: module 'x' was not found; there is no folder to search");
}

TEST_CASE("require: a name cannot lead out of its folders") {
  Folder f;
  write_file(f.folder / "x.lua", "return 1");
  for (const char* name : {"../x", "..x", "/x", "x/y", "", ".", "a..b", "x.", "x y", "~x", "..", "x\\0"}) {
    CHECK(f.error(std::string("require('") + name + "')").find("is no module name") != std::string::npos);
  }
  CHECK(f.error("require(5)").find("require: expected string, got number") != std::string::npos);
}

TEST_CASE("require: a mistake in a module is told with the module's line") {
  Folder f;
  write_file(f.folder / "own/a.lua", "return {\n  x = 1,\n  = 2 }");
  write_file(f.folder / "own/b.lua", "\nreturn nothing.x");
  CHECK(f.error("require('a')").find("a.lua:3: unexpected symbol near '='") != std::string::npos);
  CHECK(f.error("require('b')").find("b.lua:2: unknown global 'nothing'") != std::string::npos);
}

TEST_CASE("require: modules that need each other are told as a circle, and a failure is not remembered") {
  Folder f;
  write_file(f.folder / "own/a.lua", "return require('b')");
  write_file(f.folder / "own/b.lua", "return require('a')");
  CHECK(f.error("require('a')").find("in a circle (a -> b -> a)") != std::string::npos);
  write_file(f.folder / "own/c.lua", "error('once')");
  CHECK(f.run("local _, a = pcall(require, 'c') local _, b = pcall(require, 'c') return a == b") ==
        Value(true));
}

TEST_CASE("require: a module that was not named by the person is shown without the machine's folders") {
  Folder f;
  write_file(f.folder / "installed/preshape/a.lua", "error('x')");
  CHECK(f.error("require('preshape.a')") == "preshape/a.lua:1: x");
}

TEST_CASE("require: with trust the stock way is tried last") {
  Folder f;
  f.options.trust = true;
  write_file(f.folder / "own/a.lua", "return 'ours'");
  CHECK(f.run("package.preload.b = function() return 'stock' end return { require('a'), require('b') }")
            .text() == "{ \"ours\", \"stock\" }");
  CHECK(f.error("require('none.such')").find("module 'none.such' not found") != std::string::npos);
}

TEST_CASE("Shipped module: the units are metres and radians") {
  ScriptOptions options;
  options.module_roots = {source_file("scripts")};
  const Value v = run_text(
      "local units = require('preshape.units')\n"
      "return { units.mm(25), units.cm(2.5), units.inch(1), units.deg(180) }",
      options);
  CHECK_NEAR(v.items()[0].number(), 0.025, kEps);
  CHECK_NEAR(v.items()[1].number(), 0.025, kEps);
  CHECK_NEAR(v.items()[2].number(), 0.0254, kEps);
  CHECK_NEAR(v.items()[3].number(), 3.14159265358979323846, 4 * kEps);
  CHECK(error_of("require('preshape.units').mm('3')", options) ==
        "scenario.lua:1: mm: expected number, got string");
}

TEST_CASE("Threads: scripts in several threads do not touch each other") {
  const std::string text = R"(
    local t = {}
    for i = 1, 2000 do t[i] = { i = i, x = preshape.square(i) } end
    for i = 1, 100 do pcall(preshape.square, "no") end
    return { sum = (function() local s = 0 for _, e in pairs(t) do s = s + e.x end return s end)(), r = math.random() })";
  const auto run = [&text](std::uint64_t seed) {
    ScriptOptions options;
    options.seed = seed;
    Script script = Script::from_text(text, "s.lua", options);
    script.add_function("square", "(x: number): number", "squares", [](auto arguments, const auto&) {
      if (!arguments[0].is_number()) throw InputError("not a number");
      return Value(arguments[0].number() * arguments[0].number());
    });
    return script.run();
  };
  std::vector<Value> results(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i) threads.emplace_back([&, i] { results[i] = run(i); });
  for (auto& thread : threads) thread.join();
  for (std::size_t i = 0; i < results.size(); ++i) {
    CHECK(results[i].find("sum")->number() == 2000.0 * 2001 * 4001 / 6);
    CHECK(results[i] == run(i));
  }
}

TEST_SUITE_END();
