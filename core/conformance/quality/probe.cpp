#include "../probe.h"

#include "grasps.h"
#include "preshape/base/random.h"

namespace preshape::conformance {

namespace {

QualityMeasure& measure_at(void* component) { return *static_cast<QualityMeasure*>(component); }

Grasp drawn(Random& random, int contacts) {
  std::vector<double> numbers(static_cast<std::size_t>(6 * contacts + 4));
  for (double& x : numbers) x = random.uniform(-1.0, 1.0);
  numbers.back() = static_cast<double>(random.below(3));
  return grasp_case(numbers, contacts).grasp();
}

/// A grasp with the number in everything that a measure could look at.
Grasp spoiled(double number) {
  Random random(1);
  Grasp grasp = drawn(random, 3);
  for (auto& contact : grasp.contacts) contact.p_OC.y() = contact.n.y() = contact.a.y() = contact.t.y() = number;
  for (auto& F : grasp.F_C_O) F = F + Wrench({0, number, 0}, {0, number, 0});
  grasp.approach_O.y() = grasp.opposition_O.y() = number;
  grasp.wrench_union.col(1).setConstant(number);
  grasp.resultant += Wrench({0, number, 0}, {0, number, 0});
  return grasp;
}

class QualityProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name, const Value& given) const override {
    return registry.create<QualityMeasure>(name, given);
  }
  const void* extension(void* component, const char* id) const override { return measure_at(component).extension(id); }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    Random random(seed);
    std::vector<double> numbers;
    for (int i = 0; i < 20; ++i) {
      const auto values = evaluated(measure_at(component), drawn(random, 2 + i % 4));
      numbers.insert(numbers.end(), values.begin(), values.end());
    }
    return numbers;
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const Grasp grasp = drawn(random, 4);
    const auto contacts = arena.keep(std::span<const ContactFrame>(grasp.contacts));
    const auto wrenches = arena.keep(std::span<const Wrench>(grasp.F_C_O));
    const auto resultant = arena.keep(std::span<const Wrench>(&grasp.resultant, 1));
    arena.seal();
    std::vector<double> values(measure_at(component).numbers().size());
    measure_at(component).evaluate({contacts, wrenches, grasp.wrench_union, resultant.front(), grasp.length_m,
                                    grasp.contact_model, grasp.approach_O, grasp.opposition_O},
                                   values);
    return values;
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    const QualityMeasure& measure = measure_at(component);
    const std::size_t wanted = measure.numbers().size();
    std::vector<Attempt> attempts;
    for (const std::size_t given : {wanted - 1, wanted + 1}) {
      attempts.push_back({fmt::format("evaluate with room for {} of {} numbers", given, wanted),
                          [&measure, given] {
                            Random random(1);
                            const Grasp grasp = drawn(random, 3);
                            std::vector<double> values(given + 8);  // so that a plugin that does not look breaks nothing
                            measure.evaluate(grasp.view(), std::span(values).first(given));
                            return values;
                          },
                          {fmt::format("{}", given), fmt::format("{}", wanted)}});
    }
    return attempts;
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    return {{fmt::format("evaluate of a grasp with {} in it", number), [component, number] {
               return evaluated(measure_at(component), spoiled(number));
             }}};
  }
};

}  // namespace

const Probe& quality_probe() {
  static const QualityProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
