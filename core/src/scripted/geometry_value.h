#pragma once

#include <string>
#include <vector>

#include "preshape/base/parameters.h"
#include "preshape/hand/hand_model.h"
#include "script/host.h"

namespace preshape::scripted {

// Poses, solids and finger roles as the tables of components have them.

/// { R = {9 numbers, row by row}, p = {3 numbers} }; what is left out, also all of it, is the identity's.
/// @throws ScriptError unless R is a rotation (1e-6) and everything finite
Pose read_pose(const Value& table, const SourcePlace& place, const std::string& owner);
void push_pose(lua_State* L, const Pose& pose);

/// Exactly `count` finite numbers. @throws ScriptError
std::vector<double> read_list(const Value& list, std::size_t count, const SourcePlace& place,
                              const std::string& owner);

/// The keys of a solid's shape, and the solid of a table that has been checked against them.
std::vector<ParameterDeclaration> solid_keys();
Solid read_solid(const Parameters& values, const SourcePlace& place, const std::string& owner);
/// Sets the keys of the shape in the table at the top of the stack.
void set_solid(lua_State* L, const Solid& solid);

/// "thumb", "index", "middle", "ring", "little", in the order of FingerRole.
const std::vector<std::string>& role_names();
FingerRole role_of(const std::string& name);

}  // namespace preshape::scripted
