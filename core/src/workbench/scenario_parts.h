#pragma once

#include "preshape/workbench/scenario.h"

namespace preshape {

/// The keys of a task given as a table.
const ParameterSchema& task_schema();

/// A hand by the name of a description in the catalogue, by a path, or described in place.
/// @throws InputError, ScriptError
HandChoice hand_from_value(const Value& value, const std::filesystem::path& script, const Catalogue& catalogue);

}  // namespace preshape
