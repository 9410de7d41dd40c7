#pragma once

#include <functional>

#include "coding.h"
#include "network.h"

namespace preshape::mlp {

enum class Trainer { kRprop, kBackprop, kLbfgs, kLevenbergMarquardt };

struct TrainingSettings {
  Trainer trainer = Trainer::kRprop;
  Loss loss = Loss::kCrossEntropy;
  LearningRates rates;  ///< of kBackprop
  float weight_range = 0.5f, weight_decay = 0.0f;
  double goal = 1e-3;  ///< mean squared error over rows and bits
  int max_epochs = 1000, restarts = 0;
  double validation = 0.0;  ///< share of the rows that is held out; 0: learn all
  int patience = 100;       ///< epochs without a lower error of the held-out rows after which a run ends
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

/// What is to be learned: rows for the network, and the bits that they stand for.
struct Lesson {
  Rows rows;                ///< targets are the units'
  std::vector<float> bits;  ///< rows.count x coding.bits()
  Coding coding;
};

/// @param bits probabilities, rows.count x coding.bits()
Fit fit_of(const Lesson& lesson, std::span<const float> bits);

struct Trained {
  Network network;
  Fit fit;  ///< of all rows, also the held-out ones
  int epochs = 0, restarts = 0;
  bool arrived = false;        ///< no row is wrong and the error is at the goal
  bool stopped_early = false;  ///< by the held-out rows, with the weights that knew them best
};

/// A lesson in two: what is learned, and what is held out. Which rows, the draws decide.
struct Parts {
  Lesson learned, held_out;
};
/// @param share of the rows, 0 .. 0.5: at least one of two or more is held out
Parts hold_out(const Lesson& lesson, double share, Random& random);

/// Called now and then with the epoch and the error; may throw to stop.
using Watcher = std::function<void(int epoch, double mean_squared_error)>;

/// Trains one network from random weights, anew when it stalls, and gives the best run. It arrives only when
/// the error is at most the goal and no row is wrong. With rows held out a run ends, too, when they have not
/// been known better for long; its network is the one that knew them best.
Trained train(const Lesson& lesson, const Shape& shape, const TrainingSettings& settings, Random& random,
              const Watcher& watch);

}  // namespace preshape::mlp
