// What several of the checks of every kind share.
#include <cmath>
#include <cstring>

#include "generic.h"

namespace preshape::conformance {

Specimen specimen(Context& context, const Value& parameters) {
  const Probe& probe = probe_of(context.subject().kind);
  return {probe, probe.create(context.registry(), context.subject().name, parameters)};
}

Specimen specimen(Context& context) { return specimen(context, context.parameters()); }

bool same_bits(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    if (std::memcmp(&a[i], &b[i], sizeof(double)) != 0) return false;
  }
  return true;
}

std::string difference(std::span<const double> before, std::span<const double> now) {
  if (before.size() != now.size()) return fmt::format("there were {} numbers, now there are {}", before.size(), now.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (same_bits(before.subspan(i, 1), now.subspan(i, 1))) continue;
    return fmt::format("number {} of {} was {}, now it is {}", i + 1, before.size(), number_text(before[i]),
                       number_text(now[i]));
  }
  return "they are equal";
}

namespace {

/// Wide bounds are searched over their lower decades, where parameters usually stand.
double number_in(const ParameterDeclaration& d, Random& random) {
  const double low = std::max(d.minimum, -1e3), high = std::min(d.maximum, 1e3);
  if (low > 0.0 && high / low > 100.0) return low * std::pow(high / low, random.uniform());
  return random.uniform(low, high);
}

}  // namespace

Value drawn_parameters(Context& context, Random& random) {
  Value parameters = context.parameters();
  for (const auto& d : context.record().schema.declarations()) {
    switch (d.type) {
      case ParameterType::kBoolean: parameters.set(d.name, random.uniform() < 0.5); break;
      case ParameterType::kNumber: parameters.set(d.name, number_in(d, random)); break;
      case ParameterType::kChoice: parameters.set(d.name, d.choices[random.below(d.choices.size())]); break;
      case ParameterType::kInteger: {
        // Counts in the thousands would make each case long and show nothing more.
        const double low = std::ceil(std::max(d.minimum, -20.0)), high = std::min(d.maximum, std::max(low + 20.0, 0.0));
        parameters.set(d.name, static_cast<std::int64_t>(std::floor(random.uniform(low, high + 1.0))));
        break;
      }
      default: break;
    }
  }
  return parameters;
}

}  // namespace preshape::conformance
