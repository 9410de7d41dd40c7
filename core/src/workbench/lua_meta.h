#pragma once

#include <string>

namespace preshape {

/// Annotations of what a component's Lua file and the instance that it makes consist of, kind by kind.
std::string component_file_annotations();

}  // namespace preshape
