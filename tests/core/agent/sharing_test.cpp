#include "support/agent.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

/// Two agents, as two processes would be, on one memory file.
struct Pair {
  TemporaryDirectory folder;
  Agent first{on(folder / "shared.memory")}, second{on(folder / "shared.memory")};

  static Agent::Options on(const std::filesystem::path& file) {
    Agent::Options options;
    options.learning.policy = LearningSettings::Policy::kLearn;
    options.memory = std::make_shared<Memory>(Memory::open(file, Memory::Mode::kCreate));
    return options;
  }
};

}  // namespace

TEST_CASE("Sharing: what one session is taught, the other recalls at once") {
  Pair pair;
  pair.first.pretrain();
  pair.second.learning->recall();
  REQUIRE(pair.second.classifier->trained());
  CHECK(pair.second.classifier->save() == pair.first.classifier->save());

  const auto box = pair.second.shipped("box");
  int learned = 0;
  for (const char* name : {"T1_1", "T1_2", "T2_4", "T3_5-"}) {
    const Task task = named_task(name);
    if (pair.first.controller->estimate(*box, task).served()) continue;
    if (pair.second.controller->run(*box, task).status != RunStatus::kLearned) continue;
    ++learned;
    CHECK(pair.first.controller->estimate(*box, task).served());
    CHECK(pair.first.classifier->save() == pair.second.classifier->save());
  }
  CHECK(learned > 0);
}

TEST_CASE("Sharing: a lesson of the other is seen also after a refused lesson of one's own, whose number it gets") {
  Pair pair;
  pair.first.pretrain();
  const auto box = pair.first.shipped("box");
  const Task task = named_task("T1_2");
  const auto best = pair.first.learning->explore(*box, task, nullptr).best;
  REQUIRE(best);
  pair.first.learning->teach(*box, task, *best, true, [] { return false; }, nullptr);
  const auto generation = pair.first.memory->generation();
  pair.second.learning->teach(*box, task, *best, true, [] { return true; }, nullptr);
  REQUIRE(pair.first.memory->generation() == generation + 1);
  pair.first.learning->recall();
  CHECK(pair.first.classifier->save() == pair.second.classifier->save());
}

TEST_CASE("Sharing: a lesson is added to what the other has taught meanwhile, not to what one knew") {
  Pair pair;
  pair.first.pretrain();
  pair.second.learning->recall();
  const auto box = pair.first.shipped("box");
  const Task task = named_task("T1_2"), other = named_task("T1_5");
  const auto best = pair.first.learning->explore(*box, task, nullptr).best;
  const auto best_other = pair.first.learning->explore(*box, other, nullptr).best;
  REQUIRE((best && best_other));
  pair.first.learning->teach(*box, task, *best, true, [] { return true; }, nullptr);
  pair.second.learning->teach(*box, other, *best_other, true, [] { return true; }, nullptr);
  CHECK(pair.second.performance->perform(*box, task).preshape == best->preshape);
  CHECK(pair.second.performance->perform(*box, other).preshape == best_other->preshape);
}

TEST_SUITE_END();
