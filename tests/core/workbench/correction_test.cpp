#include <algorithm>

#include "preshape/base/error.h"
#include "preshape/grasp/task_space.h"
#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

namespace {

std::string scenario(const std::string& object, const std::string& task, const std::string& more = "") {
  return "return { object = \"" + object + "\", task = \"" + task + "\", memory = \":memory:\"" + (more.empty() ? "" : ", " + more) + " }";
}

Value change(const char* key, Value value) { return Value::table({{key, std::move(value)}}); }

/// A task that the pretrained cube does not recall.
std::string unrecalled_task() {
  Session session = session_of(scenario("cube", "T1_1"));
  session.pretrain_if_empty();
  for (const Task& task : signed_task_space()) {
    session.change(change("task", task.name));
    if (!session.estimate().report.served()) return task.name;
  }
  FAIL("the cube recalls every task");
  return "";
}

}  // namespace

TEST_CASE("Session: an empty memory is taught the pretraining object once") {
  Session session = session_of(scenario("cube", "T1_1"));
  const auto lesson = session.pretrain_if_empty();
  REQUIRE(lesson);
  CHECK(lesson->rows_added == 24);
  CHECK_FALSE(session.pretrain_if_empty());
  const RunRecord record = session.run();
  CHECK(record.report.status == RunStatus::kServed);
  CHECK(record.object->object.name == "cube");
  CHECK(record.memory == "(in memory)");
}

TEST_CASE("Session: with pretrain = none nothing is taught, and a run says what to do") {
  Session session = session_of(scenario("cube", "T1_1", "pretrain = \"none\""));
  CHECK_FALSE(session.pretrain_if_empty());
  CHECK_THROWS_SAYING(session.run(), InputError, "pretrain it first");
}

TEST_CASE("Session: thresholds beyond the measure, a missing mesh and a missing measure are told when it is made") {
  CHECK_THROWS_SAYING(session_of(scenario("cube", "T1_1", "thresholds = { estimation = 7 }")), InputError, "goes from 0 to 6");
  CHECK_THROWS_SAYING(session_of(scenario("./nothing.obj", "T1_1")), InputError, "nothing.obj");
  CHECK_THROWS_SAYING(session_of(scenario("cube", "T1_1", "quality = {}")), InputError, "add 'sta_manu' to quality");
}

TEST_CASE("Session: a lesson in a memory file is there for the next session") {
  TemporaryDirectory folder;
  const Session::Options options{(folder / "deep/er/agent.memory").string(), nullptr, nullptr};
  {
    Session session = session_of(scenario("box", "T1_2", "learning = { policy = \"learn\" }"), options);
    session.pretrain_if_empty();
    CHECK(session.run().report.served());
  }
  Session again = session_of(scenario("box", "T1_2"), options);
  CHECK_FALSE(again.pretrain_if_empty());
  CHECK(again.run().report.status == RunStatus::kServed);
}

TEST_CASE("Meta control: the task is corrected from the report, until it is served") {
  const std::string unrecalled = unrecalled_task();
  Session session = session_of(scenario("cube", unrecalled));
  session.pretrain_if_empty();
  std::vector<std::string> seen;
  const auto records = session.run([&](const Value& report) {
    seen.push_back(report.find("status")->string());
    return seen.size() == 1 ? change("task", report.find("nearest")->find("task")->find("name")->string()) : Value{};
  });
  CHECK(seen == std::vector<std::string>{"recognised", "served"});
  REQUIRE(records.size() == 2);
  CHECK(records[0].report.task.name == unrecalled);
  CHECK(records[1].report.task.name == records[0].report.nearest->task.name);
  CHECK(session.scenario().task->name == records[1].report.task.name);
}

TEST_CASE("Meta control: thresholds are corrected one by one, the others stay") {
  Session session = session_of(scenario("cube", "T1_1", "thresholds = { recognition = 5 }"));
  session.pretrain_if_empty();
  session.change(change("thresholds", Value::table({{"estimation", 2.5}})));
  const Thresholds now = session.run().report.thresholds;
  CHECK(now.estimation == 2.5);
  CHECK(now.recognition == 5.0);
  CHECK(now.search == 0.5);
}

TEST_CASE("Meta control: another object is loaded in the place of the first") {
  Session session = session_of(scenario("cube", "T1_1"));
  session.pretrain_if_empty();
  session.change(change("object", "box"));
  CHECK(session.object().object.name == "box");
  CHECK_NEAR(session.object().object.box_O.extents(), 0.03 * Eigen::Vector3d(1.05, 4.1, 2.03), 1e-7);
  CHECK(session.run().object->object.name == "box");
}

TEST_CASE("Meta control: a correction resets a deadlock") {
  Session session = session_of(scenario("box", "T1_2", "thresholds = { estimation = 6, recognition = 6 }"));
  session.pretrain_if_empty();
  CHECK(session.run().report.status == RunStatus::kDeadlock);
  CHECK_THROWS_SAYING(session.run(), InputError, "in deadlock");
  session.change(change("task", "T1_3"));
  CHECK_NOTHROW(session.run());
}

TEST_CASE("Meta control: a wrong correction is told with the nearest right key") {
  Session session = session_of(scenario("cube", "T1_1"));
  CHECK_THROWS_SAYING(session.change(change("taks", "T1_1")), InputError, "unknown key 'taks'; did you mean 'task'?");
  CHECK_THROWS_SAYING(session.change(Value(3)), InputError, "'on_report' returns nil or a table, got number 3");
  CHECK_THROWS_SAYING(session.change(change("task", "T1_9")), InputError, "there is no task 'T1_9'");
  CHECK_THROWS_SAYING(session.change(change("object", "cuba")), InputError, "did you mean 'cube'?");
  CHECK_THROWS_SAYING(session.change(change("thresholds", Value::table({{"serach", 0.1}}))), InputError, "did you mean 'search'?");
  CHECK_THROWS_SAYING(session.change(change("thresholds", 3)), InputError, "expected a table of parameters, got number 3");
}

TEST_CASE("Meta control: corrections without end are stopped") {
  Session session = session_of(scenario("cube", "T1_1"));
  session.pretrain_if_empty();
  int reports = 0;
  const auto control = [&](const Value&) { return ++reports, change("task", reports % 2 ? "T1_1" : "T1_2"); };
  CHECK_THROWS_SAYING(session.run(control), InputError, "has corrected the task 1000 times; let it return nil to stop");
  CHECK(reports == kMostCorrections);
}

TEST_CASE("Workspace: every plane at every station of the grid, judged before the task") {
  Session session = session_of(scenario("box", "T1_2"));
  const auto rows = session.workspace(0.05);
  CHECK(rows.size() == 12 * 39);
  double best = 0.0;
  for (const auto& row : rows) {
    CHECK(row.preshape.plane == row.grasp.plane + 1);
    if (row.grasp.is_grasp()) best = std::max(best, row.criticism.first);
  }
  const auto found = session.best();
  REQUIRE(found.best);
  // The explorers search the same grid; the first is content with what serves.
  CHECK(found.best->criticism.first <= best);
  CHECK(found.best->criticism.first >= 3.0);
}

TEST_SUITE_END();
