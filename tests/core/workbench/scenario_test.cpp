#include "preshape/base/error.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

/// Whether a mistake at that line says that part.
bool told(const ScenarioReading& reading, int line, const std::string& part) {
  for (const Mistake& mistake : reading.mistakes) {
    if (mistake.place.line == line && mistake.sentence.find(part) != std::string::npos) return true;
  }
  MESSAGE("line ", line, " lacks '", part, "' among\n", mistakes_of(reading));
  return false;
}

}  // namespace

TEST_CASE("Scenario: every kind of mistake is told at once, each at its line and with the mend") {
  const auto reading = read_text(R"(return {
  objcet = "cube",
  task = "T9_1",
  contact = "salisbury_soft_fingr",
  similarity = { "tfvadi", sharpness = 2 },
  explorer = { "beam", width = 0 },
  thresholds = { estimaton = 3 },
  analysis = { station_step = "fine" },
  learning = { policy = "lern" },
  classifier = 7,
  planes = { { approach = "+X", push = "+X" } },
  fuzzy = { { name = "low", trapezoid = { 1, 0, 2, 3 } } },
  hand = "utah_mti",
  seed = -1,
  on_report = "go on",
  pretrain = "cbue",
  quality = { "sta_manu", { "sta_mnu" } },
  symbols = { { name = "near", trapezium = { 0, 1, 2, 3 } } },
  tie_break = { "tfdist", "tfvadi", p = 1 } ~= nil and "tfdits",
  memory = 5,
})");
  CHECK(told(reading, 1, "'object' is missing"));
  CHECK(told(reading, 2, "unknown key 'objcet'; did you mean 'object'?"));
  CHECK(told(reading, 3, "there is no task 'T9_1'"));
  CHECK(told(reading, 4, "there is no contact 'salisbury_soft_fingr'; did you mean 'salisbury_soft_finger'?"));
  CHECK(told(reading, 5, "unknown key 'sharpness'"));
  CHECK(told(reading, 6, "'width' must be in 1 .. 1000, got 0"));
  CHECK(told(reading, 7, "unknown key 'estimaton'; did you mean 'estimation'?"));
  CHECK(told(reading, 8, "'station_step' must be a number, got string"));
  CHECK(told(reading, 9, "'policy' cannot be 'lern'; did you mean 'learn'?"));
  CHECK(told(reading, 10, "'classifier' is a name or { \"name\", key = value }, got 7"));
  CHECK(told(reading, 11, "right angles"));
  CHECK(told(reading, 12, "a trapezoid needs 4 numbers (a <= b <= c <= d)"));
  CHECK(told(reading, 13, "there is no hand 'utah_mti'; did you mean 'utah_mit'?"));
  CHECK(told(reading, 14, "'seed' must be in 0 .. "));
  CHECK(told(reading, 15, "'on_report' must be a function, got string"));
  CHECK(told(reading, 16, "there is no object 'cbue'; did you mean 'cube'?"));
  CHECK(told(reading, 17, "there is no quality 'sta_mnu'; did you mean 'sta_manu'?"));
  CHECK(told(reading, 18, "unknown key 'trapezium'; did you mean 'trapezoid'?"));
  CHECK(told(reading, 19, "there is no similarity 'tfdits'; did you mean 'tfdist'?"));
  CHECK(told(reading, 20, "'memory' must be a string, got number 5"));
  for (const Mistake& mistake : reading.mistakes) {
    CHECK(mistake.place.file == "scenario.lua");
    CHECK(mistake.sentence.find('\n') == std::string::npos);
  }
}

TEST_CASE("Scenario: all mistakes of an object's and a task's table are told at once") {
  const auto reading = read_text(R"(return {
  object = {
    nmae = "cube",
    fit = -1,
    unit = "furlong",
    weld = 0.05,
  },
  task = {
    T = { 1, 2, "three" },
    stability = 7,
    aproach = "X",
  },
})");
  CHECK(told(reading, 3, "unknown key 'nmae'; did you mean 'name'?"));
  CHECK(told(reading, 4, "'fit' must be"));
  CHECK(told(reading, 5, "'unit' cannot be 'furlong'"));
  CHECK(told(reading, 6, "'weld' must be in 0 .. 0.01, got 0.05"));
  CHECK(told(reading, 9, "'T' element 3 must be a number, got \"three\""));
  CHECK(told(reading, 10, "'stability' must be in 0 .. 6, got 7"));
  CHECK(told(reading, 11, "unknown key 'aproach'; did you mean 'approach'?"));
}

TEST_CASE("Scenario: what it returns must be a table with object and task; a pretraining script has no task") {
  CHECK(mistakes_of(read_text("return 3")).find("a scenario returns a table, this returns number 3") != std::string::npos);
  CHECK(mistakes_of(read_text("return { object = \"cube\" }")).find("'task' is missing") != std::string::npos);
  CHECK(read_text("return { object = \"cube\" }", ScenarioUse::kPretrain).mistakes.empty());
  CHECK(mistakes_of(read_text("return { task = \"T1_1\" }", ScenarioUse::kPretrain)).find("'object' is missing") != std::string::npos);
}

TEST_CASE("Scenario: what is not said has the defaults of the specification") {
  const auto reading = read_text("return { object = \"cube\", task = \"T1_1\" }");
  REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
  const Scenario& s = reading.scenario;
  CHECK(s.contact.name == "salisbury_soft_finger");
  CHECK(s.similarity.name == "tfvadi");
  CHECK(s.tie_break.name == "tfdist");
  CHECK(s.classifier.name == "mlp");
  CHECK(s.collision.name == "fcl");
  CHECK(s.explorer.name == "beam");
  CHECK(s.proof.name == "exhaustive");
  REQUIRE(s.quality.size() == 1);
  CHECK(s.quality[0].name == "sta_manu");
  CHECK(s.hand.name == "utah_mit");
  CHECK(s.hand.model == "dh");
  const Thresholds thresholds = Thresholds::from(s.thresholds);
  CHECK(thresholds.estimation == 3.0);
  CHECK(thresholds.recognition == 5.5);
  CHECK(thresholds.search == 0.5);
  CHECK(AnalysisSettings::from(s.analysis).length_U == 6.0);
  CHECK(LearningSettings::from(s.learning).policy == LearningSettings::Policy::kAsk);
  CHECK(LearningSettings::from(s.learning).teach == LearningSettings::Teach::kBoth);
  CHECK(s.planes.size() == 12);
  CHECK(s.sets.size() == 7);
  CHECK(s.symbols.size() == 7);
  CHECK(s.memory == "default");
  CHECK(s.pretrain == "cube");
  CHECK(s.pretraining.stations == std::vector<double>{-0.25, 0.25});
  CHECK(s.seed == 1);
  CHECK_FALSE(s.on_report);
}

TEST_CASE("Scenario: a component's parameters are kept, and its name is not one of them") {
  const auto reading = read_text(
      "return { object = \"cube\", task = \"T1_1\", contact = { \"salisbury_soft_finger\", ka = 0.3 }, quality = \"sta_manu\", explorer = { \"beam\" } }");
  REQUIRE(reading.mistakes.empty());
  CHECK(reading.scenario.contact.name == "salisbury_soft_finger");
  CHECK(reading.scenario.contact.parameters == Value::table({{"ka", 0.3}}));
  CHECK(reading.scenario.quality.size() == 1);
  CHECK(reading.scenario.explorer.name == "beam");
  CHECK(reading.scenario.explorer.parameters.is_nil());
}

TEST_CASE("Scenario: planes, sets, settings and a callback are taken as given") {
  const auto reading = read_text(R"(return {
    object = "cube", task = "T1_1", seed = 42, memory = ":memory:", pretrain = "none", stations = { 0 },
    planes = { { approach = "+X", push = "-Y" }, { approach = { 0, 0, 2 }, push = "+X" } },
    symbols = { { name = "far", trapezoid = { -2, -1, -0.5, 0.1 } }, { name = "near", trapezoid = { -0.1, 0.5, 1, 2 } } },
    thresholds = { estimation = 4 }, analysis = { virtual_fingers = "any" }, learning = { policy = "learn", teach = "task" },
    on_report = function() end })");
  REQUIRE_MESSAGE(reading.mistakes.empty(), mistakes_of(reading));
  const Scenario& s = reading.scenario;
  CHECK(s.planes.size() == 2);
  CHECK(s.planes[1].a == Eigen::Vector3d::UnitZ());
  CHECK(s.symbols.size() == 2);
  CHECK(s.seed == 42);
  CHECK(s.pretrain == "none");
  CHECK(s.pretraining.stations == std::vector<double>{0.0});
  CHECK(Thresholds::from(s.thresholds).estimation == 4.0);
  CHECK(AnalysisSettings::from(s.analysis).free_virtual_fingers);
  CHECK(LearningSettings::from(s.learning).teach == LearningSettings::Teach::kTask);
  CHECK(s.on_report);
}

TEST_CASE("Scenario: every key that is read is described, and no other") {
  for (const ScenarioKey& key : scenario_keys()) {
    CHECK_FALSE(key.text.empty());
    const auto reading = read_text("return { object = \"cube\", task = \"T1_1\", [\"" + key.name + "\"] = 1e300 }");
    CHECK(mistakes_of(reading).find("unknown key '" + key.name + "'") == std::string::npos);
    CHECK_MESSAGE(!reading.mistakes.empty(), key.name, " takes anything");
  }
}

TEST_SUITE_END();
