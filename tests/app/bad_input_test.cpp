#include <filesystem>

#include "command.h"

using namespace preshape::test;
namespace fs = std::filesystem;

TEST_SUITE_BEGIN("app");

namespace {

/// One clear sentence in our words: one line, and not an exception's bare text.
void check_refused(const CommandResult& result, const std::string& what) {
  INFO(what, ": ", result.err);
  CHECK(result.exit_code == 5);
  CHECK(result.err.starts_with("preshape: "));
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK_FALSE(contains(result.err, "std::"));
  CHECK_FALSE(contains(result.err, "terminate"));
}

}  // namespace

TEST_CASE("Every hard mesh either runs or is refused in one sentence with exit code 5; none crashes or hangs") {
  const fs::path folder = test_data("objects/hard");
  if (folder.empty()) return;
  const CommandLine cli;
  REQUIRE(cli.run("pretrain --memory m.memory").exit_code == 0);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() == ".bin") continue;
    ++files;
    write_text(cli / "s.lua", fmt::format("return {{ object = {{ mesh = '{}', fit = 3 }}, task = 'T1_2', memory = 'm.memory' }}\n",
                                          entry.path().string()));
    const auto result = cli.run("run s.lua -q");
    INFO(entry.path().filename().string(), ": ", result.err);
    const bool ended = result.exit_code == 0 || result.exit_code == 3 || result.exit_code == 4 || result.exit_code == 5;
    CHECK(ended);
    if (result.exit_code == 5) {
      check_refused(result, entry.path().filename().string());
      CHECK(contains(result.err, entry.path().filename().string()));
    }
  }
  CHECK(files >= 22);
}

TEST_CASE("A script that is absent, empty, broken or returns no scenario is refused with its name and place") {
  const CommandLine cli;
  check_refused(cli.run("run absent.lua"), "absent");
  write_text(cli / "syntax.lua", "return {\n  object = 'cube'\n  task = 'T1_1' }\n");
  const auto syntax = cli.run("run syntax.lua");
  check_refused(syntax, "syntax");
  CHECK(contains(syntax.err, "syntax.lua:3:"));
  write_text(cli / "empty.lua", "");
  check_refused(cli.run("run empty.lua"), "empty");
  write_text(cli / "io.lua", "io.open('/etc/passwd')\n");
  const auto io = cli.run("run io.lua");
  check_refused(io, "io");
  CHECK(contains(io.err, "io.lua:1:"));
  write_text(cli / "loop.lua", "while true do end\n");
  check_refused(cli.run("run loop.lua"), "loop");
}

TEST_CASE("NaN, infinity and impossible numbers in a scenario are refused where they stand") {
  const CommandLine cli;
  for (const char* task : {"{ T = { 0/0, 1, 1 }, R = { 0, 0, 0 } }", "{ T = { 1, 1 }, R = { 0, 0, 0 } }", "{ 1, 2, 3 }",
                           "{ 1, 2, 3, 4, 5, math.huge }", "{ manipulation = 'pivot', approach = 'X', opposition = 'X' }"}) {
    write_text(cli / "s.lua", fmt::format("return {{ object = 'cube',\n task = {} }}\n", task));
    const auto result = cli.run("run s.lua");
    check_refused(result, task);
    CHECK_MESSAGE(contains(result.err, "s.lua:2:"), task);
  }
}

TEST_CASE("A missing mesh, hand or plugin is refused with the nearest name") {
  const CommandLine cli;
  write_text(cli / "s.lua", "return { object = 'mugg', task = 'T1_2' }\n");
  CHECK(contains(cli.run("run s.lua").err, "did you mean 'mug'?"));
  CHECK(contains(cli.run("run s.lua --set object=cube --set hand=utahmit").err, "did you mean 'utah_mit'?"));
  CHECK(contains(cli.run("run s.lua --set object=cube --set classifier=mpl").err, "did you mean 'mlp'?"));
  check_refused(cli.run("run s.lua --set object=nothing.obj"), "mesh");
}

TEST_CASE("A damaged plugin in the way is refused by name, and the others still work") {
  const CommandLine cli;
  fs::create_directories(cli / "plugins/contact");
  const std::string whole = read_text(fs::path(PRESHAPE_BINARY_DIR) / "lib/preshape/plugins/contact/salisbury_soft_finger.so");
  write_text(cli / "plugins/contact/cut.so", whole.substr(0, whole.size() / 2));
  write_text(cli / "plugins/contact/text.so", "no library\n");
  const auto result = cli.run("--plugin-path plugins plugins");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "salisbury_soft_finger"));
  CHECK(contains(result.out, "refused"));
  CHECK(contains(result.out, "cut.so"));
}

TEST_CASE("A hand's description that is wrong is refused by run, check and hand in one sentence with its place") {
  const CommandLine cli;
  const std::string hand =
      "return {\n  model = 'dh', unit_length = 0.03, finger_spacing = 0.03, maximum_opening = 0.1, base_width = 0.1,\n"
      "  fingers = { { name = 'thumb', role = 'thumb', base = {},\n"
      "    joints = {\n"
      "      { name = 'a', axis = { 1, 0, 0 }, limits = { -0.8, 1.2 } },\n"
      "      { name = 'b', a = 0.05, limits = { 0, 1.6 }, follows = { joint = 'a', ratio = 1 } } },\n"
      "    tip = { 0, 0, 0.04 }, links = { { link = 1, from = { 0, 0, 0 }, to = { 0, 0, 0.05 }, radius = 0.008 } } } },\n}\n";
  struct Mistake {
    const char *right, *wrong, *sentence;
  };
  const Mistake mistakes[] = {
      {"unit_length = 0.03", "unit_length = 0", "hand.lua:2: hand description: 'unit_length' must be in"},
      {"unit_length", "unit_lenght", "hand.lua:2: hand description: unknown key 'unit_lenght'; did you mean"},
      {"-0.8, 1.2", "0/0, 1.2", "hand.lua:5: finger 1 'thumb', joint 1 'a': 'limits' element 1 is not a number"},
      {"-0.8, 1.2", "1.2, -0.8", "joint 1 'a': 'limits' must be { lower, upper } with lower <= upper, got { 1.2, -0.8 }"},
      {"axis = { 1, 0, 0 }", "axis = { 0, 0, 0 }", "joint 1 'a': 'axis' must have a direction"},
      {"joint = 'a'", "joint = 'b'", "hand.lua:6: finger 1 'thumb', joint 2 'b', follows: 'joint' is the joint itself"},
      {"link = 1", "link = 3", "hand.lua:7: finger 1 'thumb', link solid 1: 'link' must be at most 2"},
      {"radius = 0.008", "radius = -1", "link solid 1: 'radius' must be in"},
      {"model = 'dh'", "model = 'hd'", "there is no hand 'hd'; did you mean 'dh'?"},
  };
  write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_2', memory = ':memory:', hand = 'hand.lua' }\n");
  write_text(cli / "hand.lua", hand);
  CHECK(cli.run("hand hand.lua limits").exit_code == 0);
  CHECK(cli.run("check s.lua").exit_code == 0);
  for (const Mistake& m : mistakes) {
    std::string text = hand;
    text.replace(text.find(m.right), std::string(m.right).size(), m.wrong);
    write_text(cli / "hand.lua", text);
    for (const char* verb : {"hand hand.lua", "check s.lua", "run s.lua -q"}) {
      const auto result = cli.run(verb);
      check_refused(result, fmt::format("{}, {}", verb, m.wrong));
      CHECK_MESSAGE(contains(result.err, m.sentence), result.err);
    }
  }
}

TEST_SUITE_END();
