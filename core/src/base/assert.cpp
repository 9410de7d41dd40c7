#include "preshape/base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace preshape::detail {

void fail_demand(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "preshape: internal error: '%s' does not hold (%s:%d)\n", condition, file, line);
  std::abort();
}

}  // namespace preshape::detail
