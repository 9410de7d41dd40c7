#include "support/agent.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

/// Runs every signed task on an object that the pretrained agent has never met, learning as it goes.
void check_coverage(const char* name, const char* collision) {
  INFO(std::string(name));
  Agent::Options options;
  options.learning.policy = LearningSettings::Policy::kLearn;
  options.collision = collision;
  Agent agent(options);
  agent.pretrain();
  const auto object = agent.shipped(name);
  std::vector<Task> taught;
  int unservable = 0;
  for (const Task& task : signed_task_space()) {
    INFO(task.name);
    const auto best = agent.learning->explore(*object, task, nullptr).best;
    const bool servable = best && agent.serves(*best);
    if (!servable) ++unservable;
    agent.controller->reset();
    if (agent.controller->estimate(*object, task).served()) {
      CHECK(servable);
      continue;
    }
    if (!servable) continue;
    const Report report = agent.controller->run(*object, task);
    CHECK(report.status == RunStatus::kLearned);
    CHECK(report.mode == 3);
    REQUIRE(report.lesson);
    CHECK(report.lesson->rows_added > 0);
    taught.push_back(task);
  }
  MESSAGE(std::string(name), ": ", taught.size(), " taught, ", unservable, " that no grasp serves, ", agent.memory->samples().size(), " rows");
  CHECK(!taught.empty());
  for (const Task& task : taught) {
    INFO(task.name);
    CHECK(agent.controller->estimate(*object, task).served());
  }
}

/// The tree where there is one: most of the time goes into rays.
const char* fastest() { return registry().has("collision", "fcl") ? "fcl" : "brute"; }

}  // namespace

TEST_CASE("Coverage: every task that a grasp of the box serves is served or learned, and stays served") {
  check_coverage("box", "brute");
}
TEST_CASE("Coverage: every task that a grasp of the cylinder serves is served or learned, and stays served") {
  check_coverage("cylinder", fastest());
}
TEST_CASE("Coverage: every task that a grasp of the sphere serves is served or learned, and stays served") {
  check_coverage("sphere", fastest());
}
TEST_CASE("Coverage: every task that a grasp of the mug serves is served or learned, and stays served") {
  check_coverage("mug", fastest());
}

TEST_SUITE_END();
