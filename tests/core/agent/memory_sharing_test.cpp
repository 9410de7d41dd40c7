#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "memory_examples.h"
#include "preshape/base/error.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

using Mode = Memory::Mode;

/// A child process whose exit code is what `body` returns, or 100 when it throws.
pid_t start(const std::function<int()>& body) {
  const pid_t child = fork();
  if (child != 0) return child;
  int code = 100;
  try {
    code = body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "child: {}\n", error.what());
  }
  _exit(code);
}

bool ended(pid_t child) {
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
  return info.si_pid == child;
}

int exit_code(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 200;
}

/// Each learning adds two samples whose score tells how many samples it saw before: a lost or stale read
/// shows.
int learn_often(const std::filesystem::path& path, int learnings) {
  Memory memory = Memory::open(path, Mode::kCreate);
  for (int i = 0; i < learnings; ++i) {
    Learning learning = memory.begin_learning();
    learning.add_object(example_object(1));
    Sample sample = example_sample(1, 1);
    sample.score = static_cast<double>(memory.samples().size());
    learning.add_sample(sample);
    learning.add_sample(sample);
    learning.commit();
  }
  return 0;
}

}  // namespace

TEST_CASE("Memory: two processes learn at once and a third reads, and nobody loses or half-sees anything") {
  const TemporaryDirectory folder;
  const auto path = folder / "m.db";
  constexpr int kLearnings = 60;
  Memory::open(path, Mode::kCreate);
  const pid_t writers[] = {start([&] { return learn_often(path, kLearnings); }),
                           start([&] { return learn_often(path, kLearnings); })};
  const Memory memory = Memory::open(path, Mode::kReadOnly);
  std::int64_t generation = 0, moments = 0;
  while (!ended(writers[0]) || !ended(writers[1])) {
    const auto moment = memory.snapshot();
    const std::int64_t now = memory.generation();
    moments += now != generation;
    CHECK(now >= generation);
    generation = now;
    CHECK(static_cast<std::int64_t>(memory.samples().size()) == 2 * generation);
    CHECK(memory.statistics().sessions == generation);
  }
  for (const pid_t writer : writers) CHECK(exit_code(writer) == 0);
  CHECK(moments > 3);
  const auto samples = memory.samples();
  REQUIRE(samples.size() == 4 * kLearnings);
  for (std::size_t i = 0; i < samples.size(); ++i) CHECK(samples[i].score == static_cast<double>(i / 2 * 2));
  CHECK(memory.integrity_faults().empty());
}

TEST_CASE("Memory: several processes may make the file at once") {
  for (int round = 0; round < 10; ++round) {
    const TemporaryDirectory folder;
    const auto path = folder / "m.db";
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) children.push_back(start([&] { return learn_often(path, 1); }));
    for (const pid_t child : children) CHECK(exit_code(child) == 0);
    CHECK(Memory::open(path, Mode::kReadOnly).samples().size() == 8);
  }
}

TEST_CASE("Memory: a learning that waits too long for another one says so") {
  const TemporaryDirectory folder;
  Memory first = Memory::open(folder / "m.db", Mode::kCreate);
  Memory second = Memory::open(folder / "m.db", Mode::kReadWrite, 0.05);
  {
    Learning learning = first.begin_learning();
    CHECK_THROWS_SAYING(second.begin_learning(), InputError,
                        "is in use by another process, also after 0.05 s");
    learning.commit();
  }
  CHECK(second.begin_learning().session() == 2);
}

TEST_CASE("Memory: a reader is not held up by a learning, and sees it only after commit") {
  const TemporaryDirectory folder;
  Memory writer = Memory::open(folder / "m.db", Mode::kCreate);
  const Memory reader = Memory::open(folder / "m.db", Mode::kReadOnly, 0.0);
  Learning learning = writer.begin_learning();
  learning.add_object(example_object(1));
  CHECK(reader.objects().empty());
  CHECK(reader.generation() == 0);
  learning.commit();
  CHECK(reader.objects().size() == 1);
  CHECK(reader.generation() == 1);
}

TEST_CASE("Snapshot: a commit meanwhile is seen only after it") {
  const TemporaryDirectory folder;
  Memory writer = Memory::open(folder / "m.db", Mode::kCreate);
  const Memory reader = Memory::open(folder / "m.db", Mode::kReadOnly);
  {
    const auto moment = reader.snapshot();
    Learning learning = writer.begin_learning();
    learning.add_object(example_object(1));
    learning.commit();
    CHECK(reader.objects().empty());
  }
  CHECK(reader.objects().size() == 1);
}

TEST_SUITE_END();
