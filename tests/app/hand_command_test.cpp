#include "command.h"

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

TEST_CASE("hand: without a name the shipped hands are listed, with one its joints, sizes and workspaces") {
  const CommandLine cli;
  CHECK(cli.run("hand").out == "allegro\nbarrett\nleap\nshadow\nutah_mit\n");
  const auto about = cli.run("hand utah_mit");
  INFO(about.err);
  CHECK(about.exit_code == 0);
  CHECK(contains(about.out, "4 fingers, 16 joints, 16 drives"));
  CHECK(contains(about.out, "opposes_thumb_from_mm"));
  CHECK(contains(cli.run("hand barrett limits").out, "0.333"));
}

TEST_CASE("hand ik and fk: what the one gives is what the other takes, and a point out of reach exits 1") {
  const CommandLine cli;
  const auto found = cli.run("hand utah_mit ik --finger thumb --at 0,-30,100 --csv q.csv");
  REQUIRE(found.exit_code == 0);
  std::istringstream rows(read_text(cli / "q.csv"));
  std::string line, values;
  std::getline(rows, line);
  for (int i = 0; i < 4 && std::getline(rows, line); ++i) {
    const auto first = line.find(',', line.find(',') + 1) + 1;
    values += line.substr(first, line.find(',', first) - first) + ",";
  }
  for (int i = 0; i < 12; ++i) values += i == 11 ? "0" : "0,";
  const auto back = cli.run("hand utah_mit fk --finger thumb --posture " + values + " --csv p.csv");
  INFO(back.err, values);
  REQUIRE(back.exit_code == 0);
  const std::string poses = read_text(cli / "p.csv");
  std::istringstream tip(poses.substr(poses.find("thumb,tip,") + 10));
  double x = 1, y = 1, z = 1;
  char comma = 0;
  tip >> x >> comma >> y >> comma >> z;
  CHECK(std::abs(x) < 1e-4);
  CHECK(std::abs(y + 30) < 1e-4);
  CHECK(std::abs(z - 100) < 1e-4);
  const auto far = cli.run("hand utah_mit ik --finger thumb --at 0,0,1000");
  CHECK(far.exit_code == 1);
  CHECK(contains(far.out, "not reached"));
}

TEST_CASE("hand: a wrong hand, finger, posture or option is told with the mend") {
  const CommandLine cli;
  const auto says = [&](const char* arguments, int code, const char* part) {
    const auto result = cli.run(arguments);
    INFO(arguments, ": ", result.err);
    CHECK(result.exit_code == code);
    CHECK(contains(result.err, part));
  };
  says("hand utah_mt", 5, "did you mean 'utah_mit'?");
  says("hand utah_mit ik --finger tumb --at 0,0,0", 5, "did you mean 'thumb'?");
  says("hand utah_mit fk --posture 1,2,3", 5, "the hand has 16 joints");
  says("hand utah_mit ik --finger thumb", 2, "--at");
  says("hand nowhere/hand.lua", 5, "nowhere/hand.lua");
}

TEST_CASE("hand workspace: a table, every cell as CSV, a drawing") {
  const CommandLine cli;
  CHECK(contains(cli.run("hand leap workspace --samples 2000 --svg w.svg").out, "volume_cm3"));
  CHECK(contains(read_text(cli / "w.svg"), ">Workspaces of leap</text>"));
  CHECK(contains(read_text(cli / "w.svg"), ">50 mm</text>"));
  const auto cells = cli.run("hand leap workspace --samples 500 --finger thumb --csv -");
  CHECK(contains(cells.out, "finger,x_mm,y_mm,z_mm\r\nthumb,"));
}

TEST_CASE("hand: limits, fk and ik are drawn; a joint that follows another is an empty bar, the point asked for is marked") {
  const CommandLine cli;
  const auto count = [](const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  CHECK(cli.run("hand barrett limits --svg l.svg").exit_code == 0);
  const std::string limits = read_text(cli / "l.svg");
  CHECK(count(limits, "<rect ") == 1 + 8);
  int empty = 0;
  std::istringstream lines(limits);
  for (std::string line; std::getline(lines, line);) empty += line.starts_with("<rect ") && contains(line, "fill=\"none\"");
  CHECK(empty == 4);
  CHECK(contains(limits, "0.3333 x thumb_inner"));
  CHECK(cli.run("hand barrett fk --finger index --svg f.svg").exit_code == 0);
  const std::string index = read_text(cli / "f.svg");
  CHECK(contains(index, "<title>index tip</title>"));
  CHECK_FALSE(contains(index, "<title>thumb"));
  CHECK_FALSE(contains(index, "asked for"));
  CHECK(cli.run("hand utah_mit ik --finger thumb --at 0,-30,100 --svg i.svg").exit_code == 0);
  const std::string reached = read_text(cli / "i.svg");
  CHECK(contains(reached, "<title>thumb tip</title>"));
  CHECK(count(reached, "<title>asked for</title>") == 3);
  CHECK(contains(reached, "utah_mit, thumb to 0, -30, 100 mm: reached"));
  CHECK(cli.run("hand barrett fk --svg no_such_folder/f.svg").exit_code == 5);
}

TEST_CASE("hand from a URDF: the example of docs/scenarios.md is carried out under its folder's name, and conforms") {
  const CommandLine cli;
  if (cli.run("plugins hand/urdf --exists").exit_code != 0) {
    MESSAGE("skipped: this build has no hand/urdf");
    return;
  }
  std::string page = read_text(source_file("docs/scenarios.md"));
  page.erase(0, page.find("### A hand from a URDF"));
  std::filesystem::create_directory(cli / "gripper");
  for (const char* file : {"gripper/gripper.urdf", "gripper/hand.lua", "grasp.lua"}) {
    page.erase(0, page.find('\n', page.find("```")) + 1);
    write_text(cli / file, page.substr(0, page.find("```")));
    page.erase(0, page.find("```") + 3);
  }
  const auto run = cli.run("run grasp.lua");
  INFO(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(contains(run.out, "hand gripper, task T1_2"));
  CHECK(contains(run.out, "  reached "));
  CHECK(cli.run("conform hand/urdf -q --set description=gripper/hand.lua").exit_code == 0);
  const auto nowhere = cli.run("conform hand/urdf --set description=griper/hand.lua");
  CHECK(nowhere.exit_code == 5);
  CHECK(contains(nowhere.err, "preshape: script 'griper/hand.lua' cannot be read"));
  CHECK(nowhere.out.empty());
}

TEST_CASE("run: a hand without a thumb, or with a thumb alone, is refused with the reason; one forefinger serves what asks for one") {
  const CommandLine cli;
  const auto hand = [&](const std::string& fingers) {
    write_text(cli / "h.lua",
               "local function finger(name, y, yaw)\n"
               "  local function joint(k, length) return { name = name .. k, a = length, limits = { -0.5, 1.7 } } end\n"
               "  return { name = name, role = name, base = { position = { 0, y, 0 }, rotation = { 0, -math.pi / 2, yaw } },\n"
               "    joints = { joint(1, 0.06), joint(2, 0.05) } }\n"
               "end\n"
               "return { model = 'dh', unit_length = 0.03, finger_spacing = 0.03, maximum_opening = 0.1, base_width = 0.1,\n"
               "  fingers = { " + fingers + " } }\n");
    write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_1', hand = './h.lua', memory = ':memory:' }\n");
    return cli.run("run s.lua");
  };
  const std::string thumb = "finger('thumb', -0.05, math.pi)", index = "finger('index', 0.05, 0)";
  const auto thumbless = hand(index + ", finger('middle', 0.05, 0)");
  INFO(thumbless.out, thumbless.err);
  CHECK(thumbless.exit_code == 0);  // the preshape serves; the hand is another matter
  CHECK(contains(thumbless.out, "  refused        the hand has no thumb: name one of its fingers so\n"));
  CHECK_FALSE(contains(thumbless.out, "hand base"));
  const auto lonely = hand(thumb);
  INFO(lonely.out);
  CHECK(contains(lonely.out, "  refused        the grasp has 2 contacts"));
  CHECK(contains(lonely.out, "the hand has\n                 0 forefingers\n"));
  const auto pair = hand(thumb + ", " + index);
  INFO(pair.out);
  CHECK(contains(pair.out, "fingers        thumb, index (VF 1"));
  CHECK_FALSE(contains(pair.out, "  refused"));
}

TEST_CASE("run: what a URDF's hand had to do without is told below the report, and stands in its JSON") {
  const CommandLine cli;
  std::string urdf = "<robot name='r'><link name='palm'><collision><geometry><mesh filename='package://r/palm.stl'/></geometry></collision></link>";
  for (const std::string finger : {"t", "i"}) {
    urdf += fmt::format("<link name='{0}'/><joint name='{0}1' type='revolute'><parent link='palm'/><child link='{0}'/>"
                        "<axis xyz='1 0 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>", finger);
  }
  write_text(cli / "r.urdf", urdf + "</robot>");
  write_text(cli / "h.lua",
             "return { model = 'urdf', file = 'r.urdf', base = { link = 'palm' }, unit_length = 0.03, finger_spacing = 0.03,\n"
             "  maximum_opening = 0.1, base_width = 0.1, fingers = {\n"
             "  { name = 'thumb', role = 'thumb', tip = { link = 't', position = { 0, 0, 0.1 } } },\n"
             "  { name = 'index', role = 'index', tip = { link = 'i', position = { 0, 0, 0.1 } } } } }\n");
  write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_1', hand = './h.lua', simulator = 'none', memory = ':memory:' }\n");
  const auto told = cli.run("run s.lua --json out.json");
  INFO(told.out, told.err);
  const std::string note = "palm.stl";
  REQUIRE(contains(told.out, "\nHand\n  note: "));
  CHECK(contains(told.out.substr(told.out.find("\nHand\n")), note));
  const std::string json = read_text(cli / "out.json");
  REQUIRE(contains(json, "\"notes\": ["));
  CHECK(contains(json.substr(json.find("\"notes\": [")), note));
  CHECK_FALSE(contains(cli.run("run s.lua --set hand=utah_mit").out, "\nHand\n"));
}

TEST_SUITE_END();
