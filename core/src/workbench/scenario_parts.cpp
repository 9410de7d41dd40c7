// Tasks, objects, hands and memories as scenarios name them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/agent/settings.h"
#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "preshape/base/installation.h"
#include "preshape/base/suggest.h"
#include "preshape/grasp/task_space.h"
#include "preshape/io/object_reader.h"
#include "preshape/script/script.h"
#include "preshape/workbench/scenario.h"
#include "scenario_parts.h"

namespace preshape {

namespace fs = std::filesystem;
using D = ParameterDeclaration;

namespace {

bool looks_like_path(const std::string& text) { return text.find_first_of("./") != std::string::npos; }

/// A file named by a script: beside the script, else from the current folder.
fs::path script_path(const std::string& name, const fs::path& script) {
  const fs::path path(name);
  std::error_code error;
  if (path.is_absolute() || script.empty()) return path;
  const fs::path beside = script.parent_path() / path;
  return fs::exists(beside, error) || !fs::exists(path, error) ? beside.lexically_normal() : path;
}

std::array<double, 3> triple(const Value& value, const char* key) {
  std::array<double, 3> numbers{};
  const bool list = value.is_list() && value.items().size() == 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!list || !value.items()[i].is_number() || !std::isfinite(value.items()[i].number())) {
      throw InputError(fmt::format("task: '{}' must be three finite numbers {{x, y, z}}, got {}", key, value.text()));
    }
    numbers[i] = value.items()[i].number();
  }
  return numbers;
}

}  // namespace

const std::vector<ScenarioPart>& scenario_parts() {
  using enum ScenarioPart::Takes;
  static const std::vector<ScenarioPart> parts = {{"object", kName},
                                                  {"hand", kName},
                                                  {"task", kTask},
                                                  {"contact", kName, "contact", "salisbury_soft_finger"},
                                                  {"similarity", kName, "similarity", "tfvadi"},
                                                  {"tie_break", kName, "similarity", "tfdist"},
                                                  {"classifier", kName, "classifier", "mlp"},
                                                  {"collision", kName, "collision", "fcl"},
                                                  {"explorer", kName, "explorer", "beam"},
                                                  {"proof", kName, "explorer", "exhaustive"},
                                                  {"simulator", kName, "simulator", "kinematic"},
                                                  {"analysis", kOther, "", "", analysis_schema},
                                                  {"thresholds", kOther, "", "", threshold_schema},
                                                  {"learning", kOther, "", "", learning_schema},
                                                  {"execution", kOther, "", "", execution_schema},
                                                  {"fuzzy", kList},
                                                  {"symbols", kList},
                                                  {"planes", kPlanes},
                                                  {"stations", kList},
                                                  {"pretrain", kName},
                                                  {"seed", kInteger}};
  return parts;
}

const ScenarioPart& scenario_part(std::string_view key) {
  const auto& parts = scenario_parts();
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const ScenarioPart& part) { return key == part.key; });
  PRESHAPE_DEMAND(found != parts.end());
  return *found;
}

const ParameterSchema& task_schema() {
  static const ParameterSchema schema(
      "task", {D::list("T", {0.1, 0.1, 0.1}, -1e6, 1e6, "1", "translation wanted along X, Y, Z; 1 is a full primitive"),
               D::list("R", {0.05, 0.05, 0.05}, -1e6, 1e6, "1", "rotation wanted about X, Y, Z"),
               D::label("name", "", "a task of the task space, such as \"T1_2\" or \"T1_2+-\""),
               D::label("manipulation", "", "one of Michelman's manipulations, with approach and opposition"),
               D::label("approach", "X", "approach axis of the manipulation"),
               D::label("opposition", "Z", "opposition axis of the manipulation"),
               D::number("stability", 6.0, 0.0, 6.0, "1", "stability wanted"),
               D::number("manipulability", 5.0, 0.0, 6.0, "1", "manipulability wanted")});
  return schema;
}

Task task_from_value(const Value& value) {
  if (value.is_string()) return named_task(value.string());
  if (value.is_list()) {
    if (value.items().size() != kComponents) {
      throw InputError(fmt::format("a task given as a list has six numbers {{Tx, Ty, Tz, Rx, Ry, Rz}}, got {}", value.text()));
    }
    Task task;
    for (std::size_t i = 0; i < kComponents; ++i) {
      const Value& item = value.items()[i];
      if (!item.is_number() || !std::isfinite(item.number())) {
        throw InputError(fmt::format("task: component {} must be a finite number, got {}", i + 1, item.text()));
      }
      task.screw[i] = item.number();
    }
    return task;
  }
  const Parameters p = task_schema().resolve(value, value.place());
  Task task;
  if (!p.text("manipulation").empty()) {
    task = manipulation_task(p.text("manipulation"), p.text("approach"), p.text("opposition"));
  } else if (!p.text("name").empty() && !value.find("T") && !value.find("R")) {
    task = named_task(p.text("name"));
  } else {
    const auto T = triple(p.value("T"), "T"), R = triple(p.value("R"), "R");
    for (std::size_t i = 0; i < 3; ++i) task.screw[i] = T[i], task.screw[i + 3] = R[i];
    task.name = p.text("name");
  }
  task.stability = p.number("stability");
  task.manipulability = p.number("manipulability");
  return task;
}

const ParameterSchema& object_schema() {
  static const ParameterSchema schema = [] {
    std::vector<D> declarations = {D::label("name", "", "a shipped object, or a name for the mesh"),
                                   D::label("mesh", "", "mesh file, relative to the script"),
                                   D::number("weld", kDefaultWeld, 0.0, 0.01, "1",
                                             "vertices nearer than this share of the box diagonal are one"),
                                   D::label("summary", "", "one line on the object")};
    const auto placement = placement_schema().declarations();
    declarations.insert(declarations.end(), placement.begin(), placement.end());
    return ParameterSchema("object", std::move(declarations));
  }();
  return schema;
}

ObjectChoice object_from_value(const Value& value, const fs::path& script, const Catalogue& catalogue) {
  Value table = value;
  if (value.is_string()) {
    table = Value{};
    table.set(looks_like_path(value.string()) ? "mesh" : "name", value.string());
  }
  Parameters p = object_schema().resolve(table, value.place());
  fs::path folder_of_mesh = script;
  if (p.text("mesh").empty()) {
    if (p.text("name").empty()) throw InputError("object: give a 'name' or a 'mesh'");
    // The shipped description, with what the scenario says on top of it.
    const fs::path file = catalogue.object(p.text("name"));
    Value description = read_description(file);
    if (const auto wrong = object_schema().check(description); !wrong.empty()) throw InputError(wrong.front().text());
    for (const auto& [key, entry] : table.entries()) description.set(key, entry);
    p = object_schema().resolve(description);
    folder_of_mesh = file;
  }
  ObjectChoice choice;
  choice.mesh = script_path(p.text("mesh"), folder_of_mesh);
  choice.name = p.text("name").empty() ? choice.mesh.stem().string() : p.text("name");
  choice.placement = object_placement(p);
  choice.weld = p.number("weld");
  choice.place = value.place();
  return choice;
}

namespace {

/// "claw" of claw/hand.lua and of claw.lua.
std::string hand_name(const fs::path& file) {
  std::error_code ignored;
  const std::string folder = fs::absolute(file, ignored).lexically_normal().parent_path().filename().string();
  return file.filename() == "hand.lua" && !folder.empty() ? folder : file.stem().string();
}

}  // namespace

HandChoice hand_from_value(const Value& value, const fs::path& script, const Catalogue& catalogue) {
  HandChoice choice;
  choice.place = value.place();
  if (value.is_string()) {
    const bool path = looks_like_path(value.string());
    const fs::path file = path ? script_path(value.string(), script) : catalogue.hand(value.string());
    choice.name = path ? hand_name(file) : value.string();
    choice.description = read_description(file);
  } else if (!value.is_table()) {
    throw InputError(fmt::format("a hand is a name, a path or a table, got {} {}", value.kind(), value.text()));
  } else {
    choice.name = value.find("name") && value.find("name")->is_string() ? value.find("name")->string() : "hand";
    choice.description = value;
  }
  const Value* model = choice.description.find("model");
  if (!model || !model->is_string()) {
    throw InputError(fmt::format("{}hand '{}': 'model' is missing; say which hand plugin reads it, such as model = \"dh\"",
                                 choice.description.place().known() ? choice.description.place().text() + ": " : "", choice.name));
  }
  choice.model = model->string();
  return choice;
}

std::shared_ptr<HandModel> load_hand(const Value& value, const fs::path& script, const Registry& registry,
                                     const Catalogue& catalogue) {
  const HandChoice choice = hand_from_value(value, script, catalogue);
  return registry.create<HandModel>(choice.model, hand_parameters(choice, registry), choice.place);
}

Value hand_parameters(const HandChoice& hand, const Registry& registry) {
  if (registry.describe("hand", hand.model).schema.find("description")) return Value::table({{"description", hand.description}});
  Value parameters = hand.description;
  for (const char* key : {"model", "name", "summary"}) parameters.erase(key);
  return parameters;
}

fs::path memory_path(const std::string& name) {
  if (looks_like_path(name) || name.starts_with(":memory:")) return name;
  return user_folder() / "memories" / (name + ".memory");
}

}  // namespace preshape
