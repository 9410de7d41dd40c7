#include "state.h"

#include <bit>
#include <cstdint>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"

namespace preshape::mlp {

namespace {

constexpr std::string_view kMagic = "prshMLP\n";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kDigest = 64;
constexpr std::uint32_t kMostUnits = 1 << 20;  // of anything: keeps products within 64 bits

void put(std::string& bytes, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xffu);
}
void put(std::string& bytes, int number) {
  put(bytes, static_cast<std::uint32_t>(number));
}

[[noreturn]] void refuse(const char* what) {
  throw InputError(std::string("these bytes are no state of classifier 'mlp' (") + what +
                   "); train it anew, or give the bytes that save gave");
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t number() {
    if (bytes_.size() < 4) refuse("cut off");
    std::uint32_t number = 0;
    for (int i = 3; i >= 0; --i)
      number = number << 8 | static_cast<unsigned char>(bytes_[static_cast<std::size_t>(i)]);
    bytes_.remove_prefix(4);
    return number;
  }
  int count(std::uint32_t least) {
    const std::uint32_t value = number();
    if (value < least || value > kMostUnits) refuse("a size out of bounds");
    return static_cast<int>(value);
  }
  std::size_t left() const { return bytes_.size() / 4; }

 private:
  std::string_view bytes_;
};

Coding read_coding(Reader& reader) {
  const int bits = reader.count(1), sharpness = reader.count(1), field_count = reader.count(0);
  std::vector<Coding::Field> fields;
  int first_bit = 0;
  for (int f = 0; f < field_count; ++f) {
    Coding::Field field{first_bit, reader.count(1), {}};
    const int patterns = reader.count(1);
    if (static_cast<std::size_t>(patterns) > reader.left()) refuse("cut off");
    for (int p = 0; p < patterns; ++p) field.patterns.push_back(reader.number());
    first_bit += field.bits;
    fields.push_back(std::move(field));
  }
  if (field_count > 0 && first_bit != bits) refuse("fields that do not add up to the code");
  return Coding::restored(bits, sharpness, std::move(fields));
}

std::string_view checked_body(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) refuse("another beginning");
  if (bytes.size() < kMagic.size() + kDigest) refuse("cut off");
  const std::string_view body = bytes.substr(0, bytes.size() - kDigest);
  if (sha256_hex(body) != bytes.substr(body.size())) refuse("the check sum does not fit: cut off or changed");
  return body.substr(kMagic.size());
}

}  // namespace

std::string state_bytes(const State& state) {
  std::string bytes(kMagic);
  put(bytes, kVersion);
  put(bytes, state.features);
  put(bytes, state.committee.front().shape().hidden);
  put(bytes, static_cast<int>(state.scaling));
  put(bytes, state.coding.bits());
  put(bytes, state.coding.sharpness());
  put(bytes, static_cast<int>(state.coding.fields().size()));
  for (const auto& field : state.coding.fields()) {
    put(bytes, field.bits);
    put(bytes, static_cast<int>(field.patterns.size()));
    for (const std::uint32_t pattern : field.patterns) put(bytes, pattern);
  }
  put(bytes, static_cast<int>(state.committee.size()));
  for (const Network& network : state.committee) {
    for (const float weight : network.weights()) put(bytes, std::bit_cast<std::uint32_t>(weight));
  }
  return bytes + sha256_hex(bytes);
}

State state_from(std::string_view bytes) {
  Reader reader(checked_body(bytes));
  if (reader.number() != kVersion) refuse("another version of the format");
  State state;
  state.features = reader.count(1);
  const int hidden = reader.count(1);
  state.scaling = static_cast<Scaling>(reader.count(0));
  if (state.scaling > Scaling::kAsinh) refuse("an unknown scaling");
  state.coding = read_coding(reader);
  const Shape shape{state.features, hidden, state.coding.units()};
  const auto members = static_cast<std::size_t>(reader.count(1));
  if (reader.left() != members * shape.weights()) refuse("another number of weights than its sizes say");
  for (std::size_t m = 0; m < members; ++m) {
    Network& network = state.committee.emplace_back(shape);
    for (float& weight : network.weights()) weight = std::bit_cast<float>(reader.number());
  }
  return state;
}

}  // namespace preshape::mlp
