#include "network.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace preshape::mlp {

namespace {

/// 1 / (1 + exp(-x)) to a few units in the last place, without calls or branches, so that the compiler puts
/// it into vectors: exp(y) = 2^n exp(r) with |r| <= ln(2) / 2 and a polynomial for exp(r) [Cephes, expf].
void sigmoid(float* x, std::size_t count) {
  constexpr float kRound = 12582912.0f;  // 1.5 * 2^23: adding it rounds to a whole number
  for (std::size_t i = 0; i < count; ++i) {
    float y = -x[i];
    y = y > 87.0f ? 87.0f : y;
    y = y < -87.0f ? -87.0f : y;
    const float shifted = y * 1.44269504f + kRound;
    const float n = shifted - kRound;
    const float r = (y - n * 0.693359375f) + n * 2.12194440e-4f;
    float p = 1.9875691500e-4f;
    p = p * r + 1.3981999507e-3f;
    p = p * r + 8.3334519073e-3f;
    p = p * r + 4.1665795894e-2f;
    p = p * r + 1.6666665459e-1f;
    p = p * r + 5.0000001201e-1f;
    const float e = p * r * r + r + 1.0f;
    const std::uint32_t power = std::bit_cast<std::uint32_t>(shifted) - std::bit_cast<std::uint32_t>(kRound);
    const float scaled = std::bit_cast<float>(std::bit_cast<std::uint32_t>(e) + (power << 23));
    x[i] = 1.0f / (1.0f + scaled);
  }
}

/// y += sum over m < n of a[m * a_step] * (row m of x), four rows at a time so that y is loaded less often.
void add_combination(const float* a, std::size_t a_step, const float* __restrict x, std::size_t x_step,
                     std::size_t n, float* __restrict y, std::size_t width) {
  std::size_t m = 0;
  for (; m + 4 <= n; m += 4) {
    const float a0 = a[m * a_step], a1 = a[(m + 1) * a_step], a2 = a[(m + 2) * a_step],
                a3 = a[(m + 3) * a_step];
    const float* x0 = x + m * x_step;
    const float *x1 = x0 + x_step, *x2 = x1 + x_step, *x3 = x2 + x_step;
    for (std::size_t j = 0; j < width; ++j) y[j] += (a0 * x0[j] + a1 * x1[j]) + (a2 * x2[j] + a3 * x3[j]);
  }
  for (; m < n; ++m) {
    const float a0 = a[m * a_step];
    const float* x0 = x + m * x_step;
    for (std::size_t j = 0; j < width; ++j) y[j] += a0 * x0[j];
  }
}

/// Eight partial sums, so that it is put into vectors without changing the order of additions.
float dot(const float* __restrict a, const float* __restrict b, std::size_t width) {
  float sums[8] = {};
  for (std::size_t j = 0; j < width; j += 8) {
    for (std::size_t l = 0; l < 8; ++l) sums[l] += a[j + l] * b[j + l];
  }
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

/// Derivative of the loss by each output's net input.
void output_deltas(const float* outputs, const float* targets, std::size_t count, Loss loss, float* deltas) {
  for (std::size_t k = 0; k < count; ++k) {
    const float error = outputs[k] - targets[k];
    deltas[k] = loss == Loss::kCrossEntropy ? error : error * outputs[k] * (1.0f - outputs[k]);
  }
}

/// From the outputs' deltas back to those of the hidden units; zero for the padding and the constant one.
void hidden_deltas(const float* deltas, const float* output_weights, const float* __restrict hidden,
                   std::size_t outputs, std::size_t stride, float* __restrict result) {
  std::fill(result, result + stride, 0.0f);
  add_combination(deltas, 1, output_weights, stride, outputs, result, stride);
  for (std::size_t j = 0; j < stride; ++j) result[j] *= hidden[j] * (1.0f - hidden[j]);
}

/// w += last, where last = momentum * last - scale * x.
void step(float scale, float momentum, const float* __restrict x, float* __restrict last, float* __restrict w,
          std::size_t width) {
  for (std::size_t j = 0; j < width; ++j) {
    last[j] = momentum * last[j] - scale * x[j];
    w[j] += last[j];
  }
}

}  // namespace

double loss_of(std::span<const float> outputs, std::span<const float> targets, Loss loss) {
  constexpr double kLeast = 1e-30;  // of a likelihood: below the least output that is not rounded to zero
  double sum = 0.0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const double o = outputs[i], t = targets[i];
    if (loss == Loss::kSquared) sum += 0.5 * (o - t) * (o - t);
    else sum -= t * std::log(std::max(o, kLeast)) + (1.0 - t) * std::log(std::max(1.0 - o, kLeast));
  }
  return sum;
}

Rows::Rows(const Shape& shape, std::size_t rows)
    : count(rows),
      input_width(static_cast<std::size_t>(shape.features) + 1),
      target_width(static_cast<std::size_t>(shape.outputs)),
      inputs(rows * input_width, 1.0f),
      targets(rows * target_width) {}

Network::Network(const Shape& shape) : shape_(shape), weights_(shape.weights()) {}

Network Network::random(const Shape& shape, float range, Random& random) {
  Network network(shape);
  const std::size_t stride = shape.stride(), hidden = static_cast<std::size_t>(shape.hidden);
  for (std::size_t row = 0; row < shape.rows(); ++row) {
    // The hidden layer's constant one has weights to the outputs only.
    const std::size_t count = row < shape.inputs() ? hidden : hidden + 1;
    for (std::size_t j = 0; j < count; ++j) {
      network.weights_[row * stride + j] = static_cast<float>(random.uniform(-range, range));
    }
  }
  return network;
}

void Network::forward(const float* input, float* hidden, float* outputs) const {
  const std::size_t stride = shape_.stride(), constant_one = static_cast<std::size_t>(shape_.hidden);
  std::fill(hidden, hidden + stride, 0.0f);
  add_combination(input, 1, weights_.data(), stride, shape_.inputs(), hidden, stride);
  sigmoid(hidden, stride);
  hidden[constant_one] = 1.0f;
  std::fill(hidden + constant_one + 1, hidden + stride, 0.0f);
  const float* row = weights_.data() + shape_.inputs() * stride;
  for (int k = 0; k < shape_.outputs; ++k, row += stride) outputs[k] = dot(row, hidden, stride);
  sigmoid(outputs, static_cast<std::size_t>(shape_.outputs));
}

void Network::add_gradient(const Rows& rows, Loss loss, std::span<float> gradient,
                           std::span<float> outputs) const {
  constexpr std::size_t kBlock = 32;  // rows whose hidden layer stays in the first cache
  const std::size_t stride = shape_.stride(), inputs = shape_.inputs(), width = rows.target_width;
  const float* output_weights = weights_.data() + inputs * stride;
  std::vector<float> hidden(kBlock * stride), back(kBlock * stride), deltas(kBlock * width);
  for (std::size_t first = 0; first < rows.count; first += kBlock) {
    const std::size_t count = std::min(kBlock, rows.count - first);
    for (std::size_t r = 0; r < count; ++r) {
      float* output = outputs.data() + (first + r) * width;
      forward(rows.input(first + r), hidden.data() + r * stride, output);
      output_deltas(output, rows.target(first + r), width, loss, deltas.data() + r * width);
      hidden_deltas(deltas.data() + r * width, output_weights, hidden.data() + r * stride, width, stride,
                    back.data() + r * stride);
    }
    for (std::size_t i = 0; i < inputs; ++i) {
      add_combination(rows.input(first) + i, rows.input_width, back.data(), stride, count,
                      gradient.data() + i * stride, stride);
    }
    for (std::size_t k = 0; k < width; ++k) {
      add_combination(deltas.data() + k, width, hidden.data(), stride, count,
                      gradient.data() + (inputs + k) * stride, stride);
    }
  }
}

void Network::back_propagate(const Rows& rows, Loss loss, const LearningRates& rates, std::span<float> last) {
  const std::size_t stride = shape_.stride(), inputs = shape_.inputs(), width = rows.target_width;
  std::vector<float> hidden(stride), back(stride), outputs(width), deltas(width);
  for (std::size_t r = 0; r < rows.count; ++r) {
    const float* input = rows.input(r);
    forward(input, hidden.data(), outputs.data());
    output_deltas(outputs.data(), rows.target(r), width, loss, deltas.data());
    hidden_deltas(deltas.data(), weights_.data() + inputs * stride, hidden.data(), width, stride,
                  back.data());
    for (std::size_t row = 0; row < shape_.rows(); ++row) {
      const bool into_hidden = row < inputs;
      const float scale = into_hidden ? rates.hidden * input[row] : rates.output * deltas[row - inputs];
      step(scale, rates.momentum, into_hidden ? back.data() : hidden.data(), last.data() + row * stride,
           weights_.data() + row * stride, stride);
    }
  }
}

}  // namespace preshape::mlp
