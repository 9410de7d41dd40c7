#include <atomic>
#include <thread>

#include "components.h"
#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "preshape/fuzzy/pattern.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

TEST_CASE("Lua components: one object called from eight threads answers each as it answers one") {
  const auto similarity = registry().create<Similarity>("tfvadi_lua");
  const FuzzyPartition partition = FuzzyPartition::thesis();
  Random random(11);
  Patterns patterns(partition);
  for (int i = 0; i < 200; ++i) {
    std::array<double, kComponents> six;
    for (double& x : six) x = random.uniform(-1, 1);
    patterns.add(six);
  }
  const Patterns task(partition, {1, 0.1, 1, 0.8, 0.05, 0.05});
  std::vector<double> expected(200);
  similarity->compare(task.view(), patterns.view(), expected);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&] {
      for (int round = 0; round < 10; ++round) {
        std::vector<double> scores(200);
        similarity->compare(task.view(), patterns.view(), scores);
        if (scores != expected) ++wrong;
      }
    });
  }
  for (auto& thread : threads) thread.join();
  CHECK(wrong == 0);
}

TEST_CASE("Lua components: threads that describe, make and fail at the same time do not disturb one another") {
  const TemporaryDirectory folder;
  write_component(folder.path(), "good", component_text("similarity", "good", "return { scale = { farthest = 0, nearest = 1 }, compare = function() return 0.5 end }"));
  write_component(folder.path(), "bad", component_text("similarity", "bad", "return { scale = { farthest = 0, nearest = 1 }, compare = function() error('never') end }"));
  const Registry registry({{folder.path(), "test"}}, lua_loaders());
  const FuzzyPartition partition = FuzzyPartition::thesis();
  const Patterns q(partition, {});
  std::atomic<int> scores{0}, errors{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < 5; ++round) {
        const auto similarity = registry.create<Similarity>((t + round) % 2 ? "good" : "bad");
        double score = 0.0;
        try {
          similarity->compare(q.view(), q.view(), {&score, 1});
          scores += score == 0.5;
        } catch (const ScriptError& error) {
          errors += std::string(error.what()).find("bad.plugin.lua:4: never") != std::string::npos;
        }
      }
    });
  }
  for (auto& thread : threads) thread.join();
  CHECK(scores == 20);
  CHECK(errors == 20);
}

TEST_SUITE_END();
