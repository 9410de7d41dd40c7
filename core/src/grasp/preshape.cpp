#include "preshape/grasp/preshape.h"

#include <bit>

#include "preshape/base/assert.h"

namespace preshape {

PreshapeTaxonomy taxonomy(const Preshape& preshape) {
  static constexpr const char* kTypes[] = {"none", "thumb-index", "thumb-two-finger", "thumb-three-finger"};
  const bool known = preshape.virtual_fingers >= 1 && preshape.virtual_fingers <= kMostVirtualFingers;
  return {"pad opposition", "precision", kTypes[known ? preshape.virtual_fingers : 0]};
}

PreshapeCode::PreshapeCode(int planes, int symbols)
    : planes_(planes), symbols_(symbols),
      plane_bits_(std::bit_width(static_cast<unsigned>(planes))),
      symbol_bits_(std::bit_width(static_cast<unsigned>(symbols))) {}

namespace {

void write_bits(int value, int bits, Eigen::VectorXd& code, int& at) {
  for (int k = bits - 1; k >= 0; --k) code[at++] = (value >> k) & 1;
}

struct Field {
  int value = 0;
  double confidence = 0.0;
};

/// The likeliest value of 1..count. The fields of a code are independent, so each is decoded by itself.
Field likeliest(const Eigen::Ref<const Eigen::VectorXd>& bits, int at, int width, int count) {
  Field best;
  double total = 0.0;
  for (int value = 1; value <= count; ++value) {
    double likelihood = 1.0;
    for (int k = 0; k < width; ++k) {
      const double p = bits[at + k];
      likelihood *= ((value >> (width - 1 - k)) & 1) ? p : 1.0 - p;
    }
    total += likelihood;
    if (likelihood > best.confidence || best.value == 0) best = {value, likelihood};
  }
  best.confidence = total > 0.0 ? best.confidence / total : 0.0;
  return best;
}

}  // namespace

Eigen::VectorXd PreshapeCode::encode(const Preshape& preshape) const {
  PRESHAPE_DEMAND(preshape.plane >= 1 && preshape.plane <= planes_);
  PRESHAPE_DEMAND(preshape.symbol >= 1 && preshape.symbol <= symbols_);
  PRESHAPE_DEMAND(preshape.virtual_fingers >= 1 && preshape.virtual_fingers <= kMostVirtualFingers);
  Eigen::VectorXd code(bits());
  int at = 0;
  write_bits(preshape.plane, plane_bits_, code, at);
  write_bits(preshape.symbol, symbol_bits_, code, at);
  write_bits(preshape.virtual_fingers, kFingerBits, code, at);
  return code;
}

PreshapeCode::Decoding PreshapeCode::decode(const Eigen::Ref<const Eigen::VectorXd>& bits) const {
  PRESHAPE_DEMAND(bits.size() == this->bits());
  const Field plane = likeliest(bits, 0, plane_bits_, planes_);
  const Field symbol = likeliest(bits, plane_bits_, symbol_bits_, symbols_);
  const Field fingers = likeliest(bits, plane_bits_ + symbol_bits_, kFingerBits, kMostVirtualFingers);
  return {{plane.value, symbol.value, fingers.value}, plane.confidence * symbol.confidence * fingers.confidence};
}

}  // namespace preshape
