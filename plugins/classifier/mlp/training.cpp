#include "training.h"

#include <algorithm>
#include <cmath>

namespace preshape::mlp {

namespace {

/// iRPROP- [IgelHuesken2003]: each weight has its own step, which grows while its gradient keeps its sign and
/// shrinks when it turns; the gradient's size does not count.
class Rprop {
 public:
  Rprop(const Network& network, const TrainingSettings& settings)
      : settings_(settings),
        gradient_(network.weights().size()),
        before_(gradient_.size()),
        steps_(gradient_.size(), kFirstStep) {}

  /// The rows' outputs, and the gradient for the move to come.
  void look(const Network& network, const Rows& rows, std::span<float> outputs) {
    std::fill(gradient_.begin(), gradient_.end(), 0.0f);
    network.add_gradient(rows, settings_.loss, gradient_, outputs);
  }

  void move(Network& network, const Rows&) {
    step(network.weights().data(), gradient_.data(), before_.data(), steps_.data(), gradient_.size());
  }

 private:
  static constexpr float kFirstStep = 0.05f, kGrow = 1.2f, kShrink = 0.5f, kLeast = 1e-6f, kMost = 50.0f;
  static constexpr float kHalfPull = 100.0f;  ///< moves after which the pull to zero has halved

  void step(float* __restrict weights, const float* __restrict gradient, float* __restrict before,
            float* __restrict steps, std::size_t count) {
    // The pull makes for smooth answers between few rows, and would keep many from arriving; so it fades.
    const float age = static_cast<float>(moves_++) / kHalfPull;
    const float decay = settings_.weight_decay / (1.0f + age * age);
    for (std::size_t i = 0; i < count; ++i) {
      const float g = gradient[i] + decay * weights[i];
      const float turn = g * before[i];
      float s = steps[i] * (turn > 0.0f ? kGrow : turn < 0.0f ? kShrink : 1.0f);
      s = s > kMost ? kMost : s;
      s = s < kLeast ? kLeast : s;
      const float kept = turn < 0.0f ? 0.0f : g;
      steps[i] = s;
      before[i] = kept;
      weights[i] -= kept > 0.0f ? s : kept < 0.0f ? -s : 0.0f;
    }
  }

  const TrainingSettings& settings_;
  std::vector<float> gradient_, before_, steps_;
  int moves_ = 0;
};

/// Online back-propagation with constant rates, as the thesis's appendix A.
class Backprop {
 public:
  Backprop(const Network& network, const TrainingSettings& settings)
      : settings_(settings), hidden_(network.shape().stride()), last_(network.weights().size()) {}

  void look(const Network& network, const Rows& rows, std::span<float> outputs) {
    for (std::size_t r = 0; r < rows.count; ++r) {
      network.forward(rows.input(r), hidden_.data(), outputs.data() + r * rows.target_width);
    }
  }

  void move(Network& network, const Rows& rows) {
    network.back_propagate(rows, settings_.loss, settings_.rates, last_);
  }

 private:
  const TrainingSettings& settings_;
  std::vector<float> hidden_, last_;
};

/// Tells when a run has come to a halt: no hundredth of the error less in many epochs.
class StallWatch {
 public:
  /// Back-propagation creeps over plateaus thousands of epochs long, so that only its cap ends it.
  explicit StallWatch(Trainer trainer) : patience_(trainer == Trainer::kRprop ? 300 : 1 << 30) {}

  bool stalled(double error) {
    if (error < 0.99 * least_) least_ = error, since_ = 0;
    return ++since_ > patience_;
  }

 private:
  int patience_, since_ = 0;
  double least_ = INFINITY;
};

class Run {
 public:
  Run(const Lesson& lesson, const TrainingSettings& settings, const Watcher& watch)
      : lesson_(lesson),
        settings_(settings),
        watch_(watch),
        outputs_(lesson.rows.targets.size()),
        bits_(lesson.bits.size()) {}

  template <class Method>
  Trained from(Network network) {
    constexpr int kWatchEvery = 64;
    Method method(network, settings_);
    StallWatch stall(settings_.trainer);
    for (int epoch = 0;; ++epoch) {
      method.look(network, lesson_.rows, outputs_);
      const Fit fit = fit_of_outputs();
      if (arrived(fit)) return {std::move(network), fit, epoch, 0, true};
      if (epoch >= settings_.max_epochs || stall.stalled(fit.mean_squared_error)) {
        return {std::move(network), fit, epoch, 0, false};
      }
      if (epoch % kWatchEvery == 0) watch_(epoch, fit.mean_squared_error);
      method.move(network, lesson_.rows);
    }
  }

 private:
  bool arrived(const Fit& fit) const {
    return fit.wrong_rows == 0 && fit.mean_squared_error <= settings_.goal;
  }

  Fit fit_of_outputs() {
    const auto units = static_cast<std::size_t>(lesson_.coding.units());
    const auto bits = static_cast<std::size_t>(lesson_.coding.bits());
    for (std::size_t r = 0; r < lesson_.rows.count; ++r) {
      lesson_.coding.decode(outputs_.data() + r * units, bits_.data() + r * bits);
    }
    return fit_of(lesson_, bits_);
  }

  const Lesson& lesson_;
  const TrainingSettings& settings_;
  const Watcher& watch_;
  std::vector<float> outputs_, bits_;
};

}  // namespace

Fit fit_of(const Lesson& lesson, std::span<const float> bits) {
  Fit fit;
  double squares = 0.0;
  const auto width = static_cast<std::size_t>(lesson.coding.bits());
  for (std::size_t r = 0; r < lesson.rows.count; ++r) {
    bool wrong = false;
    for (std::size_t i = r * width; i < (r + 1) * width; ++i) {
      const double error = static_cast<double>(bits[i]) - lesson.bits[i];
      squares += error * error;
      wrong = wrong || !(std::abs(error) < 0.5);
    }
    fit.wrong_rows += wrong;
  }
  fit.mean_squared_error = squares / static_cast<double>(bits.size());
  return fit;
}

Trained train(const Lesson& lesson, const Shape& shape, const TrainingSettings& settings, Random& random,
              const Watcher& watch) {
  Run run(lesson, settings, watch);
  Trained best{Network(shape), {INFINITY, lesson.rows.count}, 0, 0, false};
  for (int restart = 0; restart <= settings.restarts && !best.arrived; ++restart) {
    Network start = Network::random(shape, settings.weight_range, random);
    Trained trained = settings.trainer == Trainer::kRprop ? run.from<Rprop>(std::move(start))
                                                          : run.from<Backprop>(std::move(start));
    trained.restarts = restart;
    if (trained.arrived || trained.fit.better_than(best.fit)) best = std::move(trained);
  }
  return best;
}

}  // namespace preshape::mlp
