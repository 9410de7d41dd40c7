#include "state.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"

namespace preshape::fann_plugin {

namespace {

constexpr std::string_view kMagic = "prshFANN";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kDigest = 64, kHead = 5;
constexpr std::uint32_t kMostUnits = 1 << 20;  // of any layer: keeps products within 64 bits

void put(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xffu);
}

std::uint32_t take(std::string_view& bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  bytes.remove_prefix(4);
  return number;
}

[[noreturn]] void refuse(const char* why) {
  throw InputError(std::string("these bytes are no state of classifier 'fann' (") + why +
                   "); train it anew, or give the bytes that save gave");
}

std::string_view checked_body(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) refuse("another beginning");
  if (bytes.size() < kMagic.size() + 4 * kHead + kDigest) refuse("cut off");
  const std::string_view body = bytes.substr(0, bytes.size() - kDigest);
  if (sha256_hex(body) != bytes.substr(body.size())) refuse("the check sum does not fit: cut off or changed");
  return body.substr(kMagic.size());
}

}  // namespace

std::string state_bytes(const State& state) {
  std::string bytes(kMagic);
  const Shape& shape = state.layers.shape;
  put(bytes, kVersion);
  put(bytes, state.asinh);
  for (const std::size_t size : {shape.features, shape.hidden, shape.outputs}) put(bytes, static_cast<std::uint32_t>(size));
  for (const float weight : state.layers.weights) put(bytes, std::bit_cast<std::uint32_t>(weight));
  return bytes + sha256_hex(bytes);
}

State state_from(std::string_view bytes) {
  std::string_view body = checked_body(bytes);
  if (take(body) != kVersion) refuse("another version of the format");
  const std::uint32_t scaling = take(body);
  if (scaling > 1) refuse("an unknown scaling");
  State state;
  state.asinh = scaling == 1;
  Shape& shape = state.layers.shape;
  for (std::size_t* size : {&shape.features, &shape.hidden, &shape.outputs}) {
    *size = take(body);
    if (*size < 1 || *size > kMostUnits) refuse("a size out of bounds");
  }
  if (body.size() != 4 * shape.weights()) refuse("another number of weights than its sizes say");
  while (!body.empty()) {
    const float weight = std::bit_cast<float>(take(body));
    if (!std::isfinite(weight)) refuse("a weight that is not finite");
    state.layers.weights.push_back(weight);
  }
  return state;
}

}  // namespace preshape::fann_plugin
