#include "preshape/base/error.h"
#include "preshape/version.h"
#include "preshape/workbench/script_host.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

Value run(const std::string& text, ScriptHost::Options options = {}) {
  ScriptHost host(registry(), catalogue(), std::move(options));
  Script script = Script::from_text(text, "study.lua", script_options(catalogue(), false, 1));
  host.add_to(script);
  return script.run();
}

std::string error_of(const std::string& text) {
  try {
    run(text);
  } catch (const ScriptError& problem) {
    return problem.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("Script: tasks, objects, hands and the version are there to loop over") {
  const Value result = run(R"(
    return { tasks = #preshape.tasks(), signed = #preshape.tasks(true), first = preshape.tasks()[1],
             objects = preshape.objects(), hands = preshape.hands(), version = preshape.version })");
  CHECK(result.find("tasks")->integer() == 24);
  CHECK(result.find("signed")->integer() == 84);
  CHECK(result.find("first")->find("name")->string() == "T1_1");
  CHECK(*result.find("first")->find("T") == Value::numbers({1.0, 0.1, 1.0}));
  CHECK(*result.find("first")->find("R") == Value::numbers({0.05, 0.05, 0.8}));
  CHECK(result.find("objects")->items().size() == catalogue().objects().size());
  CHECK(*result.find("hands") == Value::list({"allegro", "barrett", "leap", "shadow", "utah_mit"}));
  CHECK(result.find("version")->string() == PRESHAPE_VERSION_STRING);
}

TEST_CASE("Script: taught counts the rows of the memory and those that the classifier predicts, so that one hardly trained "
          "predicts fewer") {
  const Value known = run(R"(
    local function known(classifier)
      local scenario = { object = "cube", task = "T1_1", memory = ":memory:", classifier = classifier }
      local empty = preshape.taught(scenario)
      preshape.estimate(scenario)
      local taught = preshape.taught(scenario)
      return { empty = empty.rows, rows = taught.rows, predicted = taught.predicted }
    end
    return { known("mlp"), known({ "mlp", max_epochs = 1, restarts = 0 }) })");
  for (const Value& one : known.items()) {
    CHECK(one.find("empty")->integer() == 0);
    CHECK(one.find("rows")->integer() == 24);
  }
  CHECK(known.items()[0].find("predicted")->integer() == 24);
  CHECK(known.items()[1].find("predicted")->integer() < 24);
}

TEST_CASE("Script: estimate learns nothing, run learns, and the session is kept from call to call") {
  const Value result = run(R"(
    local function s(task) return { object = "box", task = task, memory = ":memory:", learning = { policy = "learn" } } end
    local unserved
    for _, task in ipairs(preshape.tasks()) do
      local report = preshape.estimate(s(task.name))
      local best = preshape.best(s(task.name))
      if not report.served and best.first >= 3 then unserved = task.name; break end
    end
    local before = preshape.estimate(s(unserved))
    local lesson = preshape.run(s(unserved))
    local after = preshape.estimate(s(unserved))
    return { before = before.status, lesson = lesson.status, after = after.status, rows = lesson.lesson.rows_added })");
  CHECK(result.find("before")->string() == "recognised");
  CHECK(result.find("lesson")->string() == "learned");
  CHECK(result.find("after")->string() == "served");
  CHECK(result.find("rows")->integer() == 2);
}

TEST_CASE("Script: objects change from call to call with the memory kept") {
  const Value result = run(R"(
    local function s(object) return { object = object, task = "T1_1", memory = ":memory:" } end
    local names = {}
    for _, object in ipairs { "cube", "box", "cube" } do names[#names + 1] = preshape.estimate(s(object)).object.name end
    return names)");
  CHECK(result == Value::list({"cube", "box", "cube"}));
}

TEST_CASE("Script: best names the station that the explorers find") {
  const Value best = run("return preshape.best { object = \"cube\", task = \"T1_1\", memory = \":memory:\" }");
  CHECK((best.find("plane")->integer() >= 1 && best.find("plane")->integer() <= 12));
  CHECK(std::abs(best.find("approach")->number()) <= 0.95 + 1e-9);
  CHECK(best.find("first")->number() >= 3.0);
  CHECK(best.find("virtual_fingers")->integer() == 2);
  CHECK(best.find("evaluations")->integer() > 0);
}

TEST_CASE("Script: pretrain teaches the scenario's own object") {
  const Value lesson = run("return preshape.pretrain { object = \"box\", stations = { 0.25 }, memory = \":memory:\" }");
  // Of planes that give the box the same wrench only the first is taught.
  CHECK(lesson.find("rows_added")->integer() > 6);
  CHECK(lesson.find("rows_added")->integer() <= 12);
  CHECK(lesson.find("evaluations")->integer() == 12);
  CHECK(lesson.find("arrived")->boolean());
  CHECK(lesson.find("wrong_rows")->integer() == 0);
}

TEST_CASE("Script: mistakes are told at the line of the call or of the wrong value") {
  CHECK(error_of("\nreturn preshape.run { object = \"cube\", taks = \"T1_1\" }").find("study.lua:2: ") == 0);
  CHECK(error_of("preshape.run { object = \"cube\" }").find("preshape.run: 'task' is missing") != std::string::npos);
  CHECK(error_of("preshape.best { object = \"cube\" }").find("preshape.best: 'task' is missing") != std::string::npos);
  CHECK(error_of("preshape.run(3)").find("preshape.run: expected one table, got number") != std::string::npos);
  CHECK(error_of("preshape.run()").find("expected one table, got nothing") != std::string::npos);
  CHECK(error_of("preshape.rum {}").find("did you mean 'run'?") != std::string::npos);
}

TEST_CASE("Script: a session kept from an earlier call lends neither its task nor its object") {
  const std::string first = "preshape.estimate { object = \"cube\", task = \"T1_1\", memory = \":memory:\" }\n";
  CHECK(error_of(first + "preshape.estimate { object = \"cube\", memory = \":memory:\" }").find("study.lua:2: preshape.estimate: 'task' is missing") == 0);
  CHECK(error_of(first + "preshape.estimate { task = \"T1_1\", memory = \":memory:\" }").find("study.lua:2: 'object' is missing") == 0);
}

TEST_CASE("Script: the host's memory overrides every scenario's") {
  TemporaryDirectory folder;
  const auto file = folder / "shared.memory";
  run("preshape.estimate { object = \"cube\", task = \"T1_1\", memory = \":memory:\" }", {file.string(), nullptr});
  CHECK(Memory::open(file, Memory::Mode::kReadOnly).statistics().pretrain_samples == 24);
}

TEST_SUITE_END();
