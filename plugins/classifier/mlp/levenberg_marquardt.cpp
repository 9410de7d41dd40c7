#include "levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>

#include "preshape/base/error.h"

namespace preshape::mlp {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kMostUnknowns = 8192;  ///< of the system: half a gigabyte
constexpr double kLeastVariance = 1e-12;     ///< of an output: where float has it at 0 or 1

class LevenbergMarquardt final : public Method {
 public:
  LevenbergMarquardt(const Shape& shape, Loss loss) : shape_(shape), loss_(loss) {}

  void look(const Network& network, const Rows& rows, std::span<float> outputs) override {
    const std::size_t residuals = rows.targets.size(), weights = shape_.weights();
    if (std::min(residuals, weights) > kMostUnknowns) {
      throw InputError("classifier 'mlp': trainer 'levenberg_marquardt' would solve for " +
                       std::to_string(std::min(residuals, weights)) + " unknowns, of at most " +
                       std::to_string(kMostUnknowns) + "; take fewer hidden units or another trainer");
    }
    if (residuals <= weights) look_at_rows(network, rows, outputs);
    else look_at_weights(network, rows, outputs);
    value_ = loss_of(outputs, rows.targets, loss_);
  }

  bool move(Network& network, const Rows& rows) override {
    const std::vector<float> before(network.weights().begin(), network.weights().end());
    for (; damping_ < kMostDamping; damping_ *= kMoreDamping) {
      const VectorXd step = this->step();
      for (std::size_t i = 0; i < before.size(); ++i) {
        network.weights()[i] = static_cast<float>(before[i] - step[static_cast<Eigen::Index>(i)]);
      }
      if (loss_at(network, rows) < value_) {
        damping_ = std::max(damping_ * kLessDamping, kLeastDamping);
        return true;
      }
    }
    std::copy(before.begin(), before.end(), network.weights().begin());
    return false;
  }

  int patience() const override { return 50; }
  int report_every() const override { return 1; }

 private:
  static constexpr double kFirstDamping = 0.1, kLeastDamping = 1e-8, kMostDamping = 1e10;
  static constexpr double kMoreDamping = 10.0, kLessDamping = 0.2;

  /// Fewer residuals than weights: (J^T J + d I)^-1 J^T e = J^T (J J^T + d I)^-1 e.
  void look_at_rows(const Network& network, const Rows& rows, std::span<float> outputs) {
    Linearised all = linearise(network, rows, 0, rows.count, loss_, outputs);
    system_.setZero(all.residuals.size(), all.residuals.size());
    system_.selfadjointView<Eigen::Lower>().rankUpdate(all.jacobian);
    jacobian_ = std::move(all.jacobian);
    right_ = std::move(all.residuals);
  }

  void look_at_weights(const Network& network, const Rows& rows, std::span<float> outputs) {
    constexpr std::size_t kBlock = 32;
    const auto weights = static_cast<Eigen::Index>(shape_.weights());
    system_.setZero(weights, weights);
    right_.setZero(weights);
    jacobian_.resize(0, 0);
    for (std::size_t first = 0; first < rows.count; first += kBlock) {
      const std::size_t count = std::min(kBlock, rows.count - first);
      const Linearised block = linearise(network, rows, first, count, loss_,
                                         outputs.subspan(first * rows.target_width, count * rows.target_width));
      system_.selfadjointView<Eigen::Lower>().rankUpdate(block.jacobian.transpose());
      right_ += block.jacobian.transpose() * block.residuals;
    }
  }

  VectorXd step() const {
    MatrixXd damped = system_;
    damped.diagonal().array() += damping_;
    const VectorXd solution = damped.selfadjointView<Eigen::Lower>().llt().solve(right_);
    if (jacobian_.size() > 0) return jacobian_.transpose() * solution;
    return solution;
  }

  double loss_at(const Network& network, const Rows& rows) {
    std::vector<float> hidden(shape_.stride()), outputs(rows.targets.size());
    for (std::size_t r = 0; r < rows.count; ++r) {
      network.forward(rows.input(r), hidden.data(), outputs.data() + r * rows.target_width);
    }
    return loss_of(outputs, rows.targets, loss_);
  }

  Shape shape_;
  Loss loss_;
  double damping_ = kFirstDamping, value_ = 0.0;
  MatrixXd system_, jacobian_;
  VectorXd right_;
};

}  // namespace

Linearised linearise(const Network& network, const Rows& rows, std::size_t first, std::size_t count,
                     Loss loss, std::span<float> outputs) {
  const Shape& shape = network.shape();
  const std::size_t stride = shape.stride(), inputs = shape.inputs(), width = rows.target_width;
  const auto used = static_cast<std::size_t>(shape.hidden);
  Linearised result{MatrixXd::Zero(static_cast<Eigen::Index>(count * width),
                                   static_cast<Eigen::Index>(shape.weights())),
                    VectorXd(static_cast<Eigen::Index>(count * width))};
  std::vector<float> hidden(stride);
  for (std::size_t r = 0; r < count; ++r) {
    const float *input = rows.input(first + r), *target = rows.target(first + r);
    float* output = outputs.data() + r * width;
    network.forward(input, hidden.data(), output);
    for (std::size_t k = 0; k < width; ++k) {
      const auto row = static_cast<Eigen::Index>(r * width + k);
      const double o = output[k], variance = std::max(o * (1.0 - o), kLeastVariance);
      const double scale = loss == Loss::kSquared ? variance : std::sqrt(variance);
      result.residuals[row] = (o - target[k]) * (loss == Loss::kSquared ? 1.0 : 1.0 / scale);
      const float* out = network.weights().data() + (inputs + k) * stride;
      for (std::size_t j = 0; j <= used; ++j) {
        result.jacobian(row, static_cast<Eigen::Index>((inputs + k) * stride + j)) = scale * hidden[j];
      }
      for (std::size_t j = 0; j < used; ++j) {
        const double back = scale * out[j] * hidden[j] * (1.0 - hidden[j]);
        for (std::size_t i = 0; i < inputs; ++i) {
          result.jacobian(row, static_cast<Eigen::Index>(i * stride + j)) = back * input[i];
        }
      }
    }
  }
  return result;
}

std::unique_ptr<Method> levenberg_marquardt(const Shape& shape, Loss loss) {
  return std::make_unique<LevenbergMarquardt>(shape, loss);
}

}  // namespace preshape::mlp
