#include <set>

#include "preshape/base/error.h"
#include "preshape/grasp/task_space.h"
#include "support/near.h"

using namespace preshape;

TEST_SUITE_BEGIN("core/grasp");

TEST_CASE("Task space: rows of figure 3.11 that follow its rule") {
  using Screw = std::array<double, 6>;
  CHECK(named_task("T1_1").screw == Screw{1, 0.1, 1, 0.05, 0.05, 0.8});
  CHECK(named_task("T1_6").screw == Screw{0.1, 1, 1, 0.05, 0.8, 0.05});
  CHECK(named_task("T2_3").screw == Screw{1, 1, 0.1, 0.05, 0.8, 0.05});
  CHECK(named_task("T3_4").screw == Screw{0.1, 1, 0.1, 0.05, 0.8, 0.05});
  CHECK(named_task("T4_1").screw == Screw{1, 0.1, 1, 0.8, 0.05, 0.8});
}

TEST_CASE("Task space: rows that the printed table has wrong follow the rule of their category") {
  using Screw = std::array<double, 6>;
  CHECK(named_task("T2_4").screw == Screw{0.1, 1, 1, 0.05, 0.8, 0.05});
  CHECK(named_task("T2_5").screw == Screw{1, 0.1, 1, 0.05, 0.05, 0.8});
  CHECK(named_task("T4_6").screw == Screw{0.1, 1, 1, 0.05, 0.8, 0.8});
}

TEST_CASE("Task space: 24 tasks, 84 with signs, no name twice, T and R of an axis of one sign") {
  CHECK(task_space().size() == 24);
  const auto tasks = signed_task_space();
  CHECK(tasks.size() == 84);
  std::set<std::string> names;
  for (const auto& task : tasks) {
    names.insert(task.name);
    for (std::size_t i = 0; i < 3; ++i) {
      const bool moves = std::abs(task.screw[i]) == 1.0 && std::abs(task.screw[i + 3]) == 0.8;
      if (moves) CHECK(task.screw[i] * task.screw[i + 3] > 0);
    }
    CHECK(named_task(task.name).screw == task.screw);
  }
  CHECK(names.size() == 84);
}

TEST_CASE("Task space: signs are those of approach and opposition") {
  const auto task = named_task("T4_2-+");
  CHECK(task.screw == std::array<double, 6>{-1, 1, 0.1, -0.8, 0.8, 0.05});
  CHECK(named_task("T1_2++").screw == named_task("T1_2").screw);
  CHECK_THROWS_SAYING(named_task("T1_9"), InputError, "there is no task 'T1_9'; did you mean 'T1_");
}

TEST_CASE("Manipulations: they move about the axes that they are given") {
  CHECK(manipulation_task("pivot", "X", "-Z").screw == std::array<double, 6>{0.1, 0.1, 0.1, 0.05, 0.05, -0.8});
  CHECK(manipulation_task("translate_normal", "+Y", "X").screw == std::array<double, 6>{0.1, 1, 0.1, 0.05, 0.05, 0.05});
  CHECK(manipulation_task("log_roll", "X", "Y").screw[5] == 0.8);
  CHECK_THROWS_SAYING(manipulation_task("pivott", "X", "Y"), InputError, "did you mean 'pivot'?");
  CHECK_THROWS_SAYING(manipulation_task("pivot", "X", "-X"), InputError, "different axes");
  CHECK_THROWS_SAYING(manipulation_task("pivot", "X", "Q"), InputError, "'Q' is no axis");
}

TEST_SUITE_END();
