#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace preshape::mlp {

/// How output units stand for the bits of a code.
///
/// Plain: one unit a bit, as the thesis has it. Halfway between two learned rows whose codes differ in
/// several bits, the bits turn over at different places, and the code there is that of some third plane. By
/// fields: the code is cut into fields (plane, symbol, finger count), and each pattern of a field that was
/// learned has a unit. Between two rows it is then one or the other. A bit's probability is the sum over its
/// field's patterns, weighted by the units' outputs to the power `sharpness`.
class Coding {
 public:
  struct Field {
    int first_bit = 0, bits = 0;
    std::vector<std::uint32_t> patterns;  ///< ascending, the field's first bit the most significant
    bool operator==(const Field&) const = default;
  };

  static Coding plain(int bits);
  /// @param field_bits the fields' numbers of bits, which add up to `bits`
  /// @param targets rows of `bits` zeros and ones, from which the patterns are taken
  static Coding by_fields(std::span<const int> field_bits, std::span<const float> targets, int bits,
                          int sharpness);
  /// As it was saved; no fields: plain.
  static Coding restored(int bits, int sharpness, std::vector<Field> fields);

  int bits() const { return bits_; }
  int units() const { return units_; }
  int sharpness() const { return sharpness_; }
  const std::vector<Field>& fields() const { return fields_; }

  /// @param bits a row's zeros and ones; @param units what the units shall give, overwritten
  void encode(const float* bits, float* units) const;
  /// @param units the units' outputs; @param bits probabilities, overwritten
  void decode(const float* units, float* bits) const;

 private:
  int bits_ = 0, units_ = 0, sharpness_ = 1;
  std::vector<Field> fields_;
  std::vector<float> unit_bits_;  ///< units x bits: what each unit's pattern says of the code
};

/// The pattern of a field in a row of zeros and ones.
std::uint32_t pattern_of(const float* bits, int first_bit, int count);

}  // namespace preshape::mlp
