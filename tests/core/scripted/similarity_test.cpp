#include <limits>

#include "components.h"
#include "preshape/base/error.h"
#include "preshape/base/random.h"
#include "preshape/fuzzy/pattern.h"
#include "support/near.h"
#include "support/registry.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

const FuzzyPartition& partition() {
  static const FuzzyPartition thesis = FuzzyPartition::thesis();
  return thesis;
}

std::array<double, kComponents> random_six(Random& random) {
  std::array<double, kComponents> six;
  for (double& x : six) x = random.uniform(-1.5, 1.5);
  return six;
}

std::vector<double> scores_of(const Similarity& similarity, const Patterns& task, const Patterns& patterns) {
  std::vector<double> scores(static_cast<std::size_t>(patterns.count()));
  similarity.compare(task.view(), patterns.view(), scores);
  return scores;
}

/// The score of one pair by a similarity whose body of `new` is given.
double score(const std::string& inside, const std::array<double, kComponents>& q, const std::array<double, kComponents>& w) {
  const OneComponent component("similarity", "x", inside);
  return scores_of(*component->create<Similarity>("x"), Patterns(partition(), q), Patterns(partition(), w))[0];
}

std::string failing(const std::string& compare) {
  try {
    score("return { scale = { farthest = 0, nearest = 1 },\n compare = " + compare + " }", {1, 0, 0.5, 0, 0, 0}, {0, 0, 0, 0, 0, 1});
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua similarity: tfvadi_lua has the bits of tfvadi, scores and components, over random patterns") {
  const auto compiled = registry().create<Similarity>("tfvadi"), scripted = registry().create<Similarity>("tfvadi_lua");
  Random random(7);
  Patterns patterns(partition());
  for (int i = 0; i < 300; ++i) patterns.add(random_six(random));
  for (int i = 0; i < 20; ++i) {
    const Patterns task(partition(), random_six(random));
    CHECK(scores_of(*compiled, task, patterns) == scores_of(*scripted, task, patterns));
    std::array<double, kComponents> a, b;
    compiled->component_scores(task.view(), patterns.view()[i], a);
    scripted->component_scores(task.view(), patterns.view()[i], b);
    CHECK(a == b);
  }
  CHECK(scripted->scale(7).nearest == compiled->scale(7).nearest);
}

TEST_CASE("Lua similarity: cosine is the cosine, mapped, and has answers for zero vectors") {
  const auto cosine = registry().create<Similarity>("cosine"), sharp = registry().create<Similarity>("cosine", Value::table({{"sharpness", 2}}));
  const auto of = [&](const Similarity& s, const std::array<double, kComponents>& q, const std::array<double, kComponents>& w) {
    return scores_of(s, Patterns(partition(), q), Patterns(partition(), w))[0];
  };
  CHECK_NEAR(of(*cosine, {1, 2, 3, 0, 0, 0}, {2, 4, 6, 0, 0, 0}), 1.0, 4 * kEps);
  CHECK_NEAR(of(*cosine, {1, 0, 0, 0, 0, 1}, {-1, 0, 0, 0, 0, -1}), 0.0, 4 * kEps);
  CHECK_NEAR(of(*cosine, {1, 0, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}), 0.5 + std::sqrt(0.125), 4 * kEps);
  CHECK_NEAR(of(*sharp, {1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}), 0.25, 4 * kEps);
  CHECK(of(*cosine, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}) == 0.5);
  CHECK(of(*cosine, {0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}) == 0.5);
}

TEST_CASE("Lua similarity: the script sees crisp numbers and memberships of task and pattern, refilled for each") {
  const std::string body =
      "return { scale = { farthest = -1e9, nearest = 1e9 }, compare = function(task, pattern)\n"
      "  local sum = 0\n"
      "  for k = 1, 6 do\n"
      "    sum = sum + task.crisp[k] * 10 + pattern.crisp[k]\n"
      "    for i = 1, #task[k] do sum = sum + 1000 * task[k][i] * i + 100 * pattern[k][i] * i end\n"
      "  end\n"
      "  return sum\nend }";
  const OneComponent component("similarity", "x", body);
  const Patterns task(partition(), {1, -1, 0.5, 0.1, 0, 0.3});
  Patterns patterns(partition(), {0, 0, 1, 1, -0.2, 0});
  patterns.add({1, 1, 1, 1, 1, -1});
  const auto scores = scores_of(*component->create<Similarity>("x"), task, patterns);
  for (int p = 0; p < 2; ++p) {
    const PatternView q = task.view(), w = patterns.view()[p];
    double expected = 0.0;
    for (int k = 0; k < kComponents; ++k) {
      expected += 10 * q.crisp[k] + w.crisp[k];
      for (int i = 0; i < q.sets; ++i) expected += 1000 * q.memberships[k * q.sets + i] * (i + 1) + 100 * w.memberships[k * q.sets + i] * (i + 1);
    }
    CHECK_NEAR(scores[static_cast<std::size_t>(p)], expected, 1e-9);
  }
}

TEST_CASE("Lua similarity: what a script does to its tables does not reach the next pattern") {
  const std::string body =
      "return { scale = { farthest = 0, nearest = 10 }, compare = function(task, pattern)\n"
      "  local score = pattern.crisp[1] + #pattern[1]\n"
      "  pattern[1] = {}\n pattern.crisp = {}\n  task[2] = nil\n  return score\nend }";
  Patterns patterns(partition(), {1, 0, 0, 0, 0, 0});
  patterns.add({2, 0, 0, 0, 0, 0});
  const OneComponent component("similarity", "x", body);
  const auto similarity = component->create<Similarity>("x");
  const std::vector<double> expected = {8.0, 9.0};
  CHECK(scores_of(*similarity, Patterns(partition(), {0, 0, 0, 0, 0, 0}), patterns) == expected);
  CHECK(scores_of(*similarity, Patterns(partition(), {0, 0, 0, 0, 0, 0}), patterns) == expected);
}

TEST_CASE("Lua similarity: without `components` each component is measured alone, with it the script says") {
  const std::string sum = "compare = function(q, w) local s = 0; for k = 1, 6 do s = s + q.crisp[k] * w.crisp[k] end; return s end";
  const OneComponent alone("similarity", "x", "return { scale = { farthest = -9, nearest = 9 }, " + sum + " }");
  const Patterns q(partition(), {1, 2, 0, 0, 0, 1}), w(partition(), {1, 1, 1, 0, 0, -1});
  std::array<double, kComponents> scores;
  alone->create<Similarity>("x")->component_scores(q.view(), w.view(), scores);
  CHECK(scores == std::array<double, kComponents>{1, 2, 0, 0, 0, -1});
  const OneComponent said("similarity", "x", "return { scale = { farthest = -9, nearest = 9 }, components = function() return { 1, 2, 3, 4, 5, 6 } end, " + sum + " }");
  said->create<Similarity>("x")->component_scores(q.view(), w.view(), scores);
  CHECK(scores == std::array<double, kComponents>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("Lua similarity: a scale may depend on the number of sets") {
  const OneComponent component("similarity", "x", "return { scale = function(sets) return { farthest = 6 * sets, nearest = 0 } end, compare = function() return 40 end }");
  const auto similarity = component->create<Similarity>("x");
  CHECK(similarity->scale(7).farthest == 42.0);
  CHECK(similarity->scale(5).farthest == 30.0);
  const FuzzyPartition five = FuzzyPartition(std::vector<Membership>(partition().sets().begin(), partition().sets().begin() + 5));
  CHECK(scores_of(*similarity, Patterns(partition(), {}), Patterns(partition(), {}))[0] == 40.0);
  CHECK_THROWS_SAYING(scores_of(*similarity, Patterns(five, {}), Patterns(five, {})), ScriptError, "within its scale 0 .. 30, got 40");
}

TEST_CASE("Lua similarity: a wrong score is an error with component, file, line and the patterns") {
  const std::string inputs = " for task (1, 0, 0.5, 0, 0, 0) and pattern (0, 0, 0, 0, 0, 1)";
  CHECK(failing("function() end").ends_with("x.plugin.lua:5: similarity 'x': 'compare' must return a finite number, got nil" + inputs));
  CHECK(failing("function() return 'high' end").ends_with("'compare' must return a finite number, got text 'high'" + inputs));
  CHECK(failing("function() return 0/0 end").find("a finite number, got number nan" + inputs) != std::string::npos);
  CHECK(failing("function() return 1.5 end").ends_with("'compare' must return scores within its scale 0 .. 1, got 1.5" + inputs));
  CHECK(failing("function(q) return q.crsp[1] end").find("x.plugin.lua:5: attempt to index a nil value (field 'crsp')") != std::string::npos);
  CHECK(failing("function() while true do end end").find("x.plugin.lua:5: stopped after 200000000 instructions") != std::string::npos);
  CHECK(failing("function() return math.random() end").find("math.random: similarity 'x' has no seed") != std::string::npos);
  CHECK(failing("function() return 1 + 1e-12 end").empty());
}

TEST_CASE("Lua similarity: after an error the object answers as before") {
  const OneComponent component("similarity", "x",
                               "local calls = 0\nreturn { scale = { farthest = 0, nearest = 9 }, compare = function(q, w)\n"
                               "  calls = calls + 1\n  if w.crisp[1] > 1 then error('too large') end\n  return calls end }");
  const auto similarity = component->create<Similarity>("x");
  const Patterns q(partition(), {}), good(partition(), {}), bad(partition(), {2, 0, 0, 0, 0, 0});
  CHECK(scores_of(*similarity, q, good)[0] == 1.0);
  CHECK_THROWS_SAYING(scores_of(*similarity, q, bad), ScriptError, "x.plugin.lua:7: too large");
  CHECK(scores_of(*similarity, q, good)[0] == 1.0);  // in a new state
}

TEST_CASE("Lua similarity: buffers of another size and numbers that are not finite are refused") {
  const auto cosine = registry().create<Similarity>("cosine");
  const Patterns q(partition(), {});
  std::vector<double> two(2);
  const Patterns odd(partition(), {0, std::nan(""), 0, 0, 0, 0});
  CHECK_THROWS_SAYING(scores_of(*cosine, q, odd), InputError, "similarity 'cosine': pattern must be finite, got (0, nan, 0, 0, 0, 0)");
  CHECK_THROWS_SAYING(cosine->compare(q.view(), q.view(), two), InputError, "scores: expected 1 entries, got 2");
}

TEST_SUITE_END();
