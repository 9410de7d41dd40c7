#include "state.h"

#include <bit>
#include <cstdint>
#include <cstring>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"

namespace preshape::nadaraya_watson {

namespace {

static_assert(std::endian::native == std::endian::little, "a saved state is written in this byte order");

constexpr std::string_view kHead = "preshape nadaraya_watson 1\n";
constexpr std::size_t kDigest = 64;

struct Sizes {
  std::uint64_t rows = 0, features = 0, bits = 0;

  /// Whether they say so many numbers. No product is trusted before each factor is known to be small.
  bool fit(std::uint64_t numbers) const {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 31;
    return numbers < kMost && rows >= 1 && features >= 1 && bits >= 1 && rows <= numbers &&
           features <= numbers && bits <= numbers && rows * (features + bits) == numbers;
  }
};

[[noreturn]] void refuse(const char* why) {
  throw InputError(std::string("classifier 'nadaraya_watson': this is no state of it (") + why + "); train it anew");
}

void append(std::string& bytes, const RowMatrix& matrix) {
  bytes.append(reinterpret_cast<const char*>(matrix.data()),
               static_cast<std::size_t>(matrix.size()) * sizeof(double));
}

RowMatrix taken(std::string_view& bytes, std::uint64_t rows, std::uint64_t columns) {
  RowMatrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  const std::size_t size = rows * columns * sizeof(double);
  std::memcpy(matrix.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  return matrix;
}

std::string_view checked_body(std::string_view bytes) {
  if (!bytes.starts_with(kHead)) refuse("another beginning, or another version");
  bytes.remove_prefix(kHead.size());
  if (bytes.size() < kDigest + sizeof(Sizes)) refuse("cut off");
  const std::string_view body = bytes.substr(kDigest);
  if (sha256_hex(body) != bytes.substr(0, kDigest)) refuse("the check sum does not fit: cut off or changed");
  return body;
}

}  // namespace

std::string state_bytes(const Lesson& lesson) {
  const Sizes sizes{static_cast<std::uint64_t>(lesson.inputs().rows()),
                    static_cast<std::uint64_t>(lesson.inputs().cols()),
                    static_cast<std::uint64_t>(lesson.targets().cols())};
  std::string body(sizeof(Sizes), '\0');
  std::memcpy(body.data(), &sizes, sizeof(Sizes));
  append(body, lesson.inputs());
  append(body, lesson.targets());
  return std::string(kHead) + sha256_hex(body) + body;
}

Lesson lesson_from(std::string_view bytes) {
  std::string_view body = checked_body(bytes);
  Sizes sizes;
  std::memcpy(&sizes, body.data(), sizeof(Sizes));
  body.remove_prefix(sizeof(Sizes));
  if (body.size() % sizeof(double) != 0 || !sizes.fit(body.size() / sizeof(double)))
    refuse("sizes that do not fit its length");
  const RowMatrix inputs = taken(body, sizes.rows, sizes.features),
                  targets = taken(body, sizes.rows, sizes.bits);
  Lesson lesson(inputs, targets);
  if (lesson.inputs() != inputs || lesson.targets() != targets) refuse("rows that are not in order");
  return lesson;
}

}  // namespace preshape::nadaraya_watson
