#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "preshape/base/random.h"

namespace preshape::mlp {

/// Numbers of inputs, hidden units and outputs.
struct Shape {
  int features = 0, hidden = 0, outputs = 0;
  bool operator==(const Shape&) const = default;

  /// Hidden units with the constant one that carries the output's bias, padded to whole vectors.
  std::size_t stride() const { return (static_cast<std::size_t>(hidden) + 1 + 7) / 8 * 8; }
  /// Rows of `stride` weights: into the hidden layer from each input and from the constant one, then into
  /// each output.
  std::size_t rows() const { return inputs() + static_cast<std::size_t>(outputs); }
  /// With the constant one.
  std::size_t inputs() const { return static_cast<std::size_t>(features) + 1; }
  std::size_t weights() const { return rows() * stride(); }
};

enum class Loss { kCrossEntropy, kSquared };

/// Summed over outputs. Cross entropy: minus the log-likelihood of the targets; squared: half the squared error.
double loss_of(std::span<const float> outputs, std::span<const float> targets, Loss loss);

/// Of online back-propagation.
struct LearningRates {
  float hidden = 0.6f, output = 0.5f, momentum = 0.0f;
};

/// Rows to be learned, as the network sees them: inputs scaled and followed by the constant one.
struct Rows {
  Rows(const Shape& shape, std::size_t count);
  std::size_t count, input_width, target_width;
  std::vector<float> inputs, targets;

  const float* input(std::size_t row) const { return inputs.data() + row * input_width; }
  float* input(std::size_t row) { return inputs.data() + row * input_width; }
  const float* target(std::size_t row) const { return targets.data() + row * target_width; }
  float* target(std::size_t row) { return targets.data() + row * target_width; }
};

/// Multilayer perceptron with one hidden layer, logistic sigmoid in both (thesis sec. 3.10). In float; every
/// sum is taken in one fixed order, so that the same seed gives the same bytes.
class Network {
 public:
  explicit Network(const Shape& shape);
  /// Weights uniform in +-range.
  static Network random(const Shape& shape, float range, Random& random);

  const Shape& shape() const { return shape_; }
  std::span<const float> weights() const { return weights_; }
  std::span<float> weights() { return weights_; }

  /// One row through the network.
  /// @param input features + 1 values, the last one 1; @param hidden stride() values, overwritten
  /// @param outputs `outputs` values, overwritten
  void forward(const float* input, float* hidden, float* outputs) const;

  /// Adds the gradient of loss_of over all rows to `gradient`.
  /// @param outputs count x outputs of the rows, overwritten
  void add_gradient(const Rows& rows, Loss loss, std::span<float> gradient, std::span<float> outputs) const;

  /// Online back-propagation: for each row in turn a step of -rate * gradient + momentum * last step.
  /// @param last the last step of each weight, updated
  void back_propagate(const Rows& rows, Loss loss, const LearningRates& rates, std::span<float> last);

 private:
  Shape shape_;
  std::vector<float> weights_;
};

}  // namespace preshape::mlp
