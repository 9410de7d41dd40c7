#include "state.h"

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::mlp;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

State example() {
  Random random(3);
  const std::vector<float> targets = {0, 1, 1, 1, 0, 0};
  const std::vector<int> field_bits = {2, 1};
  State state{4, Scaling::kAsinh, Coding::by_fields(field_bits, targets, 3, 4), {}};
  const Shape shape{4, 6, state.coding.units()};
  for (int m = 0; m < 2; ++m) state.committee.push_back(Network::random(shape, 1.0f, random));
  return state;
}

/// Bytes whose body was changed, with the check sum that fits them: as no accident would do.
std::string resealed(std::string bytes, std::size_t place, std::uint32_t number) {
  bytes.resize(bytes.size() - 64);
  for (std::size_t i = 0; i < 4; ++i) bytes[place + i] = static_cast<char>(number >> (8 * i) & 0xffu);
  return bytes + sha256_hex(bytes);
}

}  // namespace

TEST_CASE("MLP state: everything comes back, bit for bit") {
  const State state = example();
  const std::string bytes = state_bytes(state);
  const State read = state_from(bytes);
  CHECK(state_bytes(read) == bytes);
  CHECK(read.features == 4);
  CHECK(read.coding.fields() == state.coding.fields());
  REQUIRE(read.committee.size() == 2);
  CHECK(std::equal(read.committee[1].weights().begin(), read.committee[1].weights().end(),
                   state.committee[1].weights().begin()));
}

TEST_CASE("MLP state: every cut and every flipped byte is refused") {
  const std::string bytes = state_bytes(example());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK_THROWS_AS(state_from(bytes.substr(0, size)), InputError);
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
    CHECK_THROWS_AS(state_from(flipped), InputError);
  }
  CHECK_THROWS_SAYING(state_from(bytes + "x"), InputError, "the check sum does not fit");
  CHECK_THROWS_SAYING(state_from("hello"), InputError, "no state of classifier 'mlp' (another beginning)");
}

TEST_CASE("MLP state: sizes that lie are refused before anything of that size is allocated") {
  const std::string bytes = state_bytes(example());
  // After magic: version, features, hidden, scaling, bits, sharpness, number of fields, bits and patterns of
  // one.
  for (const std::size_t place : {8u, 12u, 16u, 20u, 24u, 28u, 32u, 36u, 40u}) {
    for (const std::uint32_t lie : {0xffffffffu, 0x7fffffffu, 1u << 20, 77u}) {
      if (place == 28 && lie != 0xffffffffu && lie != 0x7fffffffu)
        continue;  // any small sharpness is possible
      CHECK_THROWS_AS(state_from(resealed(bytes, place, lie)), InputError);
    }
  }
  CHECK_THROWS_SAYING(state_from(resealed(bytes, 8, 2)), InputError, "another version of the format");
  CHECK_THROWS_SAYING(state_from(resealed(bytes, 16, 77)), InputError, "another number of weights");
}

TEST_SUITE_END();
