#include "../probe.h"

#include "workshop.h"

namespace preshape::conformance {

namespace {

const GraspSimulator& simulator_at(void* component) {
  return *static_cast<const GraspSimulator*>(component);
}

Job drawn(Random& random) {
  std::vector<double> numbers;
  for (const Block& block : job_blocks()) {
    for (int i = 0; i < block.size; ++i) numbers.push_back(random.uniform(block.low, block.high));
  }
  return job_of(numbers);
}

std::vector<double> simulated(void* component, std::uint64_t seed, Progress* progress) {
  Random random(seed);
  std::vector<double> numbers;
  for (int i = 0; i < 2; ++i) {
    const Bench bench(drawn(random));
    const auto more = numbers_of(simulator_at(component).simulate(bench.task(), seed, progress));
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  return numbers;
}

class SimulatorProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name,
                               const Value& given) const override {
    return registry.create<GraspSimulator>(name, given);
  }
  const void* extension(void* component, const char* id) const override {
    return simulator_at(component).extension(id);
  }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    return simulated(component, seed, nullptr);
  }
  std::optional<std::vector<double>> use_told(void* component, std::uint64_t seed,
                                              Progress& progress) const override {
    return simulated(component, seed, &progress);
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const Bench bench(drawn(random));
    const SimulationTask given = bench.task();
    const auto contacts = arena.keep(given.contacts);
    const auto fingers = arena.keep(given.fingers);
    arena.seal();
    return numbers_of(
        simulator_at(component).simulate({given.hand, given.collision, given.object_O, contacts, fingers,
                                          given.approach_O, given.opposition_O, given.clearance_m},
                                         seed, nullptr));
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    std::vector<Attempt> attempts;
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}}) {
      attempts.push_back({fmt::format("simulate with 3 contacts and {} fingers", count),
                          [component, count] {
                            Bench bench(Job{});
                            bench.fingers.resize(count);
                            return numbers_of(simulator_at(component).simulate(bench.task(), 1, nullptr));
                          },
                          {"3", fmt::format("{}", count)}});
    }
    return attempts;
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    const auto attempt = [component](std::string what, std::function<void(Bench&)> spoil) {
      return Attempt{std::move(what),
                     [component, spoil] {
                       Bench bench(Job{});
                       spoil(bench);
                       return numbers_of(simulator_at(component).simulate(bench.task(), 1, nullptr));
                     },
                     {}};
    };
    return {attempt(fmt::format("simulate with {} in a contact's place", number),
                    [=](Bench& b) { b.contacts[1].p_OC.y() = number; }),
            attempt(fmt::format("simulate with {} in an inward normal", number),
                    [=](Bench& b) { b.contacts[1].n.y() = number; })};
  }
};

}  // namespace

const Probe& simulator_probe() {
  static const SimulatorProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
