#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "preshape/agent/learning_element.h"
#include "preshape/agent/settings.h"
#include "preshape/base/value.h"
#include "preshape/geometry/object.h"
#include "preshape/grasp/approach_plane.h"
#include "preshape/grasp/task.h"
#include "preshape/plugin/registry.h"
#include "preshape/workbench/catalogue.h"

namespace preshape {

/// A component as a scenario chooses it.
struct ComponentChoice {
  std::string role, kind, name;
  Value parameters;  ///< nil or a table, as given
  Value exploration;  ///< of an explorer: what was given of exploration_schema
  SourcePlace place;
};

/// The object as a scenario chooses it.
struct ObjectChoice {
  std::string name;            ///< for people
  std::filesystem::path mesh;  ///< file
  ObjectPlacement placement;
  double weld = 0.0;           ///< relative tolerance
  SourcePlace place;
};

/// The hand as a scenario chooses it.
struct HandChoice {
  std::string name;
  std::string model;  ///< component of kind hand
  Value description;
  SourcePlace place;
};

/// A scenario, checked: what a script describes (spec section 12, design "scripts").
struct Scenario {
  std::string file;
  Value description;  ///< as given
  ObjectChoice object;
  HandChoice hand;
  std::optional<Task> task;  ///< none in a pretraining script
  ComponentChoice contact, similarity, tie_break, classifier, collision, explorer, proof;
  std::optional<ComponentChoice> simulator;  ///< none: the grasp is not carried out
  std::vector<ComponentChoice> quality;
  Parameters analysis, thresholds, learning, execution;
  FuzzyPartition sets, symbols;
  ApproachPlanes planes;
  std::string memory;    ///< a name or a path; see memory_path
  std::string pretrain;  ///< object that an empty memory is taught first, or "none"
  Pretraining pretraining;
  std::uint64_t seed = 1;
  std::optional<Value::Function> on_report;
};

/// What kind of script is read: a pretraining script has no task.
enum class ScenarioUse { kRun, kPretrain };

/// A scenario with everything that is wrong with it; usable when nothing is.
struct ScenarioReading {
  Scenario scenario;
  std::vector<Mistake> mistakes;
};

/// Checks a whole description against every declaration: nothing is run, no mesh is read.
/// @param file the script, for places and for paths relative to it
PRESHAPE_API ScenarioReading read_scenario(const Value& description, const std::filesystem::path& file, ScenarioUse use,
                                           const Registry& registry, const Catalogue& catalogue);

/// Parts of it that meta control may change later.
/// @throws InputError
PRESHAPE_API Task task_from_value(const Value& value);
PRESHAPE_API ObjectChoice object_from_value(const Value& value, const std::filesystem::path& script,
                                            const Catalogue& catalogue);

/// A hand as a scenario names it: of the catalogue, a description file, or a description in place.
/// @param script what paths are relative to, or empty
/// @throws InputError, ScriptError, PluginError
PRESHAPE_API std::shared_ptr<HandModel> load_hand(const Value& value, const std::filesystem::path& script,
                                                  const Registry& registry, const Catalogue& catalogue);

/// Keys of a scenario with one line each, for help and reference.
struct ScenarioKey {
  std::string name, value, text;
};
PRESHAPE_API const std::vector<ScenarioKey>& scenario_keys();

/// The declared parameters of an object's table.
PRESHAPE_API const ParameterSchema& object_schema();

/// Where a memory of that name is: a bare name in the user's folder, anything with a slash or a dot as a path,
/// ":memory:" in no file at all.
PRESHAPE_API std::filesystem::path memory_path(const std::string& name);

}  // namespace preshape
