// The classes of a component's file, for the annotations. What it may say is checked in scripted/; a test compares them
// with the templates.
#include "lua_meta.h"

#include <fmt/format.h>

namespace preshape {

namespace {

/// What the instances and their functions are made of.
constexpr const char* kParts = R"(
-- A component's file, NAME.plugin.lua: docs/lua-components.md

---@class (exact) preshape.ParameterDeclaration
---@field name string
---@field type "boolean"|"integer"|"number"|"text"|"choice"|"numbers"|"table"
---@field default? any without one it must be given
---@field minimum? number
---@field maximum? number
---@field unit? string "m", "rad", "1" for a ratio
---@field choices? string[] of a choice
---@field text string one line

---three numbers each, in the object's frame
---@class (exact) preshape.Contact
---@field p number[] contact point [m]
---@field n number[] inward unit normal of the object
---@field a number[] approach axis
---@field t number[] n x a

---@class (exact) preshape.Grasp
---@field contacts preshape.Contact[] thumb first
---@field wrenches number[][] pattern wrenches about their own points
---@field wrench_union number[][] unit wrenches about O, lengths over L
---@field resultant number[] about O
---@field length number L [m]
---@field approach? number[] unit, in O: the way the hand comes
---@field opposition? number[] unit, in O: the way the forefingers push

---@class (exact) preshape.TrainingOutcome
---@field status? "arrived"|"stalled"
---@field epochs? integer
---@field restarts? integer
---@field mean_squared_error? number
---@field wrong_rows? integer

---what is left out is the identity's
---@class (exact) preshape.Pose
---@field R? number[] nine numbers, row by row
---@field p? number[] three numbers [m]

---@alias preshape.FingerRole "thumb"|"index"|"middle"|"ring"|"little"

---@class (exact) preshape.FingerDescription
---@field name string
---@field role preshape.FingerRole
---@field base? preshape.Pose of the finger's base in the hand
---@field joints preshape.JointDescription[] base to tip
---@field tip? preshape.Pose of the tip in the last link

---@class (exact) preshape.JointDescription
---@field name string
---@field prismatic? boolean
---@field lower number [rad] or [m]
---@field upper number
---@field torque_limit? number
---@field follows? { joint: string, ratio: number, offset?: number } joint that moves it, of any finger
---@field X_PJ? preshape.Pose of the joint in the link before
---@field X_JL? preshape.Pose of the link in the joint

---@class (exact) preshape.LinkSolid
---@field finger? string none: the palm
---@field link? integer
---@field shape "sphere"|"capsule"|"box"
---@field radius? number [m]
---@field half_length? number [m] capsule, along z
---@field half_extents? number[] [m] box
---@field X_LS? preshape.Pose

---@class (exact) preshape.Station
---@field plane integer from 1
---@field approach number over the half extent
---@field virtual_fingers? integer
---@field transverse? number over the section's half width

---@class (exact) preshape.ExplorationProblem
---@field planes integer
---@field symbol_stations number[]
---@field lowest number
---@field highest number
---@field finger_counts integer[]
---@field transverse_offsets number[]
---@field evaluate fun(stations: preshape.Station[]): { first: number, second: number, feasible: boolean }[]?

---@class (exact) preshape.SimulationTask
---@field contacts preshape.Contact[]
---@field fingers preshape.FingerRole[] which finger goes to which contact
---@field approach number[] unit, in O
---@field opposition number[] unit, in O
---@field clearance number [m]
---@field hand { fingers: table[], joints: table[], solids: table[] }
---@field forward fun(finger: integer, q: number[]): preshape.Pose[]
---@field object_distance fun(solids: table[]): number[]

---@class (exact) preshape.Simulation
---@field status "reached"|"unreachable"|"collision"|"too_few_fingers"
---@field reason? string unless reached: one sentence
---@field X_OH? preshape.Pose hand base
---@field path? number[][] postures, each a number for every joint
---@field contact_error_m? number
)";

/// The keys of what `new` returns.
struct InstanceNotes {
  const char* kind;
  const char* name;  ///< of the classes
  const char* fields;
};

constexpr InstanceNotes kInstances[] = {
    {"contact", "Contact", R"(---@field basis_size integer number of unit wrenches
---@field basis fun(C: preshape.Contact): number[][] unit wrenches about the contact's own point, in O
---@field pattern fun(C: preshape.Contact): ... what the contact adds to the pattern: six numbers, or a list of six
---@field primitives? fun(C: preshape.Contact, resolution: integer): number[][] edges of the cone that the contact can bear
---@field admits? fun(C: preshape.Contact, wrench: number[], tolerance: number): boolean
)"},
    {"similarity", "Similarity", R"(---@field scale { farthest: number, nearest: number }|fun(sets: integer): { farthest: number, nearest: number }
---@field component? fun(task: table, pattern: table): number what one component adds; memberships 1 .. sets, and crisp
---@field compare? fun(task: table, pattern: table): number the score, in place of component
---@field components? fun(task: table, pattern: table): ... with compare: six numbers that explain the score
)"},
    {"classifier", "Classifier", R"(---@field fit fun(inputs: number[][], targets: number[][], seed: integer): any, preshape.TrainingOutcome? the model: plain data
---@field extend? fun(model: any, inputs: number[][], targets: number[][], first_new: integer, seed: integer): any, preshape.TrainingOutcome?
---@field predict fun(model: any, input: number[]): ... probability of each bit, as results or as a list
)"},
    {"hand", "Hand", R"(---@field dimensions { unit_length: number, finger_spacing: number, maximum_opening: number, base_width: number } [m]
---@field fingers preshape.FingerDescription[]
---@field solids? preshape.LinkSolid[]
---@field forward? fun(finger: integer, q: number[]): preshape.Pose[] poses of base, each link and tip, in place of the chains
)"},
    {"quality", "Quality", R"(---@field numbers { name: string, unit?: string, lowest: number, highest: number, higher_is_better?: boolean }[]
---@field evaluate fun(grasp: preshape.Grasp): ... those numbers, in order, as results or as a list
)"},
    {"explorer", "Explorer", R"(---@field explore fun(problem: preshape.ExplorationProblem, budget: integer, seed: integer): preshape.Station?
)"},
    {"simulator", "Simulator", R"(---@field simulate fun(task: preshape.SimulationTask, seed: integer): preshape.Simulation
)"},
};

/// The keys that the files of every kind have; {0} is the kind, {1} its name in classes.
constexpr const char* kFile = R"(
---what the file of kind {0} returns
---@class (exact) preshape.{1}Component
---@field kind "{0}"
---@field name string letters, digits, _; the file's name without its ending
---@field version string such as "1.0.0"
---@field licence string
---@field author string
---@field summary string one line
---@field capabilities? string[] promises that the conformance suite checks
---@field parameters? preshape.ParameterDeclaration[]
---@field new fun(p: table<string, any>): preshape.{1}Instance
)";

}  // namespace

std::string component_file_annotations() {
  std::string text = kParts;
  for (const auto& [kind, name, fields] : kInstances) {
    text += fmt::format("\n---what `new` of kind {} returns\n---@class (exact) preshape.{}Instance\n{}", kind, name, fields);
    text += fmt::format(fmt::runtime(kFile), kind, name);
  }
  return text;
}

}  // namespace preshape
