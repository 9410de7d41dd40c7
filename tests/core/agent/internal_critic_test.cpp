#include <cmath>

#include "preshape/agent/internal_critic.h"
#include "preshape/base/error.h"
#include "support/near.h"
#include "support/registry.h"
#include "support/sample.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

using Six = std::array<double, kComponents>;

InternalCritic critic(const char* first, const char* second, Thresholds thresholds) {
  return InternalCritic(registry().create<Similarity>(first), registry().create<Similarity>(second), FuzzyPartition::thesis(),
                        thresholds);
}

InternalCritic by_tfvadi() { return critic("tfvadi", "tfdist", {}); }
InternalCritic by_tfdist() { return critic("tfdist", "tfvadi", {3.0, 0.5, 0.5}); }

Six random_six(Random& random) {
  Six v{};
  for (double& x : v) x = random.uniform(-1.3, 1.3);
  return v;
}

}  // namespace

TEST_CASE("Critic: thresholds outside the deciding measure's range are refused with the range") {
  CHECK_THROWS_SAYING(critic("tfvadi", "tfdist", {7.0, 5.5, 0.5}), InputError, "'estimation' is 7, but the similarity measure goes from 0 to 6");
  CHECK_THROWS_SAYING(critic("tfvadi", "tfdist", {3.0, -0.1, 0.5}), InputError, "'recognition' is -0.1");
  CHECK_THROWS_SAYING(critic("tfvadi", "tfdist", {std::nan(""), 5.5, 0.5}), InputError, "'estimation'");
  CHECK_THROWS_SAYING(critic("tfdist", "tfvadi", {16.0, 0.5, 0.5}), InputError, "goes from 0 to 15.87");
  CHECK_NOTHROW(critic("tfvadi", "tfdist", {6.0, 0.0, 0.5}));
  CHECK_NOTHROW(critic("tfdist", "tfvadi", {15.8, 0.0, 0.5}));
}

TEST_CASE("Critic: rewards what reaches the threshold, from above or from below as the measure runs") {
  const auto up = by_tfvadi(), down = by_tfdist();
  CHECK(up.serves(3.0));
  CHECK(up.serves(3.1));
  CHECK_FALSE(up.serves(2.9));
  CHECK(up.recognises(5.5));
  CHECK_FALSE(up.recognises(5.4));
  CHECK(down.serves(3.0));
  CHECK(down.serves(2.9));
  CHECK_FALSE(down.serves(3.1));
  CHECK(down.recognises(0.4));
  CHECK_FALSE(down.recognises(0.6));
}

TEST_CASE("Critic: the nearer of two patterns has the better first measure, or on a tie the better second") {
  const auto up = by_tfvadi(), down = by_tfdist();
  CHECK(up.nearer({4.0, 9.0, {}}, {3.0, 0.0, {}}));
  CHECK_FALSE(up.nearer({3.0, 0.0, {}}, {4.0, 9.0, {}}));
  CHECK(up.nearer({4.0, 1.0, {}}, {4.0, 2.0, {}}));  // tfdist second: lower is nearer
  CHECK_FALSE(up.nearer({4.0, 2.0, {}}, {4.0, 1.0, {}}));
  CHECK_FALSE(up.nearer({4.0, 1.0, {}}, {4.0, 1.0, {}}));
  CHECK(down.nearer({1.0, 0.0, {}}, {2.0, 6.0, {}}));
  CHECK(down.nearer({1.0, 5.0, {}}, {1.0, 4.0, {}}));  // tfvadi second: higher is nearer
  CHECK_FALSE(down.nearer({1.0, 4.0, {}}, {1.0, 5.0, {}}));
}

TEST_CASE("Critic: a pattern equal to a task that lies on the sets' tops is as near as the measure goes") {
  const Six task = {1.0, 0.0, -0.6, 0.05, -0.25, 1.1};
  for (const auto& judge : {by_tfvadi(), by_tfdist()}) {
    CHECK_NEAR(judge.judge(task, task).first, judge.scale().nearest, 1e-12);
    CHECK_NEAR(judge.judge(task, task).second, judge.second_scale().nearest, 1e-12);
  }
}

TEST_CASE("Critic: the six components of a judgement add up to it") {
  Random random(41);
  for (const auto& judge : {by_tfvadi(), by_tfdist()}) {
    for (int i = 0; i < 50; ++i) {
      const Criticism criticism = judge.judge(random_six(random), random_six(random));
      double sum = 0.0;
      for (const double c : criticism.components) sum += c;
      CHECK_NEAR(sum, criticism.first, 12 * kEps * 9);
    }
  }
}

TEST_CASE("Critic: scores of a batch order patterns as single judgements do, with either measure first") {
  Random random(42);
  for (const auto& judge : {by_tfvadi(), by_tfdist()}) {
    const Six task = random_six(random);
    std::vector<Wrench> wrenches;
    for (int i = 0; i < 60; ++i) wrenches.push_back(random_wrench(random));
    wrenches.push_back(wrenches.front());
    std::vector<StationScore> scores(wrenches.size());
    judge.score(task, wrenches, scores);
    for (std::size_t i = 0; i < wrenches.size(); ++i) {
      for (std::size_t j = 0; j < wrenches.size(); ++j) {
        CHECK(scores[i].better_than(scores[j]) ==
              judge.nearer(judge.judge(task, components(wrenches[i])), judge.judge(task, components(wrenches[j]))));
      }
    }
  }
}

TEST_CASE("Critic: components of a wrench are force before moment") {
  CHECK(components(Wrench({1, 2, 3}, {4, 5, 6})) == Six{1, 2, 3, 4, 5, 6});
}

TEST_SUITE_END();
