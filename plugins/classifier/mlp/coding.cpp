#include "coding.h"

#include <algorithm>
#include <set>

namespace preshape::mlp {

namespace {

float power(float x, int exponent) {
  float result = x;
  for (int i = 1; i < exponent; ++i) result *= x;
  return result;
}

/// One unit's row of the table of bits.
void append_bits(std::vector<float>& table, const Coding::Field& field, std::uint32_t pattern, int bits) {
  const std::size_t row = table.size();
  table.resize(row + static_cast<std::size_t>(bits), 0.0f);
  for (int b = 0; b < field.bits; ++b) {
    const bool is_set = pattern >> (field.bits - 1 - b) & 1u;
    table[row + static_cast<std::size_t>(field.first_bit + b)] = is_set ? 1.0f : 0.0f;
  }
}

}  // namespace

std::uint32_t pattern_of(const float* bits, int first_bit, int count) {
  std::uint32_t pattern = 0;
  for (int b = 0; b < count; ++b) pattern = pattern << 1 | (bits[first_bit + b] > 0.5f ? 1u : 0u);
  return pattern;
}

Coding Coding::plain(int bits) {
  return restored(bits, 1, {});
}

Coding Coding::by_fields(std::span<const int> field_bits, std::span<const float> targets, int bits,
                         int sharpness) {
  std::vector<Field> fields;
  int first_bit = 0;
  for (const int count : field_bits) {
    std::set<std::uint32_t> patterns;
    for (std::size_t row = 0; row < targets.size(); row += static_cast<std::size_t>(bits)) {
      patterns.insert(pattern_of(targets.data() + row, first_bit, count));
    }
    fields.push_back({first_bit, count, {patterns.begin(), patterns.end()}});
    first_bit += count;
  }
  return restored(bits, sharpness, std::move(fields));
}

Coding Coding::restored(int bits, int sharpness, std::vector<Field> fields) {
  Coding coding;
  coding.bits_ = bits;
  coding.sharpness_ = sharpness;
  coding.fields_ = std::move(fields);
  for (const Field& field : coding.fields_) {
    coding.units_ += static_cast<int>(field.patterns.size());
    for (const std::uint32_t pattern : field.patterns) append_bits(coding.unit_bits_, field, pattern, bits);
  }
  if (coding.fields_.empty()) coding.units_ = bits;
  return coding;
}

void Coding::encode(const float* bits, float* units) const {
  if (fields_.empty()) {
    std::copy(bits, bits + bits_, units);
    return;
  }
  for (const Field& field : fields_) {
    const std::uint32_t pattern = pattern_of(bits, field.first_bit, field.bits);
    for (const std::uint32_t known : field.patterns) *units++ = known == pattern ? 1.0f : 0.0f;
  }
}

void Coding::decode(const float* units, float* bits) const {
  if (fields_.empty()) {
    std::copy(units, units + bits_, bits);
    return;
  }
  std::fill(bits, bits + bits_, 0.0f);
  const auto width = static_cast<std::size_t>(bits_);
  const float* bits_of_unit = unit_bits_.data();
  for (const Field& field : fields_) {
    const std::size_t count = field.patterns.size();
    // Over the largest first, so that small outputs do not vanish in the power.
    const float scale = 1.0f / *std::max_element(units, units + count);
    float sum = 0.0f;
    for (std::size_t p = 0; p < count; ++p) sum += power(units[p] * scale, sharpness_);
    for (std::size_t p = 0; p < count; ++p, bits_of_unit += width) {
      const float share = power(units[p] * scale, sharpness_) / sum;
      for (std::size_t b = 0; b < width; ++b) bits[b] += share * bits_of_unit[b];
    }
    units += count;
  }
  // Shares that add up to one may round to a little more.
  for (std::size_t b = 0; b < width; ++b) bits[b] = std::min(bits[b], 1.0f);
}

}  // namespace preshape::mlp
