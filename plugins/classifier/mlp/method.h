#pragma once

#include <memory>

#include "network.h"

namespace preshape::mlp {

/// One way of making a network's loss small, with what it remembers from move to move. It belongs to one run
/// of one network on one set of rows: `look` and `move` in turn.
class Method {
 public:
  virtual ~Method() = default;

  /// What it needs for the move to come.
  /// @param outputs count x outputs of the rows, overwritten
  virtual void look(const Network& network, const Rows& rows, std::span<float> outputs) = 0;
  /// Moves the weights that it has just looked at. @returns false when it finds no way down from there
  virtual bool move(Network& network, const Rows& rows) = 0;

  /// Epochs without a hundredth of the error less after which a run has come to a halt.
  virtual int patience() const = 0;
  /// Epochs between two reports: the dearer an epoch, the fewer.
  virtual int report_every() const { return 64; }
};

/// The pull of each weight to zero at a move, which makes for smooth answers between few rows, and would keep
/// many rows from being known; so it fades. @param moves made before
inline float faded(float weight_decay, int moves) {
  constexpr float kHalf = 100.0f;  // moves after which it has halved
  const float age = static_cast<float>(moves) / kHalf;
  return weight_decay / (1.0f + age * age);
}

/// iRPROP- [IgelHuesken2003]: each weight has its own step, which grows while its gradient keeps its sign and
/// shrinks when it turns; the gradient's size does not count.
std::unique_ptr<Method> rprop(const Shape& shape, Loss loss, float weight_decay);

/// Online back-propagation with constant rates, as the thesis's appendix A.
std::unique_ptr<Method> backprop(const Shape& shape, Loss loss, const LearningRates& rates);

/// Limited-memory BFGS [LiuNocedal1989] on all rows. The step along each direction is found by bisection
/// until it satisfies Wolfe's weak conditions.
std::unique_ptr<Method> lbfgs(const Shape& shape, Loss loss, float weight_decay);

/// Levenberg-Marquardt [Marquardt1963] on all rows; under cross entropy with the Gauss-Newton matrix of that
/// loss. A move solves a system as large as the fewer of weights and of rows times outputs.
std::unique_ptr<Method> levenberg_marquardt(const Shape& shape, Loss loss);

}  // namespace preshape::mlp
