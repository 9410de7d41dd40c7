#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

/// SHA-256 [FIPS180-4] of bytes fed piece by piece: names the content of objects, plugins and reports.
class PRESHAPE_API Sha256 {
 public:
  Sha256();

  void update(std::span<const std::byte> bytes);
  void update(std::string_view text) { update(std::as_bytes(std::span(text))); }
  /// Eight bytes, lowest first, whatever the machine's own order.
  void update_little_endian(std::uint64_t number);

  /// The digest as 64 lower-case hexadecimal digits. Nothing may be fed afterwards.
  std::string hex();

 private:
  void absorb(const std::byte* block);

  std::array<std::uint32_t, 8> state_;
  std::array<std::byte, 64> pending_{};
  std::size_t pending_size_ = 0;
  std::uint64_t length_ = 0;  ///< bytes fed
};

PRESHAPE_API std::string sha256_hex(std::string_view text);

}  // namespace preshape
