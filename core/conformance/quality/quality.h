#pragma once

#include "grasps.h"

namespace preshape::conformance {

/// "" when all values are finite and in the declared ranges, else the first that is not.
std::string out_of_range(std::span<const QualityNumber> numbers, std::span<const double> values);

// known.cpp
void q07_degenerate(Context& context);
void q10_known_counts(Context& context);

}  // namespace preshape::conformance
