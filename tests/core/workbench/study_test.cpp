#include "preshape/workbench/script_host.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

TEST_CASE("Study of coverage: run on two objects, its rows say that what a grasp serves is served after learning") {
  // The study takes every object of the catalogue: this one has the cube, which pretraining needs, and the box.
  TemporaryDirectory shortened;
  std::filesystem::create_directory(shortened / "objects");
  for (const char* name : {"cube", "box"}) {
    std::filesystem::create_directory_symlink(source_file("objects") / name, shortened / "objects" / name);
  }
  std::filesystem::create_directory_symlink(source_file("hands"), shortened / "hands");
  const Catalogue catalogue({shortened.path()});
  ScriptHost host(registry(), catalogue, {});
  ScriptOptions options = script_options(catalogue, false, 1);
  std::vector<std::string> printed;
  options.print = [&](std::string_view line) { printed.emplace_back(line); };
  Script script(source_file("scripts/studies/coverage.lua"), options);
  host.add_to(script);
  const Value rows = script.run();

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

TEST_SUITE_END();
