#include "../probe.h"

#include "frames.h"
#include "preshape/base/random.h"

namespace preshape::conformance {

namespace {

ContactModel& model_at(void* component) { return *static_cast<ContactModel*>(component); }

Eigen::Vector3d direction(Random& random) {
  if (random.uniform() < 0.3) return Eigen::Vector3d::Unit(static_cast<int>(random.below(3)));
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

std::vector<ContactFrame> drawn(Random& random, int count) {
  std::vector<ContactFrame> contacts;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d n = direction(random), a = direction(random);
    contacts.push_back(ContactFrame::at({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, n, a));
  }
  return contacts;
}

void append(std::vector<double>& numbers, const WrenchBasis& wrenches) {
  numbers.insert(numbers.end(), wrenches.data(), wrenches.data() + wrenches.size());
}

std::vector<double> asked(const ContactModel& model, std::span<const ContactFrame> contacts) {
  std::vector<double> numbers = {static_cast<double>(model.basis_size())};
  append(numbers, basis_of(model, contacts));
  append(numbers, pattern_of(model, contacts));
  const ContactLimits* limits = contact_limits(model);
  if (!limits) return numbers;
  for (const int resolution : {3, 8}) {
    numbers.push_back(limits->primitive_count(resolution));
    append(numbers, edges_of(*limits, contacts, resolution));
  }
  for (const auto& contact : contacts) {
    for (const double side : {0.0, 0.3, 3.0}) {
      numbers.push_back(limits->admits(contact, Wrench(contact.n + side * contact.t, side * contact.n), 1e-9));
    }
  }
  return numbers;
}

/// A call for three contacts with room for `given` columns or wrenches of the `wanted`.
Attempt with_room(const char* what, int given, int wanted,
                  const std::function<void(std::span<const ContactFrame>, int)>& call) {
  return {fmt::format("{} with room for {} of {}", what, given, wanted),
          [given, call] {
            Random random(1);
            const auto contacts = drawn(random, 3);
            call(contacts, given);
            return std::vector<double>{};
          },
          {fmt::format("{}", given), fmt::format("{}", wanted)}};
}

class ContactProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name, const Value& given) const override {
    return registry.create<ContactModel>(name, given);
  }
  const void* extension(void* component, const char* id) const override { return model_at(component).extension(id); }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    Random random(seed);
    return asked(model_at(component), drawn(random, 12));
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const auto contacts = drawn(random, 12);
    const auto kept = arena.keep(std::span<const ContactFrame>(contacts));
    arena.seal();
    return asked(model_at(component), kept);
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    const ContactModel& model = model_at(component);
    const ContactLimits* limits = contact_limits(model);
    const int columns = 3 * model.basis_size(), edges = limits ? 3 * limits->primitive_count(8) : 0;
    std::vector<Attempt> attempts;
    // More room behind what is given, so that a plugin that does not look breaks nothing.
    for (const int off : {-1, 1}) {
      attempts.push_back(with_room("wrench_basis", columns + off, columns, [&model](auto contacts, int given) {
        WrenchBasis basis(6, given + 8);
        model.wrench_basis(contacts, basis.leftCols(given));
      }));
      attempts.push_back(with_room("pattern_wrenches", 3 + off, 3, [&model](auto contacts, int given) {
        std::vector<Wrench> wrenches(static_cast<std::size_t>(given + 8));
        model.pattern_wrenches(contacts, std::span(wrenches).first(static_cast<std::size_t>(given)));
      }));
      if (!limits) continue;
      attempts.push_back(with_room("primitive_wrenches", edges + off, edges, [limits](auto contacts, int given) {
        WrenchBasis wrenches(6, given + 8);
        limits->primitive_wrenches(contacts, 8, wrenches.leftCols(given));
      }));
    }
    return attempts;
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    // The normal alone: neither the point nor, without friction, the approach axis need matter.
    const ContactFrame contact = ContactFrame::at({0.1, 0.2, 0.3}, {0.6, number, 0.8}, {0.0, 1.0, 0.0});
    const ContactModel& model = model_at(component);
    std::vector<Attempt> attempts = {
        {fmt::format("wrench_basis with {} in the normal", number),
         [&model, contact] {
           const WrenchBasis basis = basis_of(model, {&contact, 1});
           return std::vector<double>(basis.data(), basis.data() + basis.size());
         }},
        {fmt::format("pattern_wrenches with {} in the normal", number), [&model, contact] {
           const WrenchBasis pattern = pattern_of(model, {&contact, 1});
           return std::vector<double>(pattern.data(), pattern.data() + pattern.size());
         }}};
    const ContactLimits* limits = contact_limits(model);
    if (!limits) return attempts;
    attempts.push_back({fmt::format("primitive_wrenches with {} in the normal", number), [limits, contact] {
                          const WrenchBasis edges = edges_of(*limits, {&contact, 1}, 8);
                          return std::vector<double>(edges.data(), edges.data() + edges.size());
                        }});
    return attempts;
  }

  std::optional<Answers> batch(void* component, int count, std::uint64_t seed) const override {
    const ContactModel& model = model_at(component);
    Random random(seed);
    const auto contacts = drawn(random, count);
    Answers answers;
    append(answers.together, pattern_of(model, contacts));
    for (const auto& contact : contacts) append(answers.singly, pattern_of(model, {&contact, 1}));
    return answers;
  }
};

}  // namespace

const Probe& contact_probe() {
  static const ContactProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
