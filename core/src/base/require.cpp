#include "preshape/base/require.h"

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape::detail {

void refuse_size(std::string_view what, std::size_t expected, std::size_t actual) {
  throw InputError(fmt::format("{}: expected {} entries, got {}; give a buffer of that size", what, expected, actual));
}

}  // namespace preshape::detail
