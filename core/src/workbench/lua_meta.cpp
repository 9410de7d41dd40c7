#include "preshape/workbench/lua_meta.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzzy/set_shapes.h"
#include "lua_meta.h"
#include "preshape/agent/settings.h"
#include "preshape/base/error.h"
#include "preshape/grasp/task_space.h"
#include "preshape/workbench/scenario.h"
#include "preshape/workbench/script_host.h"
#include "scenario_parts.h"

namespace preshape {

namespace {

constexpr const char* kHead = R"(---@meta
-- The module `preshape` and scenarios, for the Lua language server. Written by `preshape lua-meta`; do not edit.
)";

/// Classes that no declaration describes.
constexpr const char* kPlainClasses = R"(
---a report, see docs/report-schema.md
---@alias preshape.Report table<string, any>

---what `on_report` returns to go on
---@class (exact) preshape.Correction
---@field task? preshape.TaskName|number[]|preshape.Task
---@field object? string|preshape.Object
---@field thresholds? preshape.Thresholds

---an approach plane
---@class (exact) preshape.Plane
---@field approach preshape.Axis|number[] the way the hand comes
---@field push preshape.Axis|number[] the way the forefingers push

---approach planes that are sampled
---@class (exact) preshape.SampledPlanes
---@field directions? integer spread evenly over the sphere
---@field rolls? integer planes of each direction
---@field thesis? boolean the thesis's twelve come first

---@alias preshape.Axis "X"|"Y"|"Z"|"+X"|"+Y"|"+Z"|"-X"|"-Y"|"-Z"

---what teaching an object gave
---@class (exact) preshape.Lesson
---@field rows_added integer
---@field evaluations integer
---@field arrived boolean
---@field epochs integer
---@field restarts integer
---@field wrong_rows integer
---@field mean_squared_error number

---how much of a memory its classifier predicts
---@class (exact) preshape.Taught
---@field rows integer in the memory
---@field predicted integer of them: plane, symbol and finger count all right

---the best grasp that the explorers find
---@class (exact) preshape.Best
---@field plane integer
---@field symbol integer
---@field virtual_fingers integer
---@field approach number over the half extent
---@field transverse number over the section's half width
---@field first number score of the deciding measure
---@field second number score of the other one
---@field evaluations integer

---a grasp of the workspace
---@class (exact) preshape.WorkspaceRow
---@field plane integer
---@field symbol integer
---@field virtual_fingers integer
---@field approach number over the half extent
---@field wrench number[] resultant about O, lengths over L
---@field quality table<string, number> all numbers of the quality measures
---@field first number score of the deciding measure
---@field second number score of the other one

---every combination of a scenario that gives lists where it gives one
---@class (exact) preshape.Comparison
---@field schema string
---@field scenario string
---@field keys string[] what was chosen from: "contact", "thresholds.estimation"
---@field rows preshape.ComparedRun[]

---@class (exact) preshape.ComparedRun
---@field choices table<string, any>
---@field report? preshape.Report
---@field seconds? number
---@field refusal? string

---a task of the task space
---@class (exact) preshape.TaskRecord
---@field name string
---@field T number[]
---@field R number[]

---a component that can be used
---@class (exact) preshape.ComponentRecord
---@field kind preshape.Kind
---@field name string
---@field summary string
---@field plugin string
---@field version string
---@field capabilities string[]
---@field parameters preshape.ParameterRecord[]

---@class (exact) preshape.ParameterRecord
---@field name string
---@field type string
---@field default any
---@field minimum? number
---@field maximum? number
---@field choices? string[]
---@field unit string
---@field text string
)";

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// "a"|"b", or the type for nothing where there is none.
std::string literals(const std::vector<std::string>& names, const char* none) {
  std::vector<std::string> all;
  for (const auto& name : names) all.push_back(quoted(name));
  return all.empty() ? none : fmt::format("{}", fmt::join(all, "|"));
}

std::string type_of(const ParameterDeclaration& d) {
  switch (d.type) {
    case ParameterType::kBoolean: return "boolean";
    case ParameterType::kInteger: return "integer";
    case ParameterType::kNumber: return "number";
    case ParameterType::kText: return "string";
    case ParameterType::kChoice: return literals(d.choices, "string");
    case ParameterType::kNumbers: return "number[]";
    case ParameterType::kTable: return "table";
  }
  return "any";
}

/// "thickness [m], 0 .. 1, default 0.1": what stands behind a field's type.
std::string remark(const ParameterDeclaration& d) {
  std::string text = d.text;
  if (d.unit != "-") text += fmt::format(" [{}]", d.unit);
  const bool numeric = d.type == ParameterType::kNumber || d.type == ParameterType::kInteger || d.type == ParameterType::kNumbers;
  if (numeric && d.bounds_text() != "any") text += ", " + d.bounds_text();
  if (d.default_value.is_nil()) return text + ", must be given";
  return text + ", default " + d.default_value.text();
}

/// Whether a list of values may stand for the value, to be compared.
enum class Lists { kNo, kCompared };

/// The type, or a list of it.
std::string one_or_list(const std::string& type) {
  const bool single = type.find('|') == std::string::npos;
  return fmt::format(fmt::runtime(single ? "{0}|{0}[]" : "{0}|({0})[]"), type);
}

std::string fields(std::span<const ParameterDeclaration> declarations, Lists lists) {
  std::string text;
  for (const auto& d : declarations) {
    const bool listed = lists == Lists::kCompared && d.type != ParameterType::kTable;
    text += fmt::format("---@field {}{} {} {}\n", d.name, d.default_value.is_nil() ? "" : "?",
                        listed ? one_or_list(type_of(d)) : type_of(d), remark(d));
  }
  return text;
}

std::string schema_class(const char* name, const char* text, const ParameterSchema& schema, Lists lists) {
  return fmt::format("\n---{}\n---@class (exact) preshape.{}\n{}", text, name, fields(schema.declarations(), lists));
}

/// A component's option table: { "name", key = value } or { name = "name", key = value }.
std::string component_class(const ComponentRecord& record) {
  const bool hand = record.kind == "hand";
  std::string text = fmt::format("\n---{}\n---@class {}preshape.{}.{}\n", record.summary,
                                 hand && record.schema.find("description") ? "" : "(exact) ", record.kind, record.name);
  if (!hand) return text + fmt::format("---@field [1]? \"{0}\"\n---@field name? \"{0}\"\n", record.name) + fields(record.schema.declarations(), Lists::kCompared) +
                             (record.kind == "explorer" ? fields(exploration_schema().declarations(), Lists::kCompared) : "");
  text += fmt::format("---@field model \"{}\"\n---@field name? string for reports\n---@field summary? string one line\n", record.name);
  if (record.schema.find("description")) return text + "---@field [string] any the description's own keys\n";
  return text + fields(record.schema.declarations(), Lists::kNo);
}

/// The classes of a kind's components, and the alias of whatever a scenario may say for it.
std::string kind_classes(const Registry& registry, const std::string& kind) {
  std::string classes;
  std::vector<std::string> names, tables;
  for (const auto& name : registry.names(kind)) {
    try {
      classes += component_class(registry.describe(kind, name));
      names.push_back(name);
      tables.push_back(fmt::format("preshape.{}.{}", kind, name));
    } catch (const PluginError&) {
      // Refused when it was loaded: it cannot be used.
    }
  }
  const std::string options = tables.empty() ? "table" : fmt::format("{}", fmt::join(tables, "|"));
  classes += fmt::format("\n---@alias preshape.{}_name {}\n", kind, literals(names, "string"));
  return classes + fmt::format("---@alias preshape.{0} {1}{2}\n", kind, kind == "hand" ? "" : fmt::format("preshape.{}_name|", kind), options);
}

std::string set_class() {
  std::string text = "\n---one fuzzy set; exactly one shape\n---@class (exact) preshape.FuzzySet\n---@field name string\n";
  for (const auto& shape : set_shapes()) text += fmt::format("---@field {}? number[] {} numbers: {}\n", shape.word, shape.points, shape.meaning);
  return text;
}

/// The type of a scenario's key: of the declared value, where that says it, else by the key.
std::string key_type(const ScenarioKey& key) {
  static const std::map<std::string, std::string> kComponents = {{"tie_break", "similarity"}, {"proof", "explorer"}};
  static const std::map<std::string, std::string> kTypes = {
      {"object", one_or_list("preshape.ObjectName|string|preshape.Object")},
      {"hand", one_or_list("preshape.HandName|string|preshape.hand")},
      {"task", one_or_list("preshape.TaskName|number[]|preshape.Task")},
      {"quality", "preshape.quality|preshape.quality[]"},
      {"analysis", "preshape.Analysis"},
      {"thresholds", "preshape.Thresholds"},
      {"learning", "preshape.Learning"},
      {"execution", "preshape.Execution"},
      {"pretrain", one_or_list("preshape.ObjectName|\"none\"")},
      {"on_report", "fun(report: preshape.Report): preshape.Correction?"}};
  static const std::map<std::string, std::string> kValues = {
      {"string", "string"}, {"name | path", "string"}, {"integer", one_or_list("integer")}, {"list of numbers", one_or_list("number[]")},
      {"list of sets", one_or_list("preshape.FuzzySet[]")},
      {"list of planes", one_or_list("preshape.Plane[]|preshape.SampledPlanes")}, {"number", "number"}};
  if (const auto found = kTypes.find(key.name); found != kTypes.end()) return found->second;
  if (key.name == "simulator") return one_or_list("preshape.simulator|\"none\"");
  if (key.value == "component") {
    const auto found = kComponents.find(key.name);
    return one_or_list("preshape." + (found == kComponents.end() ? key.name : found->second));
  }
  const auto found = kValues.find(key.value);
  return found == kValues.end() ? "any" : found->second;
}

std::string scenario_class() {
  std::string text = "\n---@class (exact) preshape.Scenario\n";
  for (const auto& key : scenario_keys()) {
    text += fmt::format("---@field {}{} {} {}\n", key.name, key.name == "object" ? "" : "?", key_type(key), key.text);
  }
  return text;
}

/// "(kind: string?, n: integer): table[]" as annotations and an empty function.
std::string function_text(const HostRecord& record) {
  const auto close = record.signature.rfind(')');
  if (record.signature.empty() || record.signature[0] != '(' || close == std::string::npos) {
    return fmt::format("\n---{}\n---@type {}\npreshape.{} = nil\n", record.text, record.signature, record.name);
  }
  std::string text = fmt::format("\n---{}\n", record.text), names;
  std::string rest = record.signature.substr(1, close - 1);
  while (!rest.empty()) {
    const auto comma = std::min(rest.find(", "), rest.size());
    const std::string parameter = rest.substr(0, comma);
    rest = comma == rest.size() ? "" : rest.substr(comma + 2);
    const auto colon = parameter.find(": ");
    std::string name = parameter.substr(0, colon), type = parameter.substr(colon + 2);
    const bool optional = type.ends_with('?');
    if (optional) type.pop_back();
    text += fmt::format("---@param {}{} {}\n", name, optional ? "?" : "", type);
    names += (names.empty() ? "" : ", ") + name;
  }
  return text + fmt::format("---@return {}\nfunction preshape.{}({}) end\n", record.signature.substr(close + 3), record.name, names);
}

std::string module_text(const Registry& registry, const Catalogue& catalogue) {
  Script script = Script::from_text("", "lua-meta");
  ScriptHost host(registry, catalogue, {});
  host.add_to(script);
  std::string text = "\n---what a script calls\n---@class preshape.Module\npreshape = {}\n";
  for (const auto& record : script.records()) text += function_text(record);
  return text;
}

std::vector<std::string> task_names() {
  std::vector<std::string> names;
  for (const auto& task : signed_task_space()) names.push_back(task.name);
  return names;
}

}  // namespace

std::string lua_annotations(const Registry& registry, const Catalogue& catalogue) {
  const std::vector<std::string> kinds(kKinds.begin(), kKinds.end());
  std::string text = kHead;
  text += fmt::format("\n---@alias preshape.Kind {}\n", literals(kinds, "string"));
  text += fmt::format("---@alias preshape.ObjectName {}\n", literals(catalogue.objects(), "string"));
  text += fmt::format("---@alias preshape.HandName {}\n", literals(catalogue.hands(), "string"));
  text += fmt::format("---@alias preshape.TaskName {}\n", literals(task_names(), "string"));
  for (const auto& kind : kinds) text += kind_classes(registry, kind);
  text += schema_class("Object", "an object: a shipped one by name, or a mesh", object_schema(), Lists::kNo);
  text += schema_class("Task", "a task by components, by name or as a named manipulation", task_schema(), Lists::kNo);
  text += schema_class("Analysis", "how virtual grasps are analysed", analysis_schema(), Lists::kCompared);
  text += schema_class("Thresholds", "thresholds of the critic", threshold_schema(), Lists::kCompared);
  text += schema_class("Learning", "how the agent learns", learning_schema(), Lists::kCompared);
  text += schema_class("Execution", "how the hand carries the grasp out", execution_schema(), Lists::kCompared);
  text += set_class();
  text += kPlainClasses;
  text += scenario_class();
  text += component_file_annotations();
  return text + module_text(registry, catalogue);
}

}  // namespace preshape
