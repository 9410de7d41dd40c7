#include "preshape/base/error.h"
#include "preshape/workbench/variants.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

Value described(const std::string& table) {
  return Script::from_text("return " + table, "scenario.lua").run();
}

Variants variants(const std::string& table) { return variants_of(described(table), registry()); }

/// "T1_2 hard_finger 0.4": the choices of a row.
std::string row(const Variants& variants, std::size_t i) {
  std::string text;
  for (const Value& choice : variants.all.at(i).choices) text += (text.empty() ? "" : " ") + choice.text();
  return text;
}

Comparison compared(const std::string& table) {
  return compare(variants(table), "scenario.lua", registry(), catalogue(), {}, {});
}

}  // namespace

TEST_CASE("Variants: a scenario that chooses one of everything is its own only variant") {
  const char* scenario =
      "{ object = 'mug', task = { 1, 1, 0.1, 0.05, 0.8, 0.05 }, contact = { 'hard_finger' }, quality = { 'sta_manu', 'grasp_matrix' },"
      "  stations = { -0.25, 0.25 }, analysis = { transverse_offsets = { -0.5, 0, 0.5 } }, classifier = { 'mlp', fields = { 4, 3, 2 } },"
      "  planes = { { approach = '+X', push = '-Y' } }, fuzzy = { { name = 'a', triangle = { -1, 0, 1 } } } }";
  const Variants found = variants(scenario);
  CHECK(found.keys.empty());
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].description == described(scenario));
  CHECK(found.all[0].choices.empty());
}

TEST_CASE("Variants: lists of objects, tasks, components, parameters, settings and seeds are combined, the last turning fastest") {
  const Variants found = variants(
      "{ seed = { 1, 2 }, object = { 'mug', 'cube' }, contact = { 'hard_finger', mu = { 0.4, 0.6 } }, thresholds = { estimation = { 2, 3 } },"
      "  task = { 'T1_2', { 1, 1, 0.1, 0.05, 0.8, 0.05 } } }");
  CHECK(found.keys == std::vector<std::string>{"object", "task", "contact.mu", "thresholds.estimation", "seed"});
  REQUIRE(found.all.size() == 32);
  CHECK(row(found, 0) == "\"mug\" \"T1_2\" 0.4 2 1");
  CHECK(row(found, 1) == "\"mug\" \"T1_2\" 0.4 2 2");
  CHECK(row(found, 2) == "\"mug\" \"T1_2\" 0.4 3 1");
  CHECK(row(found, 31) == "\"cube\" { 1, 1, 0.1, 0.05, 0.8, 0.05 } 0.6 3 2");
  const Value& last = found.all[31].description;
  CHECK(last.find("object")->string() == "cube");
  CHECK(last.find("contact")->find("mu")->number() == 0.6);
  CHECK(last.find("contact")->find("name")->string() == "hard_finger");
  CHECK(last.find("thresholds")->find("estimation")->number() == 3.0);
  CHECK(last.find("seed")->integer() == 2);
}

TEST_CASE("Variants: what takes a list is varied by a list of lists") {
  const Variants found = variants(
      "{ object = 'cube', task = 'T1_2', analysis = { transverse_offsets = { { 0 }, { -0.5, 0, 0.5 } } },"
      "  planes = { { directions = 10 }, { { approach = '+X', push = '-Y' } } } }");
  CHECK(found.keys == std::vector<std::string>{"analysis.transverse_offsets", "planes"});
  REQUIRE(found.all.size() == 4);
  CHECK(found.all[0].description.find("planes")->find("directions")->integer() == 10);
  CHECK(found.all[3].description.find("planes")->items().size() == 1);
  CHECK(found.all[3].description.find("analysis")->find("transverse_offsets")->items().size() == 3);
}

TEST_CASE("Variants: a choice may have lists of its own, which leave a gap in the rows of the others") {
  const Variants found = variants("{ object = 'cube', task = 'T1_2', contact = { 'frictionless_point', { 'hard_finger', mu = { 0.4, 0.6 } } } }");
  CHECK(found.keys == std::vector<std::string>{"contact", "contact.mu"});
  REQUIRE(found.all.size() == 3);
  CHECK(found.all[0].choices[1].is_nil());
  CHECK(found.all[2].choices[1].number() == 0.6);
  CHECK(found.all[2].description.find("contact")->find("mu")->number() == 0.6);
}

TEST_CASE("Variants: a budget is a choice like any parameter of an explorer") {
  const Variants found = variants("{ object = 'cube', task = 'T1_2', explorer = { budget = { 10, 100 } } }");
  CHECK(found.keys == std::vector<std::string>{"explorer.budget"});
  CHECK(found.all.size() == 2);
}

TEST_CASE("Variants: more than a thousand combinations are refused before any is made") {
  const std::string numbers = "{ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }";
  const std::string text = "{ object = 'cube', task = 'T1_2', seed = { 1, 2 }, contact = { ka = " + numbers + ", ko = " + numbers + ", mn = " + numbers + " } }";
  CHECK_THROWS_SAYING(variants(text), InputError, "more than 1000 combinations");
}

TEST_CASE("Comparison: each row is what the scenario gives with that choice alone, and nothing that is learned is kept") {
  const TemporaryDirectory folder;
  const std::string memory = (folder / "m.memory").string(), task = "T4_6--";
  const auto scenario = [&](const std::string& contact) {
    return "{ object = 'box', task = '" + task + "', memory = '" + memory + "', contact = " + contact + " }";
  };
  const Comparison comparison = compared(scenario("{ 'salisbury_soft_finger', 'hard_finger', 'salisbury_soft_finger' }"));
  REQUIRE(comparison.runs.size() == 3);
  CHECK_FALSE(std::filesystem::exists(memory));
  for (const ComparedRun& run : comparison.runs) {
    REQUIRE(run.record);
    auto reading = read_scenario(described(scenario(run.choices[0].text())), "scenario.lua", ScenarioUse::kRun, registry(), catalogue());
    Session alone(std::move(reading.scenario), registry(), catalogue(), {":memory:", nullptr, nullptr});
    alone.pretrain_if_empty();
    const RunRecord record = alone.run();
    CHECK(record.report.status == run.record->report.status);
    CHECK(record.report.mode == run.record->report.mode);
    REQUIRE(record.report.result.has_value());
    CHECK(record.report.result->criticism.first == run.record->report.result->criticism.first);
  }
  // The third row would be served at once if it knew what the first has learned.
  CHECK(comparison.runs[2].record->report.mode == comparison.runs[0].record->report.mode);
}

TEST_CASE("Comparison: a row starts from what its memory holds, and leaves the file as it was") {
  const TemporaryDirectory folder;
  const std::string memory = (folder / "m.memory").string();
  const std::string base = "{ object = 'dolphin', task = 'T4_1', memory = '" + memory + "'";
  auto reading = read_scenario(described(base + " }"), "scenario.lua", ScenarioUse::kRun, registry(), catalogue());
  {
    Session taught(std::move(reading.scenario), registry(), catalogue(), {});
    taught.pretrain_if_empty();
    taught.run();
  }
  const auto rows = Memory::open(memory, Memory::Mode::kReadOnly).statistics().samples();
  const Comparison comparison = compared(base + ", classifier = { 'mlp', 'knn' } }");
  for (const ComparedRun& run : comparison.runs) {
    REQUIRE(run.record);
    CHECK(run.record->report.mode <= 1);
  }
  CHECK(Memory::open(memory, Memory::Mode::kReadOnly).statistics().samples() == rows);
}

TEST_CASE("Comparison: a combination that is refused is told in its row, and the others run") {
  const Comparison comparison = compared(
      "{ object = 'cube', task = 'T1_2', memory = ':memory:', thresholds = { estimation = 3, recognition = 5.5 }, similarity = { 'tfvadi', 'cosine_crisp' } }");
  REQUIRE(comparison.runs.size() == 2);
  CHECK(comparison.runs[0].record.has_value());
  CHECK_FALSE(comparison.runs[1].record.has_value());
  CHECK(comparison.runs[1].refusal.find("range") != std::string::npos);
  const std::string text = comparison_text(comparison, false);
  CHECK(text.find("refused") != std::string::npos);
  CHECK(text.find("row 2: " + comparison.runs[1].refusal) != std::string::npos);
  const Value data = comparison_value(comparison);
  CHECK(data.find("rows")->items()[1].find("refusal")->string() == comparison.runs[1].refusal);
  CHECK(data.find("rows")->items()[0].find("report")->find("status")->string() == "served");
}

TEST_CASE("Comparison: the mistakes of all combinations are told once each before any is run") {
  try {
    compared("{ object = 'cube', task = { 'T1_2', 'T1_3' }, contact = { 'hard_fingr', { 'hard_finger', mu = { 0.4, -1 } } } }");
    FAIL("nothing was refused");
  } catch (const ScriptError& error) {
    const std::string text = error.what();
    CHECK(text.find("did you mean 'hard_finger'?") != std::string::npos);
    CHECK(text.find("'mu' must be in") != std::string::npos);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
  }
}

TEST_CASE("Comparison: cells that differ from the first row have a star, those that do not have none") {
  Comparison comparison{"s.lua", {"seed"}, {}};
  for (const double second : {0.010, 0.012, 0.020}) {
    RunRecord record;
    record.measure = "tfvadi", record.second_measure = "tfdist";
    record.report.status = RunStatus::kServed;
    record.report.result.emplace();
    record.report.result->grasp.status = VirtualGrasp::Status::kGrasp;
    record.report.result->criticism.first = second > 0.015 ? 3.2 : 3.7;
    record.timings = {{"controller", second}};
    comparison.runs.push_back({{Value(1)}, std::move(record), ""});
  }
  const std::string text = comparison_text(comparison, false);
  CHECK(text.find("3.20*") != std::string::npos);
  CHECK(text.find("3.70*") == std::string::npos);
  CHECK(text.find("20.0*") != std::string::npos);
  CHECK(text.find("12.0*") == std::string::npos);
  CHECK(text.find("served (0)*") == std::string::npos);
}

TEST_SUITE_END();
