#include "network.h"

#include <cmath>

#include "preshape/base/random.h"
#include "support/near.h"

using namespace preshape::mlp;
using preshape::Random;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

const Shape kShape{5, 9, 4};

Rows random_rows(const Shape& shape, std::size_t count, Random& random) {
  Rows rows(shape, count);
  for (std::size_t r = 0; r < count; ++r) {
    for (int i = 0; i < shape.features; ++i) rows.input(r)[i] = static_cast<float>(random.uniform(-2, 2));
    for (int k = 0; k < shape.outputs; ++k) rows.target(r)[k] = static_cast<float>(random.below(2));
  }
  return rows;
}

std::vector<float> outputs_of(const Network& network, const Rows& rows) {
  std::vector<float> outputs(rows.targets.size()), hidden(network.shape().stride());
  for (std::size_t r = 0; r < rows.count; ++r) {
    network.forward(rows.input(r), hidden.data(), outputs.data() + r * rows.target_width);
  }
  return outputs;
}

/// The network once more, unit by unit in double, from the layout that Shape describes.
double loss_of(const Network& network, const std::vector<double>& w, const Rows& rows, Loss kind) {
  const Shape& shape = network.shape();
  const auto sigmoid = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  const auto weight = [&](std::size_t row, int j) {
    return w[row * shape.stride() + static_cast<std::size_t>(j)];
  };
  double loss = 0.0;
  for (std::size_t r = 0; r < rows.count; ++r) {
    std::vector<double> hidden;
    for (int j = 0; j < shape.hidden; ++j) {
      double net = 0.0;
      for (std::size_t i = 0; i < shape.inputs(); ++i) net += weight(i, j) * rows.input(r)[i];
      hidden.push_back(sigmoid(net));
    }
    for (int k = 0; k < shape.outputs; ++k) {
      const std::size_t row = shape.inputs() + static_cast<std::size_t>(k);
      double net = weight(row, shape.hidden);
      for (int j = 0; j < shape.hidden; ++j) net += weight(row, j) * hidden[static_cast<std::size_t>(j)];
      const double o = sigmoid(net), t = rows.target(r)[k];
      loss += kind == Loss::kSquared ? (o - t) * (o - t) / 2 : -t * std::log(o) - (1 - t) * std::log(1 - o);
    }
  }
  return loss;
}

std::vector<double> weights_of(const Network& network) {
  return {network.weights().begin(), network.weights().end()};
}

}  // namespace

TEST_CASE("MLP network: outputs are the logistic sigmoid's to float precision, also where it is flat") {
  const Shape shape{1, 1, 1};
  Network network(shape);
  // The output sees the constant one alone, through its bias.
  const std::size_t bias = shape.inputs() * shape.stride() + 1;
  float input[] = {0.0f, 1.0f}, hidden[8], output;
  for (double x = -80.0; x <= 80.0; x += 0.0625) {
    network.weights()[bias] = static_cast<float>(x);
    network.forward(input, hidden, &output);
    const double exact = 1.0 / (1.0 + std::exp(-x));
    CHECK_NEAR(static_cast<double>(output), exact, 4e-7 * exact);  // three float roundings and the polynomial
  }
  network.weights()[bias] = 1e30f;
  network.forward(input, hidden, &output);
  CHECK(output == 1.0f);
}

TEST_CASE("MLP network: the gradient is that of finite differences, under either loss") {
  for (const Loss loss : {Loss::kCrossEntropy, Loss::kSquared}) {
    Random random(7);
    const Network network = Network::random(kShape, 1.0f, random);
    const Rows rows = random_rows(kShape, 50, random);  // more than one block of rows
    std::vector<float> gradient(kShape.weights()), outputs(rows.targets.size());
    network.add_gradient(rows, loss, gradient, outputs);
    CHECK(outputs == outputs_of(network, rows));
    const auto weights = weights_of(network);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      constexpr double kStep = 1e-5;
      auto above = weights, below = weights;
      above[i] += kStep, below[i] -= kStep;
      const double expected =
          (loss_of(network, above, rows, loss) - loss_of(network, below, rows, loss)) / (2 * kStep);
      // Fifty rows of at most about one each, summed in float.
      CHECK_NEAR(static_cast<double>(gradient[i]), expected, 2e-5);
    }
  }
}

TEST_CASE("MLP network: an online step of one row is the gradient times each layer's rate") {
  Random random(8);
  const Network start = Network::random(kShape, 1.0f, random);
  const Rows rows = random_rows(kShape, 1, random);
  std::vector<float> gradient(kShape.weights()), outputs(rows.targets.size()), last(kShape.weights(), 0.25f);
  start.add_gradient(rows, Loss::kSquared, gradient, outputs);
  Network network = start;
  network.back_propagate(rows, Loss::kSquared, {0.6f, 0.5f, 0.0f}, last);
  const std::size_t into_outputs = kShape.inputs() * kShape.stride();
  for (std::size_t i = 0; i < last.size(); ++i) {
    const double rate = i < into_outputs ? 0.6 : 0.5;
    CHECK_NEAR(network.weights()[i], start.weights()[i] - rate * gradient[i], 1e-6);
  }
}

TEST_CASE("MLP network: momentum repeats its share of the last step") {
  Random random(9);
  Network network = Network::random(kShape, 1.0f, random);
  const std::vector<float> before(network.weights().begin(), network.weights().end());
  Rows rows = random_rows(kShape, 1, random);
  std::vector<float> last(kShape.weights(), 0.5f);
  network.back_propagate(rows, Loss::kSquared, {0.0f, 0.0f, 0.5f}, last);
  for (std::size_t i = 0; i < last.size(); ++i) CHECK(network.weights()[i] == before[i] + 0.25f);
}

TEST_CASE("MLP network: the padding takes no part and stays zero") {
  Random random(10);
  Network network = Network::random(kShape, 1.0f, random);
  const Rows rows = random_rows(kShape, 20, random);
  std::vector<float> last(kShape.weights());
  for (int epoch = 0; epoch < 50; ++epoch) network.back_propagate(rows, Loss::kCrossEntropy, {}, last);
  for (std::size_t row = 0; row < kShape.rows(); ++row) {
    const std::size_t used = static_cast<std::size_t>(kShape.hidden) + (row < kShape.inputs() ? 0 : 1);
    for (std::size_t j = used; j < kShape.stride(); ++j)
      CHECK(network.weights()[row * kShape.stride() + j] == 0.0f);
  }
}

TEST_SUITE_END();
