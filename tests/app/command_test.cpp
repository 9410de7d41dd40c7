#include <nlohmann/json.hpp>

#include "command.h"

using namespace preshape::test;

TEST_SUITE_BEGIN("app");

TEST_CASE("run: the demo scenario pretrains an empty memory, serves the task and exits 0; again, and it is served at once") {
  const CommandLine cli;
  const std::string demo = source_file("scripts/scenarios/demo.lua").string();
  const auto first = cli.run("run '" + demo + "'");
  INFO(first.err);
  CHECK(first.exit_code == 0);
  CHECK(contains(first.out, "The memory was empty: pretrained on the cube first (24 rows"));
  CHECK(contains(first.out, "Preshape\n"));
  const auto second = cli.run("run '" + demo + "'");
  CHECK(second.exit_code == 0);
  CHECK(contains(second.out, "served"));
  CHECK_FALSE(contains(second.out, "The memory was empty"));
}

TEST_CASE("run: the JSON report carries status, pipeline and seed, and the same run gives the same bytes but for timings") {
  const CommandLine cli;
  write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_2', memory = 'm.memory', seed = 3 }\n");
  REQUIRE(cli.run("run s.lua -q").exit_code == 0);
  REQUIRE(cli.run("run s.lua --json a.json").exit_code == 0);
  REQUIRE(cli.run("run s.lua --json b.json").exit_code == 0);
  auto a = nlohmann::json::parse(read_text(cli / "a.json")), b = nlohmann::json::parse(read_text(cli / "b.json"));
  CHECK(a["schema"] == "preshape-report/1");
  CHECK(a["status"] == "served");
  CHECK(a["pipeline"]["seed"] == 3);
  CHECK(a["result"]["contacts"].size() == 3);
  CHECK(a["object"]["hash"].get<std::string>().size() == 64);
  a.erase("timings"), b.erase("timings");
  CHECK(a.dump() == b.dump());
}

TEST_CASE("run: --set changes components and their parameters by one word") {
  const CommandLine cli;
  write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_2', memory = 'm.memory' }\n");
  const auto usual = cli.run("run s.lua --json a.json");
  const auto brute = cli.run("run s.lua --set collision=brute --json b.json");
  const auto weak = cli.run("run s.lua --set contact.ka=0.1 --set thresholds.estimation=2 --memory w.memory --json c.json");
  REQUIRE(usual.exit_code == 0);
  REQUIRE(brute.exit_code == 0);
  REQUIRE(weak.exit_code == 0);
  const auto a = nlohmann::json::parse(read_text(cli / "a.json")), b = nlohmann::json::parse(read_text(cli / "b.json")),
             c = nlohmann::json::parse(read_text(cli / "c.json"));
  CHECK(a["result"]["resultant_wrench"] == b["result"]["resultant_wrench"]);
  CHECK(c["pipeline"]["description"]["contact"]["ka"] == 0.1);
  CHECK(c["thresholds"]["estimation"] == 2.0);
  const auto wrong = cli.run("run s.lua --set contact.kaa=1");
  CHECK(wrong.exit_code == 5);
  CHECK(contains(wrong.err, "unknown key 'kaa'; did you mean 'ka'?"));
}

TEST_CASE("run: what is recognised but not served exits 3, a deadlock exits 4") {
  const CommandLine cli;
  // Nothing about a cube moves along all axes and turns about none of them against its taught wrenches.
  write_text(cli / "s.lua",
             "return { object = 'cube', task = { T = { -1, -1, -1 }, R = { -0.8, -0.8, -0.8 } }, memory = 'm.memory',\n"
             "  thresholds = { estimation = 6 } }\n");
  const auto known = cli.run("run s.lua");
  INFO(known.out, known.err);
  CHECK(known.exit_code == 3);
  CHECK(contains(known.out, "recognised"));
  CHECK(contains(known.out, "correct the task"));
  const auto unknown = cli.run("run s.lua --set object=toy_plane");
  INFO(unknown.out, unknown.err);
  CHECK(unknown.exit_code == 4);
  CHECK(contains(unknown.out, "deadlock"));
}

TEST_CASE("run: on_report is the meta control that corrects the task and goes on") {
  const CommandLine cli;
  write_text(cli / "s.lua",
             "return { object = 'cube', task = { T = { -1, -1, -1 }, R = { -0.8, -0.8, -0.8 } }, memory = 'm.memory',\n"
             "  thresholds = { estimation = 6 },\n"
             "  on_report = function(report)\n"
             "    if not report.served then return { task = 'T1_2', thresholds = { estimation = 3 } } end\n"
             "  end }\n");
  const auto result = cli.run("run s.lua -q");
  INFO(result.out, result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.out, "recognised (mode 2)"));
  CHECK(contains(result.out, "T1_2, served"));
}

TEST_CASE("A script is taken from the current folder, else from those of the data path and the installation") {
  const CommandLine cli;
  CHECK(contains(cli.run("check scripts/scenarios/demo.lua").out, "share/preshape/scripts/scenarios/demo.lua: no mistakes"));
  std::filesystem::create_directories(cli / "scripts/scenarios");
  write_text(cli / "scripts/scenarios/demo.lua", "return { object = 'cube', task = 'T1_22' }\n");
  CHECK(contains(cli.run("check scripts/scenarios/demo.lua").err, "preshape: scripts/scenarios/demo.lua:1: "));
  const auto nowhere = cli.run("run scripts/nowhere.lua");
  CHECK(nowhere.exit_code == 5);
  CHECK(contains(nowhere.err, "'scripts/nowhere.lua'"));
}

TEST_CASE("check: every mistake at once, each with its line; nothing is run") {
  const CommandLine cli;
  write_text(cli / "s.lua",
             "return {\n  objekt = 'cube',\n  task = 'T1_22',\n  contact = { 'salisbury_soft_finger', ka = -1 },\n"
             "  similarity = 'tfvady',\n  thresholds = { estimaton = 3 },\n}\n");
  const auto result = cli.run("check s.lua");
  CHECK(result.exit_code == 5);
  CHECK(contains(result.err, "s.lua:2: unknown key 'objekt'; did you mean 'object'?"));
  CHECK(contains(result.err, "'object' is missing"));
  CHECK(contains(result.err, "s.lua:3: there is no task 'T1_22'; did you mean 'T1_2'?"));
  CHECK(contains(result.err, "s.lua:4: contact 'salisbury_soft_finger': 'ka' must be in 0 .. 10, got -1"));
  CHECK(contains(result.err, "s.lua:5: there is no similarity 'tfvady'; did you mean 'tfvadi'?"));
  CHECK(contains(result.err, "s.lua:6: thresholds: unknown key 'estimaton'; did you mean 'estimation'?"));
  const auto fine = cli.run("check '" + source_file("scripts/scenarios/demo.lua").string() + "'");
  CHECK(fine.exit_code == 0);
  CHECK(contains(fine.out, "no mistakes"));
}

TEST_CASE("explore: a table on the terminal, CSV in full precision, --all with the reasons") {
  const CommandLine cli;
  const auto table = cli.run("explore --object cube --task T1_2 --step 0.5");
  CHECK(table.exit_code == 0);
  CHECK(contains(table.out, "plane"));
  const auto csv = cli.run("explore --object box --task T1_2 --step 0.25 --csv -");
  CHECK(csv.exit_code == 0);
  CHECK(contains(csv.out, "plane,x/half,x_mm,symbol,vf,depth_U,fx,fy,fz,mx,my,mz,sta,manu,tfvadi,tfdist,status\r\n"));
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') == 1 + 12 * 7);
  CHECK(contains(cli.run("explore --object torus --step 0.25 --all").out, "passes the object by"));
  CHECK(cli.run("explore").exit_code == 2);
}

TEST_CASE("plugins: all, one with its parameters, machine-readable, and why") {
  const CommandLine cli;
  CHECK(contains(cli.run("plugins").out, "salisbury_soft_finger"));
  const auto one = cli.run("plugins salisbury_soft_finger");
  CHECK(contains(one.out, "0.45"));
  const auto json = nlohmann::json::parse(cli.run("plugins contact/salisbury_soft_finger --json").out);
  CHECK(json["kind"] == "contact");
  CHECK(json["parameters"][0]["name"] == "ka");
  CHECK(contains(cli.run("plugins fcl --why").out, "result:"));
  const auto absent = cli.run("plugins salisbury_soft_fingr");
  CHECK(absent.exit_code == 5);
  CHECK(contains(absent.err, "did you mean 'salisbury_soft_finger'?"));
}

TEST_CASE("objects, tasks, doctor, --version and --help say what they should and exit 0") {
  const CommandLine cli;
  const auto objects = cli.run("objects");
  CHECK(objects.exit_code == 0);
  for (const char* name : {"cube", "box", "sphere", "cylinder", "disc", "cone", "torus", "mug", "bottle", "dolphin", "toy_car",
                           "toy_plane", "hammer"}) {
    CHECK_MESSAGE(contains(objects.out, name), name);
  }
  CHECK_FALSE(contains(objects.out, " no\n"));
  CHECK(contains(cli.run("tasks --signs").out, "T4_6--"));
  const auto doctor = cli.run("doctor");
  INFO(doctor.out);
  CHECK(doctor.exit_code == 0);
  CHECK(contains(doctor.out, "Nothing to mend."));
  CHECK(contains(cli.run("--version").out, "preshape 0."));
  CHECK(contains(cli.run("run --help").out, "Examples:"));
}

TEST_CASE("Wrong use of the command exits 2 and says how it is used") {
  const CommandLine cli;
  CHECK(cli.run("").exit_code == 2);
  CHECK(cli.run("rnu s.lua").exit_code == 2);
  CHECK(cli.run("run").exit_code == 2);
  CHECK(cli.run("run s.lua --jsn x").exit_code == 2);
}

TEST_CASE("Output to a file holds no colour, whatever the environment") {
  const CommandLine cli;
  write_text(cli / "s.lua", "return { object = 'cube', task = 'T1_2', memory = 'm.memory' }\n");
  CHECK_FALSE(contains(cli.run("run s.lua").out, "\x1b["));
}

TEST_CASE("A study prints what it wants and returns its results as JSON") {
  const CommandLine cli;
  write_text(cli / "s.lua",
             "local rows = {}\n"
             "for i, task in ipairs(preshape.tasks()) do\n"
             "  if i <= 3 then rows[i] = preshape.estimate({ object = 'cube', task = task.name, memory = ':memory:' }).served end\n"
             "end\nprint('done')\nreturn { served = rows }\n");
  const auto result = cli.run("run s.lua --json r.json");
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(result.out == "done\n");
  CHECK(nlohmann::json::parse(read_text(cli / "r.json"))["served"].size() == 3);
}

TEST_SUITE_END();
