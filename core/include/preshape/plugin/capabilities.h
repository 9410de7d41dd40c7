#pragma once

#include <span>
#include <string_view>

#include "preshape/base/export.h"

namespace preshape {

/// A promise that a component may make of itself. The conformance suite holds it to every promise, so that an
/// undeclared one is skipped and a false one fails.
struct Capability {
  std::string_view kind;  ///< "" for every kind
  std::string_view name;
  std::string_view promise;  ///< one line
};

/// All capabilities that the suite knows, by kind in the order of kKinds; those of every kind first.
PRESHAPE_API std::span<const Capability> capabilities();

/// Whether a component of that kind can promise it.
PRESHAPE_API bool is_capability(std::string_view kind, std::string_view name);

}  // namespace preshape
