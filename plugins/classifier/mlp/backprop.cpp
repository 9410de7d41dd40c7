#include "method.h"

namespace preshape::mlp {

namespace {

class Backprop final : public Method {
 public:
  Backprop(const Shape& shape, Loss loss, const LearningRates& rates)
      : loss_(loss), rates_(rates), hidden_(shape.stride()), last_(shape.weights()) {}

  void look(const Network& network, const Rows& rows, std::span<float> outputs) override {
    for (std::size_t r = 0; r < rows.count; ++r) {
      network.forward(rows.input(r), hidden_.data(), outputs.data() + r * rows.target_width);
    }
  }

  bool move(Network& network, const Rows& rows) override {
    network.back_propagate(rows, loss_, rates_, last_);
    return true;
  }

  /// It creeps over plateaus thousands of epochs long, so that only the cap on epochs ends it.
  int patience() const override { return 1 << 30; }

 private:
  Loss loss_;
  LearningRates rates_;
  std::vector<float> hidden_, last_;
};

}  // namespace

std::unique_ptr<Method> backprop(const Shape& shape, Loss loss, const LearningRates& rates) {
  return std::make_unique<Backprop>(shape, loss, rates);
}

}  // namespace preshape::mlp
