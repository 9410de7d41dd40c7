#pragma once

#include "preshape/workbench/scenario.h"

namespace preshape {

/// What a key of a scenario takes, so that a list of such things can be told from the thing itself.
struct ScenarioPart {
  enum class Takes { kName, kTask, kList, kPlanes, kInteger, kOther };
  const char* key;
  Takes takes;
  std::string kind = {};      ///< of a component
  std::string standard = {};  ///< the component when none is named
  const ParameterSchema& (*schema)() = nullptr;  ///< of a table of settings
};
const std::vector<ScenarioPart>& scenario_parts();
const ScenarioPart& scenario_part(std::string_view key);

/// The keys of a task given as a table.
const ParameterSchema& task_schema();

/// A hand by the name of a description in the catalogue, by a path, or described in place.
/// @throws InputError, ScriptError
HandChoice hand_from_value(const Value& value, const std::filesystem::path& script, const Catalogue& catalogue);

/// What a hand's component is made with: the whole description for one that declares a parameter `description` (it reads
/// tables of its own); else the description's keys, which are the component's parameters.
/// @throws PluginError when there is no such hand component
Value hand_parameters(const HandChoice& hand, const Registry& registry);

}  // namespace preshape
