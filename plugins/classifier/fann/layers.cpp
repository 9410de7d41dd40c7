#include "layers.h"

#include <algorithm>
#include <cmath>

namespace preshape::fann_plugin {

namespace {

/// @param weights of one unit, that of the constant one last
float unit(const float* weights, const float* values, std::size_t count) {
  constexpr float kMost = 300.0f;  // FANN's own clip of twice the net input times the steepness
  float sum = weights[count];
  for (std::size_t i = 0; i < count; ++i) sum += weights[i] * values[i];
  return 1.0f / (1.0f + std::exp(-std::clamp(sum, -kMost, kMost)));
}

}  // namespace

void Layers::run(const float* input, std::span<float> hidden, std::span<float> outputs) const {
  const float* row = weights.data();
  for (float& value : hidden) value = unit(row, input, shape.features), row += shape.features + 1;
  for (float& value : outputs) value = unit(row, hidden.data(), shape.hidden), row += shape.hidden + 1;
}

}  // namespace preshape::fann_plugin
