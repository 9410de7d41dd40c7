// What `run` and `explore` draw.
#include "command.h"

#include <regex>

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

namespace {

constexpr const char* kCube =
    "return { object = 'cube', task = 'T1_2', memory = ':memory:', collision = 'brute' }\n";

/// Width and height that a PNG file tells.
std::pair<unsigned, unsigned> size_of_png(const std::string& file) {
  if (!file.starts_with("\x89PNG\r\n\x1a\n") || file.size() < 24) return {0, 0};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(file[at + k]);
    return value;
  };
  return {number(16), number(20)};
}

}  // namespace

TEST_CASE("run: --picture draws a PNG of the size asked for, the same one twice; --view draws another") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  const auto result = cli.run("run s.lua -q --picture a.png --picture-size 480x300");
  CHECK(result.exit_code == 0);
  CHECK(size_of_png(read_text(cli / "a.png")) == std::pair{480U, 300U});
  cli.run("run s.lua -q --picture b.png --picture-size 480x300");
  CHECK(read_text(cli / "a.png") == read_text(cli / "b.png"));
  CHECK(cli.run("run s.lua -q --picture c.png --picture-size 480x300 --view -1,-2,-1").exit_code == 0);
  CHECK(size_of_png(read_text(cli / "c.png")) == std::pair{480U, 300U});
  CHECK(read_text(cli / "a.png") != read_text(cli / "c.png"));
}

TEST_CASE(
    "run: a wrong size or view of a picture exits 2 before anything runs, a bad path 5, each in a sentence") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  for (const char* size : {"480", "100x100", "0x0", "480x", "480x300x2", "9000x300", "axb", "-480x300"}) {
    const auto result = cli.run(fmt::format("run s.lua --picture a.png --picture-size={}", size));
    INFO(size);
    CHECK(result.exit_code == 2);
    CHECK(result.out == "");
    CHECK(contains(result.err, "is no size of a picture; give WIDTHxHEIGHT, 240x180 to 8192x8192"));
  }
  for (const char* view : {"0,0,0", "1,2", "nan,0,1", "1,2,3,4"}) {
    const auto result = cli.run(fmt::format("run s.lua --picture a.png --view={}", view));
    INFO(view);
    CHECK(result.exit_code == 2);
    CHECK(contains(result.err, "is no way to look; give X,Y,Z"));
  }
  CHECK(cli.run("run s.lua --view 1,0,0").exit_code == 2);
  const auto nowhere = cli.run("run s.lua -q --picture no_such_folder/a.png");
  CHECK(nowhere.exit_code == 5);
  CHECK(contains(nowhere.err, "'no_such_folder/a.png' cannot be written"));
}

TEST_CASE(
    "run: --posture open draws the hand before it closes, grasp what is drawn unless said, and nothing else "
    "is known") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  const std::string draw = "run s.lua -q --picture-size 480x300 --picture ";
  for (const char* more : {"a.png", "b.png --posture grasp", "c.png --posture open"})
    CHECK(cli.run(draw + more).exit_code == 0);
  CHECK(read_text(cli / "a.png") == read_text(cli / "b.png"));
  CHECK(read_text(cli / "a.png") != read_text(cli / "c.png"));
  CHECK(cli.run(draw + "d.png --posture closed").exit_code == 2);
  CHECK(cli.run("run s.lua --posture open").exit_code == 2);  // of no picture
}

TEST_CASE(
    "run: --first-try shows what the hand could not carry out, where it did another; else it changes "
    "nothing") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  // The thumb runs into the mug, which can be held elsewhere.
  write_text(cli / "mug.lua", "return { object = 'mug', task = 'T1_2', memory = ':memory:' }\n");
  for (const char* script : {"s.lua", "mug.lua"}) {
    const auto run = cli.run(fmt::format("run {} -q --scene shown.glb", script));
    CHECK(cli.run(fmt::format("run {} -q --scene first.glb --first-try", script)).exit_code == 0);
    const bool second = contains(run.out, "second try     the hand carries out another");
    const std::string shown = read_text(cli / "shown.glb"), first = read_text(cli / "first.glb");
    INFO(script);
    CHECK(second == (script != std::string("s.lua")));
    CHECK((shown != first) == second);
    CHECK(contains(shown, "\"shown\":\"second try: plane ") == second);
    CHECK(contains(first, "\"shown\":\"first try: plane ") == second);
  }
}

TEST_CASE("run: a comparison or a study is not drawn but refused") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  write_text(cli / "study.lua", "return { 1, 2 }\n");
  const auto comparison = cli.run("run s.lua -q --picture a.png --set 'task={ \"T1_1\", \"T1_2\" }'");
  CHECK(comparison.exit_code == 5);
  CHECK(contains(comparison.err, "--picture draws one run, not a comparison or a study; run one scenario"));
  CHECK(cli.run("run study.lua --matrices a.svg").exit_code == 5);
}

TEST_CASE("run: --matrices draws the task's and the wrench's degrees, with the score that the report tells") {
  const CommandLine cli;
  write_text(cli / "s.lua", kCube);
  const auto result = cli.run("run s.lua -q --matrices m.svg");
  CHECK(result.exit_code == 0);
  const std::string svg = read_text(cli / "m.svg");
  static const std::regex told(R"(tfvadi ([0-9.]+))"), drawn(R"(>([0-9.]+) in all<)");
  std::smatch in_report, in_drawing;
  REQUIRE(std::regex_search(result.out, in_report, told));
  REQUIRE(std::regex_search(svg, in_drawing, drawn));
  CHECK(std::abs(std::stod(in_report[1]) - std::stod(in_drawing[1])) < 0.0051);
}

TEST_CASE("explore: --svg has a cell for every row of --all, with the same number") {
  const CommandLine cli;
  const std::string what = "explore --object cube --task T1_2 --step 0.3 ";
  CHECK(cli.run(what + "--all --csv w.csv --svg w.svg").exit_code == 0);
  const std::string svg = read_text(cli / "w.svg");
  CHECK(cli.run(what + "--svg -").out == svg);
  std::istringstream lines(read_text(cli / "w.csv"));
  std::string line;
  std::getline(lines, line);
  CHECK(line.starts_with("plane,x/half,"));
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> cells;
    std::istringstream words(line);
    for (std::string cell; std::getline(words, cell, ',');) cells.push_back(cell);
    const std::string where = fmt::format("plane {}: ", cells[0]),
                      x = fmt::format("x = {:.6g}: ", std::stod(cells[1]));
    const auto place = std::regex(fmt::format("{}[^<]*{}([^<]*)</title>", where, x));
    std::smatch found;
    INFO(line);
    REQUIRE(std::regex_search(svg, found, place));
    const std::string told = found[1];
    if (line.ends_with(",grasp"))
      CHECK(told == fmt::format("tfvadi {:.6g}", std::stod(cells[14])));
    else
      CHECK(told.starts_with("no grasp"));
  }
  CHECK(rows > 30);
  std::size_t count = 0;
  for (auto at = svg.find("</title></rect>"); at != std::string::npos;
       at = svg.find("</title></rect>", at + 1))
    ++count;
  CHECK(count == static_cast<std::size_t>(rows));
  CHECK(cli.run(what + "--svg no_such_folder/w.svg").exit_code == 5);
}

TEST_CASE("gallery: every shipped object is there with a picture of at most 60 kB") {
  const std::filesystem::path docs = std::filesystem::path(PRESHAPE_SOURCE_DIR) / "docs";
  const std::string page = read_text(docs / "gallery.md");
  int objects = 0;
  for (const auto& folder : std::filesystem::directory_iterator(std::filesystem::path(PRESHAPE_SOURCE_DIR) / "objects")) {
    if (!std::filesystem::exists(folder.path() / "object.lua")) continue;
    const std::string name = folder.path().filename().string(), picture = "gallery/" + name + ".png";
    INFO(name);
    CHECK(contains(page, "(" + picture + ")"));
    const std::string file = read_text(docs / picture);
    CHECK(size_of_png(file) == std::pair{1200U, 500U});
    CHECK(file.size() < 60000);
    ++objects;
  }
  CHECK(objects > 10);
}

TEST_CASE("run: a run that ends without a grasp is drawn all the same, and its matrices say that there is none") {
  const CommandLine cli;
  write_text(cli / "s.lua",
             "return { object = { mesh = 'tetrahedron.off', unit = 'U' }, task = 'T1_2', memory = ':memory:', collision = 'brute' }\n");
  write_text(cli / "tetrahedron.off", "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n");
  const auto result = cli.run("run s.lua -q --picture a.png --matrices m.svg --picture-palette");
  INFO(result.err);
  CHECK((result.exit_code == 3 || result.exit_code == 4));
  CHECK(size_of_png(read_text(cli / "a.png")) == std::pair{1440U, 620U});
  CHECK(contains(read_text(cli / "m.svg"), "no grasp"));
}

TEST_SUITE_END();
