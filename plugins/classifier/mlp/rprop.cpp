#include <algorithm>

#include "method.h"

namespace preshape::mlp {

namespace {

class Rprop final : public Method {
 public:
  Rprop(const Shape& shape, Loss loss, float weight_decay)
      : loss_(loss),
        weight_decay_(weight_decay),
        gradient_(shape.weights()),
        before_(gradient_.size()),
        steps_(gradient_.size(), kFirstStep) {}

  void look(const Network& network, const Rows& rows, std::span<float> outputs) override {
    std::fill(gradient_.begin(), gradient_.end(), 0.0f);
    network.add_gradient(rows, loss_, gradient_, outputs);
  }

  bool move(Network& network, const Rows&) override {
    step(network.weights().data(), gradient_.data(), before_.data(), steps_.data(), gradient_.size());
    return true;
  }

  int patience() const override { return 300; }

 private:
  static constexpr float kFirstStep = 0.05f, kGrow = 1.2f, kShrink = 0.5f, kLeast = 1e-6f, kMost = 50.0f;

  void step(float* __restrict weights, const float* __restrict gradient, float* __restrict before,
            float* __restrict steps, std::size_t count) {
    const float decay = faded(weight_decay_, moves_++);
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

  Loss loss_;
  float weight_decay_;
  std::vector<float> gradient_, before_, steps_;
  int moves_ = 0;
};

}  // namespace

std::unique_ptr<Method> rprop(const Shape& shape, Loss loss, float weight_decay) {
  return std::make_unique<Rprop>(shape, loss, weight_decay);
}

}  // namespace preshape::mlp
