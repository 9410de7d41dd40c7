#pragma once

#include <string_view>

#include "preshape/fuzzy/pattern.h"

namespace preshape::conformance {

/// A published similarity, written here for clarity alone.
struct Formula {
  std::string_view capability;
  const char* source;
  double (*score)(const PatternView& task, const PatternView& pattern);
};

/// The formula that a component with that capability says it is; null for any other capability.
const Formula* formula_named(std::string_view capability);

}  // namespace preshape::conformance
