#pragma once

#include <span>
#include <string>
#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

/// The name nearest to `given` by edit distance (insert, delete, replace, swap of neighbours), or an empty
/// string when none is near enough to be a likely misspelling.
PRESHAPE_API std::string nearest_name(std::string_view given, std::span<const std::string> names);

/// "; did you mean 'x'?", or "; known: a, b, c" when nothing is near, or "" when `names` is empty.
PRESHAPE_API std::string did_you_mean(std::string_view given, std::span<const std::string> names);

}  // namespace preshape
