#pragma once

#include <span>
#include <string_view>

#include "preshape/base/parameters.h"

namespace preshape::scripted {

/// Letters, digits and '_'.
bool is_name(std::string_view text);

/// A parameter as a component's file declares it: { name, type, default, minimum, maximum, unit, choices,
/// text }.
/// @param before those declared before it
/// @throws ScriptError with the first mistake
ParameterDeclaration read_parameter(const Value& table, const SourcePlace& enclosing,
                                    std::span<const ParameterDeclaration> before);

}  // namespace preshape::scripted
