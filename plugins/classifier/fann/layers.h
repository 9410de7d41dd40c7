#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace preshape::fann_plugin {

/// Numbers of inputs, hidden units and outputs.
struct Shape {
  std::size_t features = 0, hidden = 0, outputs = 0;
  bool operator==(const Shape&) const = default;

  std::size_t weights() const { return (features + 1) * hidden + (hidden + 1) * outputs; }
};

/// A trained network as numbers alone: weights in FANN's order, that is for each hidden unit those from the
/// inputs and from the constant one, then for each output those from the hidden units and from the constant
/// one. Answering writes into nothing that is shared, as fann_run would.
struct Layers {
  Shape shape;
  std::vector<float> weights;

  /// Logistic units in both layers, as FANN_SIGMOID with a steepness of one half.
  /// @param input features values; @param hidden room for the hidden units; @param outputs overwritten
  void run(const float* input, std::span<float> hidden, std::span<float> outputs) const;
};

}  // namespace preshape::fann_plugin
