#pragma once

#include "preshape/base/export.h"

namespace preshape::detail {
/// Prints the failed condition with its place and aborts.
[[noreturn]] PRESHAPE_API void fail_demand(const char* condition, const char* file, int line);
}  // namespace preshape::detail

/// Always checked: a broken promise between our own parts. Not for input and not in inner loops.
#define PRESHAPE_DEMAND(condition) \
  ((condition) ? void() : ::preshape::detail::fail_demand(#condition, __FILE__, __LINE__))

/// Checked in debug and test builds only, for inner loops.
#ifdef NDEBUG
#define PRESHAPE_ASSERT(condition) ((void)0)
#else
#define PRESHAPE_ASSERT(condition) PRESHAPE_DEMAND(condition)
#endif
