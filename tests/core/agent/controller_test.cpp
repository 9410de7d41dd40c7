#include <algorithm>

#include "preshape/base/error.h"
#include "support/agent.h"
#include "support/near.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

Agent pretrained(LearningSettings::Policy policy = LearningSettings::Policy::kAsk, Thresholds thresholds = {}) {
  Agent::Options options;
  options.learning.policy = policy;
  options.thresholds = thresholds;
  Agent agent(options);
  agent.pretrain();
  return agent;
}

std::vector<Task> tasks_of(std::string_view categories) {
  std::vector<Task> tasks = signed_task_space();
  std::erase_if(tasks, [&](const Task& task) { return categories.find(task.name[1]) == std::string_view::npos; });
  return tasks;
}

/// Nothing reaches these, so that nothing is ever served or recognised.
constexpr Thresholds kOutOfReach{6.0, 6.0, 0.5};

}  // namespace

TEST_CASE("Controller: the pretrained cube serves every pivot and twiddle in mode 0 or 1") {
  const Agent agent = pretrained();
  const auto cube = agent.shipped("cube");
  const auto tasks = tasks_of("123");
  CHECK(tasks.size() == 60);
  for (const Task& task : tasks) {
    const Report report = agent.controller->run(*cube, task);
    INFO(task.name);
    CHECK(report.status == RunStatus::kServed);
    CHECK(report.mode <= 1);
    REQUIRE(report.result);
    CHECK(agent.serves(*report.result));
    CHECK(report.attempts.size() == static_cast<std::size_t>(report.mode) + 1);
    CHECK(report.attempts.back().rewarded);
    CHECK_FALSE(report.nearest);
    CHECK_FALSE(report.lesson);
  }
}

TEST_CASE("Controller: a task that the cube does not recall ends in mode 2 with a nearest task, which is then served") {
  const Agent agent = pretrained();
  const auto cube = agent.shipped("cube");
  int recognised = 0, servable = 0;
  for (const Task& task : tasks_of("4")) {
    const Report report = agent.controller->run(*cube, task);
    INFO(task.name);
    if (report.served()) continue;
    ++recognised;
    CHECK(report.status == RunStatus::kRecognised);
    CHECK(report.mode == 2);
    CHECK(report.attempts.back().rewarded);
    CHECK_FALSE(report.lesson);
    REQUIRE(report.nearest);
    CHECK(report.nearest->task.screw != task.screw);
    CHECK(agent.serves(report.nearest->grasp));
    const Report corrected = agent.controller->run(*cube, report.nearest->task);
    CHECK(corrected.status == RunStatus::kServed);
    if (report.unrecalled) {
      ++servable;
      CHECK(agent.serves(*report.unrecalled));
      CHECK(report.verdict.find("learning.policy") != std::string::npos);
    }
  }
  CHECK(recognised > 0);
  CHECK(servable > 0);
  CHECK(agent.memory->samples().size() == 24);  // asking teaches nothing
}

TEST_CASE("Controller: with the policy to learn, what a grasp of the cube would serve is learned and then served") {
  const Agent agent = pretrained(LearningSettings::Policy::kLearn);
  const auto cube = agent.shipped("cube");
  std::vector<Task> learned;
  for (const Task& task : tasks_of("4")) {
    const Report report = agent.controller->run(*cube, task);
    INFO(task.name);
    if (report.status == RunStatus::kRecognised) {
      CHECK_FALSE(report.unrecalled);
      continue;
    }
    CHECK(report.served());
    if (report.status == RunStatus::kLearned) learned.push_back(task);
  }
  CHECK(!learned.empty());
  for (const Task& task : learned) {
    const Report again = agent.controller->run(*cube, task);
    INFO(task.name);
    CHECK(again.status == RunStatus::kServed);
    CHECK(again.mode <= 1);
  }
  // What was served before without being taught may have to be learned now, but is served.
  for (const Task& task : tasks_of("123")) CHECK(agent.controller->run(*cube, task).served());
}

TEST_CASE("Controller: what even an exhaustive search does not serve ends in deadlock, until it is reset") {
  const Agent agent = pretrained(LearningSettings::Policy::kAsk, kOutOfReach);
  const auto box = agent.shipped("box");
  const Task task = named_task("T1_2");
  const Report report = agent.controller->run(*box, task);
  CHECK(report.status == RunStatus::kDeadlock);
  CHECK(report.mode == 3);
  CHECK(report.verdict.find("Deadlock: even the best of") == 0);
  CHECK_FALSE(report.nearest);
  REQUIRE(report.result);
  // It is the best there is: the exhaustive search's.
  const auto best = agent.learning->explore(*box, task, nullptr).best;
  CHECK(report.result->criticism.first == best->criticism.first);
  CHECK(agent.controller->deadlocked());
  CHECK_THROWS_SAYING(agent.controller->run(*box, task), InputError, "the controller is in deadlock; reset it");
  agent.controller->reset();
  CHECK_FALSE(agent.controller->deadlocked());
  CHECK_NOTHROW(agent.controller->run(*box, task));
}

TEST_CASE("Controller: an object without any grasp ends in deadlock with that said, and teaches nothing") {
  Agent::Options options;
  options.analysis.opposition_angle_deg = 0.0;
  Agent agent(options);
  agent.pretrain();
  const Report report = agent.controller->run(*agent.analysis.sense(tetrahedron(), "spike"), named_task("T1_2"));
  CHECK(report.status == RunStatus::kDeadlock);
  CHECK_FALSE(report.result);
  CHECK(report.verdict.find("stations has a grasp") != std::string::npos);
  CHECK(agent.memory->samples().size() == 24);
}

TEST_CASE("Controller: asked before anything was learned, it says so") {
  Agent agent;
  CHECK_THROWS_SAYING(agent.controller->run(*agent.shipped("cube"), named_task("T1_1")), InputError,
                      "the classifier has learned nothing yet; pretrain it first");
}

TEST_CASE("Controller: an estimate tries modes 0 and 1 alone and leaves the memory as it is") {
  const Agent agent = pretrained(LearningSettings::Policy::kLearn);
  const auto box = agent.shipped("box");
  const auto generation = agent.memory->generation();
  const std::string classifier = agent.classifier->save();
  int unserved = 0;
  for (const Task& task : signed_task_space()) {
    const Report report = agent.controller->estimate(*box, task);
    CHECK(report.mode <= 1);
    CHECK(report.attempts.size() <= 2);
    CHECK_FALSE(report.lesson);
    CHECK((report.status == RunStatus::kServed) == report.attempts.back().rewarded);
    if (!report.served()) ++unserved;
  }
  CHECK(unserved > 0);
  CHECK(agent.memory->generation() == generation);
  CHECK(agent.classifier->save() == classifier);
}

TEST_CASE("Controller: mode 1 finds the best station of the recalled plane within the window") {
  const Agent agent = pretrained(LearningSettings::Policy::kAsk, {5.0, 5.5, 0.8});
  const auto box = agent.shipped("box");
  int looked = 0;
  for (const Task& task : signed_task_space()) {
    const Report report = agent.controller->estimate(*box, task);
    if (report.attempts.size() < 2 || !report.attempts[1].score) continue;
    const Performance recalled = agent.performance->perform(*box, task);
    const double x0 = recalled.grasp.approach_fraction;
    double best = -1.0;
    for (int k = -19; k <= 19; ++k) {
      if (std::abs(k * 0.05 - x0) > 0.4 + 1e-9) continue;
      const auto grasp = agent.analysis.analyser->analyse(*box, {recalled.preshape.plane - 1, k * 0.05, 0});
      if (grasp.is_grasp()) best = std::max(best, agent.critic->judge(task.screw, components(grasp.resultant)).first);
    }
    CHECK(*report.attempts[1].score == best);
    ++looked;
  }
  CHECK(looked > 10);
}

TEST_CASE("Controller: an unserved report shows the best of what was tried, be it mode 0's or mode 1's") {
  Agent::Options options;
  options.thresholds = kOutOfReach;
  options.analysis.station_step = 0.3;  // so that recalled stations stand between mode 1's
  Agent agent(options);
  agent.pretrain();
  for (const char* name : {"box", "sphere", "cylinder"}) {
    const auto object = agent.shipped(name);
    for (const Task& task : task_space()) {
      const Report report = agent.controller->estimate(*object, task);
      for (const ModeAttempt& attempt : report.attempts) {
        if (attempt.score) CHECK(report.result->criticism.first >= *attempt.score);
      }
    }
  }
}

TEST_SUITE_END();
