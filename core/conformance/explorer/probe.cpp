#include "../probe.h"

#include "landscape.h"

namespace preshape::conformance {

namespace {

const Explorer& explorer_at(void* component) {
  return *static_cast<const Explorer*>(component);
}

Terrain drawn(Random& random) {
  const double numbers[kTerrainNumbers] = {
      1.0 + static_cast<double>(random.below(4)), static_cast<double>(random.below(8)),
      static_cast<double>(random.below(3)), static_cast<double>(random.below(1000000)),
      random.uniform(0, 0.6)};
  return terrain_of(numbers);
}

/// A score of none is rightly infinite; -1000 stands for it.
double finite(double score) {
  return score == -std::numeric_limits<double>::infinity() ? -1000.0 : score;
}

void add(std::vector<double>& numbers, const ExplorationResult& result) {
  numbers.insert(numbers.end(), {static_cast<double>(result.best.plane), result.best.approach,
                                 static_cast<double>(result.best.virtual_fingers), finite(result.score.first),
                                 finite(result.score.second), static_cast<double>(result.evaluations),
                                 result.budget_spent ? 1.0 : 0.0});
}

std::vector<double> explored(void* component, std::uint64_t seed, Progress* progress) {
  Random random(seed);
  std::vector<double> numbers;
  for (const std::int64_t budget : {3, 40, 1000}) {
    const Landscape landscape(drawn(random));
    add(numbers, explorer_at(component).explore(landscape, budget, seed, progress));
  }
  return numbers;
}

/// An explorer's inputs are a problem, a budget and a seed: no buffers, and no numbers of which one could be
/// NaN.
class ExplorerProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name,
                               const Value& given) const override {
    return registry.create<Explorer>(name, given);
  }
  const void* extension(void* component, const char* id) const override {
    return explorer_at(component).extension(id);
  }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    return explored(component, seed, nullptr);
  }
  std::optional<std::vector<double>> use_told(void* component, std::uint64_t seed,
                                              Progress& progress) const override {
    return explored(component, seed, &progress);
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const Terrain terrain = drawn(random);
    const auto symbols = arena.keep(std::span<const double>(terrain.symbols));
    const auto fingers = arena.keep(std::span<const int>(terrain.fingers));
    const Landscape landscape(terrain, symbols, fingers);
    arena.seal();
    std::vector<double> numbers;
    add(numbers, explorer_at(component).explore(landscape, 200, seed, nullptr));
    return numbers;
  }

  std::vector<Attempt> wrong_sizes(void*) const override { return {}; }
  std::vector<Attempt> nonfinite(void*, double) const override { return {}; }
};

}  // namespace

const Probe& explorer_probe() {
  static const ExplorerProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
