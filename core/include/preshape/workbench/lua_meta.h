#pragma once

#include <string>

#include "preshape/plugin/registry.h"
#include "preshape/workbench/catalogue.h"

namespace preshape {

/// Annotations for the Lua language server, as one Lua file: the module `preshape`, a scenario with every declared
/// parameter, and the components, objects, hands and tasks that are found. An editor that reads it completes names and
/// marks misspelt keys. Written from the declarations alone; no component is made. A component that is refused when it
/// is described is left out.
PRESHAPE_API std::string lua_annotations(const Registry& registry, const Catalogue& catalogue);

}  // namespace preshape
