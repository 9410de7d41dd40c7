#include <cmath>
#include <cstdlib>
#include <memory>
#include <thread>

#include <fann.h>

#include "../../../plugins/classifier/fann/state.h"
#include "cube_lessons.h"
#include "network.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

using Status = TrainingOutcome::Status;

std::shared_ptr<Classifier> make(const char* name, Value::Table parameters = {}) {
  return registry().create<Classifier>(name, Value::table(std::move(parameters)));
}

RowMatrix predicted(const Classifier& classifier, const RowMatrix& inputs, Eigen::Index bits) {
  RowMatrix result(inputs.rows(), bits);
  classifier.predict(inputs, result);
  return result;
}

struct Destroy {
  void operator()(fann* network) const { fann_destroy(network); }
  void operator()(fann_train_data* data) const { fann_destroy_train(data); }
};

constexpr unsigned kFeatures_ = 5, kHidden = 9, kOutputs = 4, kRows = 20;

/// A network of FANN's own as the plugin sets it up, with weights of ours.
std::unique_ptr<fann, Destroy> network_of(const fann_plugin::Layers& layers) {
  std::unique_ptr<fann, Destroy> network(fann_create_standard(3, kFeatures_, kHidden, kOutputs));
  REQUIRE(network->total_connections == layers.weights.size());
  std::copy(layers.weights.begin(), layers.weights.end(), network->weights);
  fann_set_activation_function_hidden(network.get(), FANN_SIGMOID);
  fann_set_activation_function_output(network.get(), FANN_SIGMOID);
  fann_set_train_error_function(network.get(), FANN_ERRORFUNC_LINEAR);
  return network;
}

fann_plugin::Layers random_layers(Random& random, double range) {
  fann_plugin::Layers layers{{kFeatures_, kHidden, kOutputs}, {}};
  layers.weights.resize(layers.shape.weights());
  for (float& w : layers.weights) w = static_cast<float>(random.uniform(-range, range));
  return layers;
}

/// Our network with FANN's weights.
mlp::Network same_network(const fann_plugin::Layers& layers) {
  const mlp::Shape shape{kFeatures_, kHidden, kOutputs};
  mlp::Network network(shape);
  const float* weight = layers.weights.data();
  for (std::size_t j = 0; j < kHidden; ++j) {
    for (std::size_t i = 0; i <= kFeatures_; ++i) network.weights()[i * shape.stride() + j] = *weight++;
  }
  for (std::size_t k = 0; k < kOutputs; ++k) {
    for (std::size_t j = 0; j <= kHidden; ++j) network.weights()[(shape.inputs() + k) * shape.stride() + j] = *weight++;
  }
  return network;
}

/// Rows with few different inputs, each several times with different bits: no network knows the bits, and the best
/// there is are the shares of ones, with a mean squared error of p (1 - p) each.
struct Shares {
  RowMatrix inputs{48, 6}, targets{48, 3};
  double least = 0.0;

  explicit Shares(Random& random) {
    for (Eigen::Index group = 0; group < 8; ++group) {
      for (Eigen::Index i = 0; i < 6; ++i) inputs(6 * group, i) = random.uniform(-2, 2);
      for (Eigen::Index k = 0; k < 3; ++k) {
        const auto ones = static_cast<Eigen::Index>(1 + random.below(5));
        for (Eigen::Index r = 0; r < 6; ++r) targets(6 * group + r, k) = r < ones ? 1.0 : 0.0;
        const double p = static_cast<double>(ones) / 6;
        least += p * (1 - p) / 24;
      }
      for (Eigen::Index r = 1; r < 6; ++r) inputs.row(6 * group + r) = inputs.row(6 * group);
    }
  }
};

}  // namespace

TEST_CASE("FANN: from the same weights its online back-propagation and ours move all weights alike, epoch by epoch") {
  Random random(1);
  const fann_plugin::Layers start = random_layers(random, 0.5);
  const auto theirs = network_of(start);
  mlp::Network ours = same_network(start);
  mlp::Rows rows(ours.shape(), kRows);
  const std::unique_ptr<fann_train_data, Destroy> data(fann_create_train(kRows, kFeatures_, kOutputs));
  for (std::size_t r = 0; r < kRows; ++r) {
    for (std::size_t i = 0; i < kFeatures_; ++i)
      rows.input(r)[i] = data->input[r][i] = static_cast<float>(random.uniform(-2, 2));
    for (std::size_t k = 0; k < kOutputs; ++k)
      rows.target(r)[k] = data->output[r][k] = static_cast<float>(random.below(2));
  }
  fann_set_training_algorithm(theirs.get(), FANN_TRAIN_INCREMENTAL);
  fann_set_learning_rate(theirs.get(), 0.3f);
  std::vector<float> last(ours.weights().size());
  for (int epoch = 1; epoch <= 30; ++epoch) {
    fann_train_epoch(theirs.get(), data.get());
    ours.back_propagate(rows, mlp::Loss::kSquared, {0.3f, 0.3f, 0.0f}, last);
    fann_plugin::Layers now{start.shape, {theirs->weights, theirs->weights + theirs->total_connections}};
    const mlp::Network expected = same_network(now);
    for (std::size_t i = 0; i < last.size(); ++i) {
      // 20 rows an epoch, each a handful of float roundings of numbers of about one.
      CHECK_NEAR(static_cast<double>(ours.weights()[i]), static_cast<double>(expected.weights()[i]), epoch * 20 * 6e-8);
    }
  }
}

TEST_CASE("FANN: the two layers computed from its weights answer as fann_run does, also where units are flat") {
  Random random(2);
  for (const double range : {0.5, 3.0, 100.0}) {
    const fann_plugin::Layers layers = random_layers(random, range);
    const auto network = network_of(layers);
    std::vector<float> input(kFeatures_), hidden(kHidden), outputs(kOutputs);
    for (int trial = 0; trial < 100; ++trial) {
      for (float& x : input) x = static_cast<float>(random.uniform(-2, 2));
      layers.run(input.data(), hidden, outputs);
      const float* expected = fann_run(network.get(), input.data());
      for (std::size_t k = 0; k < kOutputs; ++k) {
        // Sums of ten floats of up to the range, whose rounding the sigmoid takes over by a quarter.
        CHECK_NEAR(static_cast<double>(outputs[k]), static_cast<double>(expected[k]), 1e-6 * (1 + range));
      }
    }
  }
}

TEST_CASE("FANN and our trainer reach the same error on the same data, which is the least there is") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random(seed);
    const Shares lesson(random);
    const auto theirs = make("fann", {{"hidden", 20}, {"trainer", "rprop"}, {"error", "linear"}, {"scaling", "none"}, {"max_epochs", 2000}});
    const auto ours = make("mlp", {{"hidden", 20}, {"loss", "squared"}, {"scaling", "none"}, {"max_epochs", 2000},
                                   {"outputs", "bits"}, {"committee", 1}, {"weight_decay", 0.0}});
    const auto their_outcome = theirs->fit(lesson.inputs, lesson.targets, seed, nullptr),
               our_outcome = ours->fit(lesson.inputs, lesson.targets, seed, nullptr);
    MESSAGE("least ", lesson.least, ", fann ", their_outcome.mean_squared_error, " after ", their_outcome.epochs,
            ", mlp ", our_outcome.mean_squared_error, " after ", our_outcome.epochs);
    // Both end when 300 epochs have not made the error a hundredth less, far beyond where it stopped changing. It is
    // flat to second order about its minimum: outputs within a few thousandths of the shares cost a few millionths.
    CHECK_NEAR(their_outcome.mean_squared_error, lesson.least, 1e-5 * lesson.least);
    CHECK_NEAR(our_outcome.mean_squared_error, lesson.least, 1e-5 * lesson.least);
    CHECK_NEAR(predicted(*theirs, lesson.inputs, 3), predicted(*ours, lesson.inputs, 3), 5e-3);
  }
}

TEST_CASE("FANN: the 24 pretraining rows are learned by each of its trainers, and are known as the outcome says") {
  const auto m = matrices(pretraining());
  const auto learn = [&](Value::Table parameters, std::uint64_t seed) {
    const auto classifier = make("fann", std::move(parameters));
    const auto outcome = classifier->fit(m.inputs, m.targets, seed, nullptr);
    CHECK(outcome.status == Status::kArrived);
    CHECK(outcome.wrong_rows == 0);
    CHECK(outcome.mean_squared_error <= 1e-3);
    const RowMatrix errors = predicted(*classifier, m.inputs, 9) - m.targets;
    CHECK_NEAR(errors.squaredNorm() / static_cast<double>(errors.size()), outcome.mean_squared_error, 1e-9);
    return outcome.epochs;
  };
  for (std::uint64_t seed = 0; seed < 5; ++seed) CHECK(learn({}, seed) < 1000);
  for (std::uint64_t seed = 0; seed < 5; ++seed) CHECK(learn({{"trainer", "rprop"}}, seed) < 1000);
  learn({{"trainer", "rprop"}, {"error", "linear"}, {"restarts", 20}}, 1);
  learn({{"trainer", "quickprop"}, {"restarts", 20}}, 1);
  learn({{"trainer", "incremental"}, {"momentum", 0.9}, {"learning_rate", 0.1}}, 1);
  learn({{"trainer", "batch"}, {"goal", 1e-3}, {"restarts", 0}, {"max_epochs", 40000}}, 1);
}

TEST_CASE("FANN: the same rows and seed give the same bytes, another seed others, and rand() is not disturbed") {
  const auto m = matrices(pretraining());
  const auto state = [&](std::uint64_t seed) {
    const auto classifier = make("fann");
    classifier->fit(m.inputs, m.targets, seed, nullptr);
    return classifier->save();
  };
  const std::string first = state(5);
  std::srand(42);
  const int expected[] = {std::rand(), std::rand()};
  std::srand(42);
  CHECK(std::rand() == expected[0]);
  CHECK(state(5) == first);
  CHECK(std::rand() == expected[1]);
  CHECK(state(6) != first);
}

TEST_CASE("FANN: a saved state predicts bit for bit the same, and one that does not fit is refused") {
  const auto m = matrices(pretraining());
  const auto classifier = make("fann"), copy = make("fann");
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const std::string state = classifier->save();
  copy->load(state);
  CHECK(copy->trained());
  CHECK(copy->save() == state);
  CHECK(predicted(*copy, m.inputs, 9) == predicted(*classifier, m.inputs, 9));
  const auto refuse = [&](const std::string& bytes, const char* why) {
    CHECK_THROWS_SAYING(copy->load(bytes), InputError, why);
    CHECK(copy->save() == state);
  };
  refuse("", "another beginning");
  refuse(state.substr(0, 80), "cut off");
  refuse(state.substr(0, state.size() - 4), "the check sum does not fit");
  fann_plugin::State forged = fann_plugin::state_from(state);
  forged.layers.weights.pop_back();
  refuse(fann_plugin::state_bytes(forged), "another number of weights than its sizes say");
  forged.layers.weights.push_back(std::numeric_limits<float>::infinity());
  refuse(fann_plugin::state_bytes(forged), "a weight that is not finite");
  forged.layers.weights.back() = 0.0f;
  forged.asinh = false;
  refuse(fann_plugin::state_bytes(forged), "trained with another 'scaling'");
  const auto small = make("fann", {{"hidden", 20}});
  CHECK_THROWS_SAYING(small->load(state), InputError, "trained with hidden = 45, but it is set to 20");
  CHECK_THROWS_SAYING(small->save(), InputError, "has learned nothing");
}

TEST_CASE("FANN: several threads may ask, and others fit, at once") {
  const auto m = matrices(pretraining());
  const auto classifier = make("fann");
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const RowMatrix expected = predicted(*classifier, m.inputs, 9);
  std::vector<int> differing(3, 0);
  std::vector<std::thread> threads;
  for (int& count : differing) {
    threads.emplace_back([&] {
      const auto own = make("fann");
      own->fit(m.inputs, m.targets, 1, nullptr);
      count += own->save() != classifier->save();
      for (int i = 0; i < 50; ++i) count += predicted(*classifier, m.inputs, 9) != expected;
    });
  }
  for (auto& thread : threads) thread.join();
  CHECK(differing == std::vector<int>(3, 0));
}

TEST_CASE("FANN: bad rows and questions are refused by name, and what was known stays") {
  const auto m = matrices(pretraining());
  const auto classifier = make("fann");
  RowMatrix bits(1, 9);
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 15), bits), InputError, "has learned nothing yet");
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const std::string before = classifier->save();
  const auto refuse = [&](const RowMatrix& inputs, const RowMatrix& targets, const char* part) {
    CHECK_THROWS_SAYING(classifier->fit(inputs, targets, 1, nullptr), InputError, part);
    CHECK(classifier->save() == before);
  };
  refuse(RowMatrix(0, 15), RowMatrix(0, 9), "there are no rows to learn");
  refuse(m.inputs.topRows(3), m.targets, "3 x 15 inputs do not go with 24 x 9 targets");
  RowMatrix inputs = m.inputs, targets = m.targets;
  inputs(6, 2) = std::numeric_limits<double>::quiet_NaN();
  refuse(inputs, targets, "row 7 holds a number that is not finite");
  targets(4, 0) = 0.5;
  refuse(m.inputs, targets, "target 1 of row 5 must be 0 or 1, got 0.5");
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 14), bits), InputError, "has learned 15 inputs and 9 bits");
  CHECK_THROWS_SAYING(classifier->extend(m.inputs, m.targets, 25, 1, nullptr), InputError,
                      "the first new row must be in 0 .. 24, got 25");
}

TEST_SUITE_END();
