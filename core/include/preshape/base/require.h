#pragma once

#include <cstddef>
#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

namespace detail {
[[noreturn]] PRESHAPE_API void refuse_size(std::string_view what, std::size_t expected, std::size_t actual);
}  // namespace detail

/// The check that a caller's buffer has the size that the other arguments ask for.
/// @param what the buffer, as a person would name it: "scores"
/// @throws InputError "scores: expected 4 entries, got 3; ..."
inline void require_size(std::string_view what, std::size_t expected, std::size_t actual) {
  if (expected != actual) detail::refuse_size(what, expected, actual);
}

}  // namespace preshape
