#include "coding.h"

#include "support/near.h"

using namespace preshape::mlp;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

/// Codes of two fields, two bits and one: 01|1, 10|0, 11|1.
const std::vector<float> kTargets = {0, 1, 1, 1, 0, 0, 1, 1, 1};
constexpr int kFieldBits[] = {2, 1};

Coding example(int sharpness) {
  return Coding::by_fields(kFieldBits, kTargets, 3, sharpness);
}

}  // namespace

TEST_CASE("MLP coding: each learned pattern of a field has a unit, and no other") {
  const Coding coding = example(1);
  CHECK(coding.units() == 5);
  CHECK(coding.fields()[0].patterns == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(coding.fields()[1].patterns == std::vector<std::uint32_t>{0, 1});
  float units[5];
  coding.encode(kTargets.data() + 3, units);
  CHECK(std::vector<float>(units, units + 5) == std::vector<float>{0, 1, 0, 1, 0});
}

TEST_CASE("MLP coding: a row encoded and decoded is the row again") {
  const Coding coding = example(4);
  for (std::size_t row = 0; row < 9; row += 3) {
    float units[5], bits[3];
    coding.encode(kTargets.data() + row, units);
    coding.decode(units, bits);
    for (std::size_t b = 0; b < 3; ++b) CHECK(bits[b] == kTargets[row + b]);
  }
}

TEST_CASE("MLP coding: bits are the shares of their field's patterns, which sharpness drives apart") {
  const float units[] = {0.6f, 0.3f, 0.0f, 0.5f, 0.5f};  // 01 twice as strong as 10, 11 not at all
  float bits[3];
  example(1).decode(units, bits);
  CHECK_NEAR(bits[0], 1.0 / 3.0, 1e-6);  // 10
  CHECK_NEAR(bits[1], 2.0 / 3.0, 1e-6);  // 01
  CHECK_NEAR(bits[2], 0.5, 1e-6);
  example(2).decode(units, bits);
  CHECK_NEAR(bits[0], 1.0 / 5.0, 1e-6);  // 0.3^2 / (0.6^2 + 0.3^2)
}

TEST_CASE("MLP coding: shares that add up to one do not round to more") {
  const std::vector<float> all_set = {1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};  // the first bit is in every pattern
  const int field_bits[] = {3};
  const Coding coding = Coding::by_fields(field_bits, all_set, 3, 4);
  for (int i = 1; i < 400; ++i) {
    const float units[] = {0.0025f * static_cast<float>(i), 0.31f, 0.77f, 0.123f};
    float bits[3];
    coding.decode(units, bits);
    CHECK(bits[0] <= 1.0f);
  }
}

TEST_CASE("MLP coding: outputs near zero still share out their field") {
  const float units[] = {2e-38f, 1e-37f, 2e-38f, 1e-30f, 1e-32f};
  float bits[3];
  example(16).decode(units, bits);
  CHECK_NEAR(bits[0], 1.0, 1e-6);
  CHECK_NEAR(bits[1], 0.0, 1e-6);
  CHECK_NEAR(bits[2], 0.0, 1e-6);
}

TEST_CASE("MLP coding: plain bits are the units themselves") {
  const Coding coding = Coding::plain(3);
  const float units[] = {0.1f, 0.7f, 1.0f};
  float bits[3];
  coding.decode(units, bits);
  CHECK(coding.units() == 3);
  CHECK(std::equal(units, units + 3, bits));
}

TEST_SUITE_END();
