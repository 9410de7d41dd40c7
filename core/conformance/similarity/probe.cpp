#include "../probe.h"

#include <limits>

#include "patterns.h"
#include "preshape/base/random.h"

namespace preshape::conformance {

namespace {

const Similarity& measure_at(void* component) { return *static_cast<const Similarity*>(component); }

Patterns drawn(Random& random, const FuzzyPartition& partition, int count) {
  Patterns patterns(partition);
  for (int i = 0; i < count; ++i) {
    std::array<double, kComponents> vector;
    for (double& x : vector) {
      x = random.uniform() < 0.3 ? kCrispCorners[random.below(kCrispCorners.size())] : random.uniform(-1.5, 1.5);
    }
    patterns.add(vector);
  }
  return patterns;
}

std::vector<double> compared(const Similarity& measure, const PatternView& task, const PatternView& patterns) {
  std::vector<double> numbers(static_cast<std::size_t>(patterns.count));
  measure.compare(task, patterns, numbers);
  for (int i = 0; i < patterns.count; ++i) {
    std::array<double, kComponents> components;
    measure.component_scores(task, patterns[i], components);
    numbers.insert(numbers.end(), components.begin(), components.end());
  }
  return numbers;
}

PatternView kept(Arena& arena, const PatternView& view) {
  const auto values = static_cast<std::size_t>(view.count) * kComponents;
  return {view.count, view.sets, arena.keep(std::span(view.crisp, values)).data(),
          arena.keep(std::span(view.memberships, values * static_cast<std::size_t>(view.sets))).data()};
}

class SimilarityProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name, const Value& given) const override {
    return registry.create<Similarity>(name, given);
  }
  const void* extension(void* component, const char* id) const override { return measure_at(component).extension(id); }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    const Similarity& measure = measure_at(component);
    Random random(seed);
    std::vector<double> numbers;
    for (const auto& partition : partitions()) {
      const SimilarityScale scale = measure.scale(partition.size());
      numbers.insert(numbers.end(), {scale.farthest, scale.nearest});
      const Patterns task = drawn(random, partition, 1), patterns = drawn(random, partition, 20);
      const auto scores = compared(measure, task.view(), patterns.view());
      numbers.insert(numbers.end(), scores.begin(), scores.end());
    }
    return numbers;
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const Patterns task = drawn(random, partitions()[0], 1), patterns = drawn(random, partitions()[0], 20);
    const PatternView kept_task = kept(arena, task.view()), kept_patterns = kept(arena, patterns.view());
    arena.seal();
    return compared(measure_at(component), kept_task, kept_patterns);
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    const auto attempt = [component](std::size_t scores) {
      return Attempt{fmt::format("compare with room for {} scores of 4 patterns", scores),
                     [component, scores] {
                       Random random(1);
                       const Patterns task = drawn(random, partitions()[0], 1), patterns = drawn(random, partitions()[0], 4);
                       std::vector<double> numbers(scores + 8);  // so that a plugin that does not look breaks nothing
                       measure_at(component).compare(task.view(), patterns.view(), std::span(numbers).first(scores));
                       return numbers;
                     },
                     {"4", fmt::format("{}", scores)}};
    };
    return {attempt(3), attempt(5)};
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    std::vector<Attempt> attempts;
    for (const bool in_task : {true, false}) {
      attempts.push_back({fmt::format("compare with {} in the {}", number, in_task ? "task" : "pattern"),
                          [component, number, in_task] {
                            std::vector<double> crisp(kComponents, 0.25), bad_crisp = crisp;
                            std::vector<double> degrees(kComponents * 7, 0.5), bad_degrees = degrees;
                            bad_crisp[2] = number;
                            for (std::size_t i = 14; i < 21; ++i) bad_degrees[i] = number;
                            const PatternView good{1, 7, crisp.data(), degrees.data()};
                            const PatternView bad{1, 7, bad_crisp.data(), bad_degrees.data()};
                            double value = 0.0;
                            measure_at(component).compare(in_task ? bad : good, in_task ? good : bad, {&value, 1});
                            return std::vector<double>{value};
                          },
                          {}});
    }
    return attempts;
  }

  std::optional<Answers> batch(void* component, int count, std::uint64_t seed) const override {
    const Similarity& measure = measure_at(component);
    Random random(seed);
    const Patterns task = drawn(random, partitions()[0], 1), patterns = drawn(random, partitions()[0], count);
    Answers answers;
    answers.together.resize(static_cast<std::size_t>(count));
    measure.compare(task.view(), patterns.view(), answers.together);
    for (int i = 0; i < count; ++i) answers.singly.push_back(score(measure, task.view(), patterns.view()[i]));
    return answers;
  }
};

}  // namespace

const Probe& similarity_probe() {
  static const SimilarityProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
