#include "run.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/script");

TEST_CASE("Error: each mistake is one sentence with file and line") {
  CHECK(error_of("local x =\n\n= 3") == "scenario.lua:3: unexpected symbol near '='");
  CHECK(error_of("local t\nreturn t.x") == "scenario.lua:2: attempt to index a nil value (local 't')");
  CHECK(error_of("\nerror('no grasp')") == "scenario.lua:2: no grasp");
  CHECK(error_of("\nerror('no grasp', 0)") == "scenario.lua:2: no grasp");
  CHECK(error_of("\nassert(false)") == "scenario.lua:2: assertion failed!");
  CHECK(error_of("local x = math.floor({})") ==
        "scenario.lua:1: bad argument #1 to 'floor' (number expected, got table)");
}

TEST_CASE("Error: one that is no text is told as what it is") {
  CHECK(error_of("\nerror({})") == "scenario.lua:2: the error is a table instead of a text");
  CHECK(error_of("\nerror()") == "scenario.lua:2: the error is a nil instead of a text");
  CHECK(error_of("\nerror(42)") == "scenario.lua:2: 42");
  CHECK(error_of("\nerror(setmetatable({}, { __tostring = function() return 'mine' end }))") ==
        "scenario.lua:2: mine");
  CHECK(error_of("error(setmetatable({}, { __tostring = function() error('inner') end }))") ==
        "scenario.lua:1: inner");
  CHECK(error_of("error(setmetatable({}, { __tostring = function(e) error(e) end }))") ==
        "scenario.lua:1: C stack overflow");
}

TEST_CASE("Error: a file is named as the person named it, however long its name is") {
  const TemporaryDirectory folder;
  const auto path = folder / (std::string(80, 'd') + "/scenario.lua");
  write_file(path, "\nlocal function f() error('x') end\nf()");
  Script script(path);
  CHECK_THROWS_SAYING(script.run(), ScriptError, path.string() + ":2: x");
  CHECK(std::string(script.last_traceback()).find(path.string() + ":3: in main chunk") != std::string::npos);
  write_file(path, "return {,}");
  CHECK_THROWS_SAYING(Script(path).run(), ScriptError, path.string() + ":1: unexpected symbol");
  std::filesystem::create_directory("errors_test_folder");
  CHECK(Script("./errors_test_folder/../" + (std::filesystem::relative(path)).string()).name() ==
        std::filesystem::relative(path).string());
  std::filesystem::remove("errors_test_folder");
  CHECK(Script(path.parent_path() / "../" / path.parent_path().filename() / "scenario.lua").name() ==
        path.string());
}

TEST_CASE("Error: a file inside the current folder is shown relative to it") {
  const auto before = std::filesystem::current_path();
  const TemporaryDirectory folder;
  write_file(folder / "a/scenario.lua", "return {}");
  std::filesystem::current_path(folder.path());
  CHECK(Script(std::filesystem::current_path() / "a/scenario.lua").name() == "a/scenario.lua");
  std::filesystem::current_path(before);
}

TEST_CASE("Error: the way there is told apart from the sentence") {
  Script script = Script::from_text("local function inner()\n  error('x')\nend\ninner()\n", "s.lua");
  CHECK_THROWS_SAYING(script.run(), ScriptError, "s.lua:2: x");
  const std::string trace = script.last_traceback();
  CHECK(trace.find("s.lua:2: in ") != std::string::npos);
  CHECK(trace.find("s.lua:4: in main chunk") != std::string::npos);
  CHECK(trace.find("0x") == std::string::npos);
}

TEST_CASE("Error: a file that cannot be read says why") {
  const TemporaryDirectory folder;
  CHECK_THROWS_SAYING(Script(folder / "none.lua"), InputError,
                      "none.lua' cannot be read (No such file or directory)");
  CHECK_THROWS_SAYING(Script(folder.path()), InputError, "cannot be read (it is a folder)");
}

TEST_CASE("Error: compiled Lua is no script") {
  CHECK(error_of("\x1bLua") == "scenario.lua: attempt to load a binary chunk (mode is 't')");
}

TEST_CASE("Error: after one the script can be called again") {
  Script script =
      Script::from_text("return function(bad) if bad then error('bad') end return 1 end", "s.lua");
  const auto f = script.run().function();
  for (int i = 0; i < 1000; ++i) CHECK_THROWS_AS(script.call(f, std::vector<Value>{true}), ScriptError);
  CHECK(script.call(f, std::vector<Value>{false}) == Value(1));
}

TEST_CASE("Error: recursion without end is stopped with its line") {
  const std::string endless = "local function f()\n  return 1 + f()\nend\nreturn f()";
  ScriptOptions options;
  options.limits.memory_bytes = std::size_t{8} << 20;
  CHECK(error_of(endless, options) == "scenario.lua:2: needs more than 8 MiB (an endless recursion?)");
  options.limits.memory_bytes = 0;
  CHECK(error_of(endless, options) == "scenario.lua:2: stack overflow");
  CHECK(error_of("local t = {} setmetatable(t, { __index = function(s, k) return s[k] end })\nreturn t.x")
            .find("C stack overflow") != std::string::npos);
}

TEST_CASE("Description: a file that returns a table is read with its places") {
  const TemporaryDirectory folder;
  write_file(folder / "object.lua", "return {\n  name = 'mug',\n  unit = 0.025 }");
  const Value v = read_description(folder / "object.lua");
  CHECK(v.find("unit")->number() == 0.025);
  CHECK(place_of(v, "unit") == (folder / "object.lua").string() + ":3");
}

TEST_CASE("Description: a file that returns something else is refused") {
  const TemporaryDirectory folder;
  write_file(folder / "object.lua", "local name = 'mug'");
  CHECK_THROWS_SAYING(read_description(folder / "object.lua"), ScriptError,
                      "object.lua: must return a table, got nil");
}

TEST_SUITE_END();
