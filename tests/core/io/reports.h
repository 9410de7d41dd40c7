#pragma once

#include <string>
#include <vector>

#include "preshape/grasp/task_space.h"
#include "support/scenario.h"

namespace preshape::test {

/// Runs that end in each of the four ways, in the order served, recognised, learned, deadlock.
inline const std::vector<RunRecord>& records_of_every_status() {
  static const std::vector<RunRecord> records = [] {
    const auto session = [](const char* object, const char* more) {
      return session_of(std::string("return { object = \"") + object +
                        "\", task = \"T1_2\", collision = \"brute\", memory = \":memory:\", " + more + " }");
    };
    std::vector<RunRecord> all;
    Session cube = session("cube", "title = \"a cube\"");
    cube.pretrain_if_empty();
    all.push_back(cube.run());
    for (const Task& task : signed_task_space()) {
      cube.change(Value::table({{"task", task.name}}));
      all.resize(1);
      all.push_back(cube.run());
      if (all.back().report.status == RunStatus::kRecognised) break;
    }
    Session box = session("box", "learning = { policy = \"learn\" }, thresholds = { recognition = 6 }");
    box.pretrain_if_empty();
    for (const char* task : {"T1_2", "T1_1", "T1_3", "T1_4", "T1_5", "T1_6", "T2_1", "T2_2", "T2_3", "T2_4"}) {
      box.change(Value::table({{"task", task}}));
      all.resize(2);
      all.push_back(box.run());
      if (all.back().report.status == RunStatus::kLearned) break;
    }
    Session stuck = session("box", "thresholds = { estimation = 6, recognition = 6 }");
    stuck.pretrain_if_empty();
    all.push_back(stuck.run());
    return all;
  }();
  return records;
}

}  // namespace preshape::test
