#include <algorithm>

#include "support/near.h"
#include "support/scenario.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/workbench");

TEST_CASE("Household: scanned objects at real size are loaded, explored, and learned where they are unknown") {
  const auto folder = test_data("objects/household");
  if (folder.empty()) return;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  CHECK(files.size() == 10);

  const auto memory = std::make_shared<Memory>(Memory::in_memory());
  int served = 0, learned = 0;
  for (const auto& file : files) {
    INFO(file.filename().string());
    Session session = session_of("return { object = { mesh = \"" + file.string() + "\", unit = \"m\" }, task = \"T1_1\", "
                                 "hand = \"utah_mit\", simulator = \"none\", learning = { policy = \"learn\" }, seed = 1 }", {"", nullptr, memory});
    session.pretrain_if_empty();
    const auto extents = session.object().object.box_O.extents();
    CHECK(extents.maxCoeff() > 0.05);
    CHECK(extents.maxCoeff() < 0.4);
    std::vector<Value> taught;
    for (const char* task : {"T1_1", "T1_4-+", "T2_6", "T3_2-", "T4_3"}) {
      session.change(Value::table({{"task", task}}));
      const auto best = session.best();
      REQUIRE(best.best);
      const bool servable = best.best->criticism.first >= 3.0;
      const Report report = session.run().report;
      INFO(task, ": ", report.verdict);
      CHECK(report.result);
      CHECK(report.served() == servable);
      if (report.status == RunStatus::kLearned) taught.emplace_back(task), ++learned;
      if (report.status == RunStatus::kServed) ++served;
    }
    for (const Value& task : taught) {
      session.change(Value::table({{"task", task}}));
      INFO(task.string());
      CHECK(session.estimate().report.served());
    }
  }
  MESSAGE(served, " of 50 recalled, ", learned, " learned, ", memory->samples().size(), " rows");
  CHECK(learned > 0);
  CHECK(served > 0);
  CHECK(memory->objects().size() > 5);
}

TEST_SUITE_END();
