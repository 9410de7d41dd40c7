#include <algorithm>
#include <cmath>
#include <deque>

#include <Eigen/Core>

#include "method.h"

namespace preshape::mlp {

namespace {

using Eigen::VectorXd;

VectorXd to_double(std::span<const float> values) {
  return Eigen::Map<const Eigen::VectorXf>(values.data(), static_cast<Eigen::Index>(values.size()))
      .cast<double>();
}

class Lbfgs final : public Method {
 public:
  Lbfgs(const Shape& shape, Loss loss, float weight_decay)
      : loss_(loss), weight_decay_(weight_decay), gradient_(shape.weights()) {}

  void look(const Network& network, const Rows& rows, std::span<float> outputs) override {
    if (outputs_.empty()) here_ = evaluate(network, rows);  // a move leaves behind where it has arrived
    std::copy(outputs_.begin(), outputs_.end(), outputs.begin());
  }

  bool move(Network& network, const Rows& rows) override {
    pull_ = faded(weight_decay_, moves_++);
    VectorXd direction = downhill();
    if (!(direction.dot(slope(here_)) < 0.0)) pairs_.clear(), direction = downhill();
    if (search(network, rows, direction)) return true;
    if (pairs_.empty()) return false;
    pairs_.clear();
    return search(network, rows, downhill());
  }

  int patience() const override { return 100; }
  int report_every() const override { return 16; }

 private:
  static constexpr std::size_t kPairs = 10;
  static constexpr double kArmijo = 1e-4, kCurvature = 0.9;
  static constexpr int kTrials = 30;

  struct Pair {
    VectorXd step, turn;  ///< of the weights, of the gradient
    double inverse = 0.0;
  };
  struct Place {
    VectorXd weights, gradient;
    double loss = 0.0;  ///< without the pull to zero
  };

  /// What is made small has the pull to zero, which fades from move to move.
  double value(const Place& place) const { return place.loss + 0.5 * pull_ * place.weights.squaredNorm(); }
  VectorXd slope(const Place& place) const { return place.gradient + pull_ * place.weights; }

  Place evaluate(const Network& network, const Rows& rows) {
    outputs_.resize(rows.targets.size());
    std::fill(gradient_.begin(), gradient_.end(), 0.0f);
    network.add_gradient(rows, loss_, gradient_, outputs_);
    return {to_double(network.weights()), to_double(gradient_), loss_of(outputs_, rows.targets, loss_)};
  }

  /// Minus the estimated inverse Hessian times the gradient, by the two loops over the remembered moves.
  VectorXd downhill() const {
    VectorXd q = -slope(here_);
    // Without memory the first trial shall not be longer than one.
    if (pairs_.empty()) return q / std::max(1.0, q.norm());
    std::vector<double> shares(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
      shares[i] = pairs_[i].inverse * pairs_[i].step.dot(q);
      q -= shares[i] * pairs_[i].turn;
    }
    const Pair& last = pairs_.back();
    q *= 1.0 / (last.inverse * last.turn.squaredNorm());
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      q += (shares[i] - pairs_[i].inverse * pairs_[i].turn.dot(q)) * pairs_[i].step;
    }
    return q;
  }

  /// Weak Wolfe conditions by bisection. When no step is found the network is as before.
  bool search(Network& network, const Rows& rows, const VectorXd& direction) {
    const double descent = slope(here_).dot(direction);
    double low = 0.0, high = INFINITY, length = 1.0;
    for (int trial = 0; trial < kTrials; ++trial) {
      set(network, here_.weights + length * direction);
      Place there = evaluate(network, rows);
      const bool lower = value(there) <= value(here_) + kArmijo * length * descent;
      if (lower && slope(there).dot(direction) >= kCurvature * descent) return arrive(std::move(there));
      (lower ? low : high) = length;
      length = std::isinf(high) ? 2.0 * length : 0.5 * (low + high);
    }
    set(network, here_.weights);
    here_ = evaluate(network, rows);
    return false;
  }

  bool arrive(Place there) {
    Pair pair{there.weights - here_.weights, slope(there) - slope(here_), 0.0};
    const double product = pair.step.dot(pair.turn);
    if (product > 0.0) {
      pair.inverse = 1.0 / product;
      pairs_.push_back(std::move(pair));
      if (pairs_.size() > kPairs) pairs_.pop_front();
    }
    here_ = std::move(there);
    return true;
  }

  static void set(Network& network, const VectorXd& weights) {
    const auto place = network.weights();
    for (std::size_t i = 0; i < place.size(); ++i)
      place[i] = static_cast<float>(weights[static_cast<Eigen::Index>(i)]);
  }

  Loss loss_;
  double weight_decay_, pull_ = 0.0;
  int moves_ = 0;
  std::vector<float> gradient_, outputs_;
  Place here_;
  std::deque<Pair> pairs_;
};

}  // namespace

std::unique_ptr<Method> lbfgs(const Shape& shape, Loss loss, float weight_decay) {
  return std::make_unique<Lbfgs>(shape, loss, weight_decay);
}

}  // namespace preshape::mlp
