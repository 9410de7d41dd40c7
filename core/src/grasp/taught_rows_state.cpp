#include <bit>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "preshape/grasp/taught_rows.h"

namespace preshape {

namespace {

static_assert(std::endian::native == std::endian::little, "a saved state is written in this byte order");

constexpr std::size_t kDigest = 64;

struct Sizes {
  std::uint64_t rows = 0, features = 0, bits = 0;

  /// Whether they say so many numbers. No product is trusted before each factor is known to be small.
  bool fit(std::uint64_t numbers) const {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 31;
    return numbers < kMost && rows >= 1 && features >= 1 && bits >= 1 && rows <= numbers && features <= numbers &&
           bits <= numbers && rows * (features + bits) == numbers;
  }
};

std::string head_of(std::string_view classifier) { return fmt::format("preshape {} 1\n", classifier); }

[[noreturn]] void refuse(std::string_view classifier, const char* why) {
  throw InputError(fmt::format("classifier '{}': this is no state of it ({}); train it anew", classifier, why));
}

void append(std::string& bytes, const RowMatrix& matrix) {
  bytes.append(reinterpret_cast<const char*>(matrix.data()), static_cast<std::size_t>(matrix.size()) * sizeof(double));
}

RowMatrix taken(std::string_view& bytes, std::uint64_t rows, std::uint64_t columns) {
  RowMatrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  const std::size_t size = rows * columns * sizeof(double);
  std::memcpy(matrix.data(), bytes.data(), size);
  bytes.remove_prefix(size);
  return matrix;
}

std::string_view checked_body(std::string_view classifier, std::string_view bytes) {
  const std::string head = head_of(classifier);
  if (!bytes.starts_with(head)) refuse(classifier, "another beginning, or another version");
  bytes.remove_prefix(head.size());
  if (bytes.size() < kDigest + sizeof(Sizes)) refuse(classifier, "cut off");
  const std::string_view body = bytes.substr(kDigest);
  if (sha256_hex(body) != bytes.substr(0, kDigest)) refuse(classifier, "the check sum does not fit: cut off or changed");
  return body;
}

}  // namespace

std::string TaughtRows::bytes(std::string_view classifier) const {
  const Sizes sizes{static_cast<std::uint64_t>(inputs_.rows()), static_cast<std::uint64_t>(inputs_.cols()),
                    static_cast<std::uint64_t>(targets_.cols())};
  std::string body(sizeof(Sizes), '\0');
  std::memcpy(body.data(), &sizes, sizeof(Sizes));
  append(body, inputs_);
  append(body, targets_);
  return head_of(classifier) + sha256_hex(body) + body;
}

TaughtRows TaughtRows::from_bytes(std::string_view classifier, std::string_view bytes) {
  std::string_view body = checked_body(classifier, bytes);
  Sizes sizes;
  std::memcpy(&sizes, body.data(), sizeof(Sizes));
  body.remove_prefix(sizeof(Sizes));
  if (body.size() % sizeof(double) != 0 || !sizes.fit(body.size() / sizeof(double))) {
    refuse(classifier, "sizes that do not fit its length");
  }
  const RowMatrix inputs = taken(body, sizes.rows, sizes.features), targets = taken(body, sizes.rows, sizes.bits);
  TaughtRows rows(classifier, inputs, targets);
  if (rows.inputs_ != inputs || rows.targets_ != targets) refuse(classifier, "rows that are not in order");
  return rows;
}

}  // namespace preshape
