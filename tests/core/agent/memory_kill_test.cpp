#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "memory_examples.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

constexpr int kRowsOfLearning = 3;

/// Learns until it is killed: an object, three samples and a state each time; a byte to the pipe after each
/// commit.
[[noreturn]] void learn_for_ever(const std::filesystem::path& path, int report) {
  try {
    Memory memory = Memory::open(path, Memory::Mode::kCreate);
    for (;;) {
      Learning learning = memory.begin_learning();
      const int number = static_cast<int>(learning.session());
      learning.add_object(example_object(number));
      std::int64_t last = 0;
      for (int i = 0; i < kRowsOfLearning; ++i) last = learning.add_sample(example_sample(number, 1));
      ClassifierState state = example_state(last);
      state.bytes.assign(20000, static_cast<char>(number));
      learning.store_state(state);
      learning.commit();
      if (write(report, "c", 1) != 1) _exit(2);
    }
  } catch (...) {
    _exit(3);
  }
}

/// Starts a child that learns, and kills it `microseconds` after its first `wait_for` commits.
/// @returns commits that it has reported
std::int64_t learn_and_kill(const std::filesystem::path& path, int wait_for, std::uint64_t microseconds) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    close(ends[0]);
    learn_for_ever(path, ends[1]);
  }
  close(ends[1]);
  char buffer[4096];
  std::int64_t reported = 0;
  while (reported < wait_for && read(ends[0], buffer, 1) == 1) ++reported;
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;) reported += n;
  close(ends[0]);
  return reported;
}

/// Learnings are whole: so many objects, states' last samples and rows belong together.
void check_whole(const Memory& memory, std::int64_t learnings) {
  CHECK(memory.integrity_faults().empty());
  const MemoryStatistics statistics = memory.statistics();
  CHECK(statistics.sessions == learnings);
  CHECK(statistics.objects == learnings);
  CHECK(statistics.samples() == kRowsOfLearning * learnings);
  const auto state = memory.latest_state("mlp");
  REQUIRE(state.has_value() == (learnings > 0));
  if (state) CHECK(state->last_sample == kRowsOfLearning * learnings);
  if (state) CHECK(state->bytes == std::string(20000, static_cast<char>(learnings)));
}

}  // namespace

TEST_CASE("Memory: what was committed before a kill is there, whole, and nothing else") {
  const TemporaryDirectory folder;
  Random random(11);
  std::int64_t learnings = 0, all_reported = 0;
  for (int round = 0; round < 60; ++round) {
    const std::int64_t reported = learn_and_kill(folder / "m.db", 1, random.below(12000));
    all_reported += reported;
    const Memory memory = Memory::open(folder / "m.db", Memory::Mode::kCreate);
    const std::int64_t before = learnings;
    learnings = memory.generation();
    // The last commit may have happened without its report.
    CHECK(learnings >= before + reported);
    CHECK(learnings <= before + reported + 1);
    check_whole(memory, learnings);
  }
  MESSAGE("60 kills, ", all_reported, " commits reported, ", learnings, " there");
  CHECK(all_reported >= 60);
}

TEST_CASE("Memory: a kill while the file is being made leaves one that can be made or used") {
  Random random(12);
  for (int round = 0; round < 40; ++round) {
    const TemporaryDirectory folder;
    const std::int64_t reported = learn_and_kill(folder / "m.db", 0, 200 + random.below(4000));
    const Memory memory = Memory::open(folder / "m.db", Memory::Mode::kCreate);
    CHECK(memory.generation() >= reported);
    check_whole(memory, memory.generation());
  }
}

TEST_SUITE_END();
