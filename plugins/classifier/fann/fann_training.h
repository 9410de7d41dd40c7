#pragma once

#include <functional>

#include "layers.h"
#include "preshape/base/random.h"

namespace preshape::fann_plugin {

enum class Trainer { kRprop, kQuickprop, kIncremental, kBatch };

struct TrainingSettings {
  Trainer trainer = Trainer::kRprop;
  bool tanh_error = false;  ///< FANN's error function that makes large errors larger
  float learning_rate = 0.7f, momentum = 0.0f, weight_range = 0.5f;
  double goal = 1e-3;  ///< mean squared error over rows and bits
  int max_epochs = 1000, restarts = 0;
};

/// Rows to be learned.
struct Lesson {
  std::size_t rows = 0;
  std::vector<float> inputs, targets;  ///< rows x features, rows x outputs
};

/// How well the rows' bits are known.
struct Fit {
  double mean_squared_error = 0.0;
  std::size_t wrong_rows = 0;  ///< with a bit on the wrong side of 0.5
  bool better_than(const Fit& other) const {
    return wrong_rows != other.wrong_rows ? wrong_rows < other.wrong_rows
                                          : mean_squared_error < other.mean_squared_error;
  }
};
Fit fit_of(const Layers& layers, const Lesson& lesson);

struct Trained {
  Layers layers;
  Fit fit;
  int epochs = 0, restarts = 0;
  bool arrived = false;
};

/// Called now and then with the epoch and the error; may throw to stop.
using Watcher = std::function<void(int epoch, double mean_squared_error)>;

/// Trains a network of FANN's from weights that `random` gives, anew when it stalls, and gives the best run.
/// Nothing of FANN outlives the call, and the process's rand() goes on as if it had not been.
/// @throws Error when FANN cannot allocate
Trained train(const Lesson& lesson, const Shape& shape, const TrainingSettings& settings, Random& random,
              const Watcher& watch);

}  // namespace preshape::fann_plugin
