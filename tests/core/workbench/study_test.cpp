#include "preshape/workbench/script_host.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

/// Runs a study, which takes every object of the catalogue, with some alone. The cube is needed for pretraining.
Value study(const std::string& name, const std::vector<std::string>& objects, std::vector<std::string>& printed) {
  TemporaryDirectory shortened;
  std::filesystem::create_directory(shortened / "objects");
  for (const auto& object : objects) {
    std::filesystem::create_directory_symlink(source_file("objects") / object, shortened / "objects" / object);
  }
  std::filesystem::create_directory_symlink(source_file("hands"), shortened / "hands");
  const Catalogue catalogue({shortened.path()});
  ScriptHost host(registry(), catalogue, {});
  ScriptOptions options = script_options(catalogue, false, 1);
  options.print = [&](std::string_view line) { printed.emplace_back(line); };
  Script script(source_file("scripts/studies/" + name + ".lua"), options);
  host.add_to(script);
  return script.run();
}

}  // namespace

TEST_CASE("Study of coverage: run on two objects, its rows say that what a grasp serves is served after learning") {
  std::vector<std::string> printed;
  const Value rows = study("coverage", {"cube", "box"}, printed);
  REQUIRE(rows.is_list());
  CHECK(rows.items().size() == 2 * 84);
  int servable = 0, after = 0, before = 0, lost = 0;
  for (const Value& row : rows.items()) {
    const bool can = row.find("best")->number() >= 3.0;
    servable += can;
    before += row.find("before_mode")->integer() >= 0;
    after += row.find("after_mode")->integer() >= 0;
    if (can && row.find("after_mode")->integer() < 0) {
      // Recalled by likeness when it was run, so that it was not taught, and lost to a later lesson.
      CHECK(row.find("status")->string() == "served");
      lost += 1;
    }
    CHECK(row.find("after")->number() <= row.find("best")->number() + 1e-9);
    if (row.find("status")->string() == "learned") {
      INFO(row.find("object")->string(), " ", row.find("task")->string());
      CHECK(row.find("after_mode")->integer() >= 0);
    }
  }
  MESSAGE(servable, " servable, ", before, " served before, ", after, " after, ", lost, " lost");
  CHECK(after > before);
  CHECK(after <= servable);
  REQUIRE(!printed.empty());
  CHECK(printed.front().find("# Coverage of the task space") == 0);
}

TEST_CASE("Study of learning: taught two objects one after another, the default classifier forgets nothing and ends "
          "above 95 % of the exhaustive search's similarity on what it was taught") {
  std::vector<std::string> printed;
  const Value result = study("learning", {"box", "cube"}, printed);
  const auto last = [&](const char* classifier) { return result.find("stages")->find(classifier)->items().back(); };
  for (const Value& stage : result.find("stages")->find("mlp")->items()) {
    CHECK(stage.find("predicted")->integer() == stage.find("rows")->integer());
    CHECK(stage.find("taught_served")->integer() == stage.find("taught")->integer());
  }
  const Value mlp = last("mlp");
  CHECK(mlp.find("taught")->integer() >= 5);
  CHECK(mlp.find("rows")->integer() > 24 + mlp.find("taught")->integer());
  CHECK(mlp.find("taught_ratio")->number() > 0.95);
  CHECK(mlp.find("taught_ratio")->number() <= 1.0 + 1e-9);
  for (const char* exact : {"knn", "nadaraya_watson"}) {
    CHECK(last(exact).find("predicted")->integer() == last(exact).find("rows")->integer());
    CHECK(last(exact).find("taught_served")->integer() == last(exact).find("taught")->integer());
  }
  REQUIRE(!printed.empty());
  CHECK(printed.front().find("# Learning one object after another") == 0);
}

TEST_SUITE_END();
