#include "training.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "method.h"

namespace preshape::mlp {

namespace {

std::unique_ptr<Method> method_of(const TrainingSettings& settings, const Shape& shape) {
  switch (settings.trainer) {
    case Trainer::kBackprop: return backprop(shape, settings.loss, settings.rates);
    case Trainer::kLbfgs: return lbfgs(shape, settings.loss, settings.weight_decay);
    case Trainer::kLevenbergMarquardt: return levenberg_marquardt(shape, settings.loss);
    case Trainer::kRprop: break;
  }
  return rprop(shape, settings.loss, settings.weight_decay);
}

/// Tells when a run has come to a halt: no hundredth of the error less in many epochs.
class StallWatch {
 public:
  explicit StallWatch(int patience) : patience_(patience) {}

  bool stalled(double error) {
    if (error < 0.99 * least_) least_ = error, since_ = 0;
    return ++since_ > patience_;
  }

 private:
  int patience_, since_ = 0;
  double least_ = INFINITY;
};

/// How well the outputs of a lesson's rows say their bits.
class Judge {
 public:
  explicit Judge(const Lesson& lesson)
      : outputs(lesson.rows.targets.size()), lesson_(lesson), bits_(lesson.bits.size()) {}

  Fit fit() {
    const auto units = static_cast<std::size_t>(lesson_.coding.units());
    const auto bits = static_cast<std::size_t>(lesson_.coding.bits());
    for (std::size_t r = 0; r < lesson_.rows.count; ++r) {
      lesson_.coding.decode(outputs.data() + r * units, bits_.data() + r * bits);
    }
    return fit_of(lesson_, bits_);
  }

  Fit fit(const Network& network) {
    hidden_.resize(network.shape().stride());
    for (std::size_t r = 0; r < lesson_.rows.count; ++r) {
      network.forward(lesson_.rows.input(r), hidden_.data(), outputs.data() + r * lesson_.rows.target_width);
    }
    return fit();
  }

  std::vector<float> outputs;  ///< to be filled before fit()

 private:
  const Lesson& lesson_;
  std::vector<float> bits_, hidden_;
};

/// Early stopping [Prechelt1998]: the network that knew the held-out rows best, and whether that is long ago.
class HeldOut {
 public:
  HeldOut(const Lesson& lesson, const Network& start, int patience)
      : judge_(lesson), best_(start), patience_(patience) {}

  /// @returns whether the run shall end
  bool look(const Network& network) {
    const double error = judge_.fit(network).mean_squared_error;
    if (error < least_) least_ = error, best_ = network, since_ = 0;
    return ++since_ > patience_;
  }
  const Network& best() const { return best_; }

 private:
  Judge judge_;
  Network best_;
  int patience_, since_ = 0;
  double least_ = INFINITY;
};

class Run {
 public:
  /// @param held_out null: nothing is
  Run(const Lesson& lesson, const Lesson* held_out, const TrainingSettings& settings, const Watcher& watch)
      : lesson_(lesson), held_out_(held_out), settings_(settings), watch_(watch), judge_(lesson) {}

  Trained from(Network network) {
    const auto method = method_of(settings_, network.shape());
    StallWatch stall(method->patience());
    std::optional<HeldOut> held_out;
    if (held_out_) held_out.emplace(*held_out_, network, settings_.patience);
    for (int epoch = 0;; ++epoch) {
      method->look(network, lesson_.rows, judge_.outputs);
      const Fit fit = judge_.fit();
      const bool stop = held_out && held_out->look(network);
      const bool done = arrived(fit) || stop;
      if (done && held_out) return {held_out->best(), fit, epoch, 0, false, true};
      if (done) return {std::move(network), fit, epoch, 0, true, false};
      if (epoch % method->report_every() == 0) watch_(epoch, fit.mean_squared_error);
      if (epoch < settings_.max_epochs && !stall.stalled(fit.mean_squared_error) &&
          method->move(network, lesson_.rows)) {
        continue;
      }
      if (held_out) network = held_out->best();
      return {std::move(network), fit, epoch, 0, false, false};
    }
  }

 private:
  bool arrived(const Fit& fit) const {
    return fit.wrong_rows == 0 && fit.mean_squared_error <= settings_.goal;
  }

  const Lesson& lesson_;
  const Lesson* held_out_;
  const TrainingSettings& settings_;
  const Watcher& watch_;
  Judge judge_;
};

Lesson chosen_rows(const Lesson& lesson, std::span<const std::size_t> chosen) {
  const std::size_t bits = static_cast<std::size_t>(lesson.coding.bits());
  Lesson part = lesson;
  part.rows.count = chosen.size();
  part.rows.inputs.clear(), part.rows.targets.clear(), part.bits.clear();
  for (const std::size_t r : chosen) {
    const float *input = lesson.rows.input(r), *target = lesson.rows.target(r);
    part.rows.inputs.insert(part.rows.inputs.end(), input, input + lesson.rows.input_width);
    part.rows.targets.insert(part.rows.targets.end(), target, target + lesson.rows.target_width);
    part.bits.insert(part.bits.end(), lesson.bits.begin() + static_cast<std::ptrdiff_t>(r * bits),
                     lesson.bits.begin() + static_cast<std::ptrdiff_t>((r + 1) * bits));
  }
  return part;
}

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

Parts hold_out(const Lesson& lesson, double share, Random& random) {
  std::vector<std::size_t> order(lesson.rows.count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(order.size()));
  const auto count = std::min(std::max(wanted, std::size_t{1}), order.size() - 1);
  // In the rows' own order, which online back-propagation goes by.
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
  std::sort(order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  const std::span<const std::size_t> all(order);
  return {chosen_rows(lesson, all.subspan(count)), chosen_rows(lesson, all.first(count))};
}

Trained train(const Lesson& lesson, const Shape& shape, const TrainingSettings& settings, Random& random,
              const Watcher& watch) {
  std::optional<Parts> parts;
  if (settings.validation > 0.0 && lesson.rows.count > 1) {
    parts = hold_out(lesson, settings.validation, random);
  }
  Run run(parts ? parts->learned : lesson, parts ? &parts->held_out : nullptr, settings, watch);
  Judge judge(lesson);
  Trained best{Network(shape), {INFINITY, lesson.rows.count + 1}, 0, 0, false, false};
  for (int restart = 0; restart <= settings.restarts; ++restart) {
    Trained trained = run.from(Network::random(shape, settings.weight_range, random));
    trained.restarts = restart;
    if (parts) {
      trained.fit = judge.fit(trained.network);
      trained.arrived = trained.fit.wrong_rows == 0 && trained.fit.mean_squared_error <= settings.goal;
    }
    const bool done = trained.arrived || trained.stopped_early;
    if (done || trained.fit.better_than(best.fit)) best = std::move(trained);
    if (done) break;
  }
  return best;
}

}  // namespace preshape::mlp
