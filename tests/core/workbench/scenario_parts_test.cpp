#include <fstream>

#include "preshape/base/error.h"
#include "preshape/grasp/task_space.h"
#include "preshape/script/setting.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

Task task(const char* lua) { return task_from_value(parse_value(lua)); }
ObjectChoice object(const char* lua, const std::filesystem::path& script = {}) {
  return object_from_value(parse_value(lua), script, catalogue());
}

using Six = std::array<double, 6>;

}  // namespace

TEST_CASE("Task: a name, six numbers, translation and rotation, or a manipulation") {
  CHECK(task("\"T1_2\"").screw == Six{1.0, 1.0, 0.1, 0.05, 0.8, 0.05});
  CHECK(task("\"T1_2\"").name == "T1_2");
  CHECK(task("{ 1, 2, 3, 4, 5, 6 }").screw == Six{1, 2, 3, 4, 5, 6});
  CHECK(task("{ T = { 1, 0, 0 }, R = { 0, 0.8, 0 } }").screw == Six{1, 0, 0, 0, 0.8, 0});
  CHECK(task("{ T = { 1, 0, 0 } }").screw == Six{1, 0, 0, 0.05, 0.05, 0.05});
  CHECK(task("{ T = { 1, 0, 0 }, name = \"lift\" }").name == "lift");
  CHECK(task("{ name = \"T3_4-\", stability = 5, manipulability = 4 }").screw == named_task("T3_4-").screw);
  CHECK(task("{ name = \"T3_4-\", stability = 5, manipulability = 4 }").stability == 5.0);
  CHECK(task("{ name = \"T3_4-\", stability = 5, manipulability = 4 }").manipulability == 4.0);
  CHECK(task("{ manipulation = \"pivot\", approach = \"X\", opposition = \"-Y\" }").screw ==
        manipulation_task("pivot", "X", "-Y").screw);
  CHECK(task("\"T1_2\"").stability == 6.0);
  CHECK(task("\"T1_2\"").manipulability == 5.0);
}

TEST_CASE("Task: anything else is told with what was given") {
  CHECK_THROWS_SAYING(task("\"T1_7\""), InputError, "there is no task 'T1_7'; did you mean");
  CHECK_THROWS_SAYING(task("{ 1, 2, 3 }"), InputError, "has six numbers");
  CHECK_THROWS_SAYING(task("{ 1, 2, 3, 4, 5, \"six\" }"), InputError, "component 6 must be a finite number, got \"six\"");
  CHECK_THROWS_SAYING(task("{ 1, 2, 3, 4, 5, 1/0 }"), InputError, "component 6 must be a finite number");
  CHECK_THROWS_SAYING(task("{ T = { 1, 2 } }"), InputError, "'T' must be three finite numbers {x, y, z}, got { 1, 2 }");
  CHECK_THROWS_SAYING(task("{ R = { 0, 0, 2e6 } }"), InputError, "'R' element 3 must be in");
  CHECK_THROWS_SAYING(task("{ manipulation = \"twidle\" }"), InputError, "did you mean 'twiddle'?");
  CHECK_THROWS_SAYING(task("{ manipulation = \"pivot\", approach = \"X\", opposition = \"-X\" }"), InputError, "different axes");
  CHECK_THROWS_SAYING(task("7"), InputError, "task: expected a table of parameters, got number 7");
}

TEST_CASE("Object: a shipped name brings its description, and what the scenario adds stands on top of it") {
  const ObjectChoice mug = object("\"mug\"");
  CHECK(mug.name == "mug");
  CHECK(mug.mesh == source_file("objects/mug/mug.obj"));
  CHECK(mug.placement.unit == "U");
  CHECK(mug.placement.fit_U == 0.0);
  const ObjectChoice small = object("{ name = \"mug\", fit = 2, frame = \"principal\" }");
  CHECK(small.mesh == mug.mesh);
  CHECK(small.placement.unit == "U");
  CHECK(small.placement.fit_U == 2.0);
  CHECK(small.placement.frame == "principal");
  CHECK_THROWS_SAYING(object("\"mugg\""), InputError, "did you mean 'mug'?");
  CHECK_THROWS_SAYING(object("{ fit = 2 }"), InputError, "object: give a 'name' or a 'mesh'");
  CHECK_THROWS_SAYING(object("7"), InputError, "object: expected a table of parameters, got number 7");
}

TEST_CASE("Object: a mesh file is looked for beside the script, and is called as it is unless a name is given") {
  TemporaryDirectory folder;
  std::ofstream(folder / "part.obj") << "v 0 0 0\n";
  const ObjectChoice part = object("\"part.obj\"", folder / "scenario.lua");
  CHECK(part.mesh == folder / "part.obj");
  CHECK(part.name == "part");
  CHECK(part.placement.unit == "file");
  const ObjectChoice named = object("{ mesh = \"part.obj\", name = \"knob\", unit = \"mm\", weld = 0.001 }", folder / "scenario.lua");
  CHECK(named.mesh == folder / "part.obj");
  CHECK(named.name == "knob");
  CHECK(named.placement.unit == "mm");
  CHECK(named.weld == 0.001);
  CHECK(object("\"/somewhere/else.stl\"", folder / "scenario.lua").mesh == "/somewhere/else.stl");
}

TEST_CASE("Hand: by name, by the path of a description, or described in place") {
  const auto hand = [](const std::string& text) { return read_text("return { object = \"cube\", task = \"T1_1\", hand = " + text + " }"); };
  const auto named = hand("\"utah_mit\"");
  REQUIRE(named.mistakes.empty());
  const auto by_path = hand("\"" + source_file("hands/utah_mit/hand.lua").string() + "\"");
  REQUIRE_MESSAGE(by_path.mistakes.empty(), mistakes_of(by_path));
  CHECK(by_path.scenario.hand.description == named.scenario.hand.description);
  CHECK(by_path.scenario.hand.name == "utah_mit");
  const auto in_place = hand(lua_source(named.scenario.hand.description));
  REQUIRE_MESSAGE(in_place.mistakes.empty(), mistakes_of(in_place));
  CHECK(in_place.scenario.hand.model == "dh");
  CHECK(in_place.scenario.hand.description == named.scenario.hand.description);

  CHECK(mistakes_of(hand("{ fingers = 4 }")).find("'model' is missing; say which hand plugin reads it") != std::string::npos);
  CHECK(mistakes_of(hand("{ model = \"dhh\" }")).find("there is no hand 'dhh'; did you mean 'dh'?") != std::string::npos);
  CHECK(mistakes_of(hand("5")).find("a hand is a name, a path or a table, got number 5") != std::string::npos);
  CHECK(mistakes_of(hand("\"./nothing.lua\"")).find("nothing.lua") != std::string::npos);
}

TEST_CASE("Memory: a bare name is kept in the user's folder, a path is a path, and :memory: is no file") {
  CHECK(memory_path("demo").filename() == "demo.memory");
  CHECK(memory_path("demo").parent_path().filename() == "memories");
  CHECK(memory_path("./demo") == "./demo");
  CHECK(memory_path("/tmp/x.memory") == "/tmp/x.memory");
  CHECK(memory_path("demo.memory") == "demo.memory");
  CHECK(memory_path(":memory:") == ":memory:");
  CHECK(memory_path(":memory:box") == ":memory:box");
}

TEST_SUITE_END();
