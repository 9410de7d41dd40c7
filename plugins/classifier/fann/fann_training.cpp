#include "fann_training.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>

#include <fann.h>

#include "preshape/base/error.h"

namespace preshape::fann_plugin {

namespace {

struct Destroy {
  void operator()(fann* network) const { fann_destroy(network); }
};
using NetworkPointer = std::unique_ptr<fann, Destroy>;

/// FANN seeds the process's rand() from the system whenever it makes a network. While this lives, rand() has a
/// state of its own; afterwards it goes on where it was.
class RandKept {
 public:
  RandKept() : lock_(mutex()), kept_(initstate(1, state_, sizeof(state_))) {}
  ~RandKept() {
    if (kept_) setstate(kept_);
  }
  RandKept(const RandKept&) = delete;
  RandKept& operator=(const RandKept&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex m;
    return m;
  }
  std::lock_guard<std::mutex> lock_;
  char state_[64] = {};
  char* kept_;
};

[[noreturn]] void no_memory(const Shape& shape) {
  throw Error("classifier 'fann': there is no memory for a network of " + std::to_string(shape.weights()) +
              " weights and its rows; take fewer hidden units or rows");
}

NetworkPointer make_network(const Shape& shape) {
  // What goes wrong is told by our own exceptions.
  static const bool silent = (fann_set_error_log(nullptr, nullptr), true);
  static_cast<void>(silent);
  const unsigned int layers[] = {static_cast<unsigned>(shape.features), static_cast<unsigned>(shape.hidden),
                                 static_cast<unsigned>(shape.outputs)};
  const RandKept kept;
  NetworkPointer network(fann_create_standard_array(3, layers));
  if (!network || network->total_connections != shape.weights()) no_memory(shape);
  return network;
}

/// A lesson as FANN reads it. The memory is ours: where FANN's own gets none, it frees what it never had.
class Data {
 public:
  Data(const Lesson& lesson, const Shape& shape) : inputs_(lesson.inputs), targets_(lesson.targets) {
    for (std::size_t r = 0; r < lesson.rows; ++r) {
      input_rows_.push_back(inputs_.data() + r * shape.features);
      target_rows_.push_back(targets_.data() + r * shape.outputs);
    }
    data_.num_data = static_cast<unsigned>(lesson.rows);
    data_.num_input = static_cast<unsigned>(shape.features);
    data_.num_output = static_cast<unsigned>(shape.outputs);
    data_.input = input_rows_.data();
    data_.output = target_rows_.data();
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;

  fann_train_data* get() { return &data_; }

 private:
  std::vector<float> inputs_, targets_;
  std::vector<float*> input_rows_, target_rows_;
  fann_train_data data_{};
};

fann_train_enum algorithm_of(Trainer trainer) {
  switch (trainer) {
    case Trainer::kQuickprop: return FANN_TRAIN_QUICKPROP;
    case Trainer::kIncremental: return FANN_TRAIN_INCREMENTAL;
    case Trainer::kBatch: return FANN_TRAIN_BATCH;
    case Trainer::kRprop: break;
  }
  return FANN_TRAIN_RPROP;
}

void set_up(fann* network, const TrainingSettings& settings, Random& random) {
  fann_set_activation_function_hidden(network, FANN_SIGMOID);
  fann_set_activation_function_output(network, FANN_SIGMOID);
  fann_set_activation_steepness_hidden(network, 0.5f);
  fann_set_activation_steepness_output(network, 0.5f);
  fann_set_training_algorithm(network, algorithm_of(settings.trainer));
  fann_set_train_error_function(network, settings.tanh_error ? FANN_ERRORFUNC_TANH : FANN_ERRORFUNC_LINEAR);
  fann_set_learning_rate(network, settings.learning_rate);
  fann_set_learning_momentum(network, settings.momentum);
  // fann_set_weight_array looks each weight up among all; in place it is one pass.
  for (unsigned i = 0; i < network->total_connections; ++i) {
    network->weights[i] = static_cast<float>(random.uniform(-settings.weight_range, settings.weight_range));
  }
}

/// What FANN would allocate in its first epoch, and go on without where it got none. FANN frees it.
void allocate_for_training(fann* network, const Shape& shape) {
  const auto zeros = [&](unsigned count) {
    auto* numbers = static_cast<fann_type*>(std::calloc(count, sizeof(fann_type)));
    if (!numbers) no_memory(shape);
    return numbers;
  };
  const unsigned connections = network->total_connections_allocated;
  network->train_errors = zeros(network->total_neurons);
  network->train_slopes = zeros(connections);
  network->prev_steps = zeros(connections);
  network->prev_train_slopes = zeros(connections);
  network->prev_weights_deltas = zeros(connections);
  if (network->training_algorithm == FANN_TRAIN_RPROP) {
    std::fill_n(network->prev_steps, connections, network->rprop_delta_zero);
  }
}

/// Tells when a run has come to a halt: no hundredth of the error less in many epochs. Back-propagation creeps
/// over plateaus thousands of epochs long, so that only its cap ends it.
class StallWatch {
 public:
  explicit StallWatch(Trainer trainer)
      : patience_(trainer == Trainer::kRprop || trainer == Trainer::kQuickprop ? 300 : 1 << 30) {}

  bool stalled(double error) {
    if (error < 0.99 * least_) least_ = error, since_ = 0;
    return ++since_ > patience_;
  }

 private:
  int patience_, since_ = 0;
  double least_ = INFINITY;
};

Trained run(fann* network, fann_train_data* data, const Lesson& lesson, const Shape& shape,
            const TrainingSettings& settings, const Watcher& watch) {
  constexpr int kWatchEvery = 16;
  StallWatch stall(settings.trainer);
  Trained now;
  now.layers.shape = shape;
  for (;; ++now.epochs) {
    now.layers.weights.assign(network->weights, network->weights + network->total_connections);
    now.fit = fit_of(now.layers, lesson);
    now.arrived = now.fit.wrong_rows == 0 && now.fit.mean_squared_error <= settings.goal;
    if (now.arrived || now.epochs >= settings.max_epochs || stall.stalled(now.fit.mean_squared_error)) return now;
    if (now.epochs % kWatchEvery == 0) watch(now.epochs, now.fit.mean_squared_error);
    fann_train_epoch(network, data);
  }
}

}  // namespace

Fit fit_of(const Layers& layers, const Lesson& lesson) {
  const Shape& shape = layers.shape;
  std::vector<float> hidden(shape.hidden), outputs(shape.outputs);
  Fit fit;
  double squares = 0.0;
  for (std::size_t r = 0; r < lesson.rows; ++r) {
    layers.run(lesson.inputs.data() + r * shape.features, hidden, outputs);
    bool wrong = false;
    for (std::size_t k = 0; k < shape.outputs; ++k) {
      const double error = static_cast<double>(outputs[k]) - lesson.targets[r * shape.outputs + k];
      squares += error * error;
      wrong = wrong || !(std::abs(error) < 0.5);
    }
    fit.wrong_rows += wrong;
  }
  fit.mean_squared_error = squares / static_cast<double>(lesson.targets.size());
  return fit;
}

Trained train(const Lesson& lesson, const Shape& shape, const TrainingSettings& settings, Random& random,
              const Watcher& watch) {
  Data data(lesson, shape);
  Trained best;
  for (int restart = 0; restart <= settings.restarts; ++restart) {
    const NetworkPointer network = make_network(shape);
    set_up(network.get(), settings, random);
    allocate_for_training(network.get(), shape);
    Trained trained = run(network.get(), data.get(), lesson, shape, settings, watch);
    trained.restarts = restart;
    const bool arrived = trained.arrived;
    if (restart == 0 || arrived || trained.fit.better_than(best.fit)) best = std::move(trained);
    if (arrived) break;
  }
  return best;
}

}  // namespace preshape::fann_plugin
