#include "simulation_task.h"

#include <fmt/format.h>

#include "geometry_value.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "script/convert.h"
#include "script/guard.h"
#include "stack.h"

namespace preshape::scripted {

namespace {

void set_text(lua_State* L, const char* key, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
  lua_setfield(L, -2, key);
}

void set_number(lua_State* L, const char* key, double number) {
  lua_pushnumber(L, number);
  lua_setfield(L, -2, key);
}

void set_integer(lua_State* L, const char* key, int number) {
  lua_pushinteger(L, number);
  lua_setfield(L, -2, key);
}

void push_fingers(lua_State* L, const HandModel& hand) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Finger& finger : hand.fingers()) {
    lua_createtable(L, 0, 4);
    set_text(L, "name", finger.name);
    set_text(L, "role", role_names()[static_cast<std::size_t>(finger.role)]);
    set_integer(L, "first_joint", finger.first_joint + 1);
    set_integer(L, "joint_count", finger.joint_count);
    lua_rawseti(L, -2, ++i);
  }
}

void push_joints(lua_State* L, const HandModel& hand) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const Joint& joint : hand.joints()) {
    lua_createtable(L, 0, 4);
    set_text(L, "name", joint.name);
    lua_pushboolean(L, joint.prismatic);
    lua_setfield(L, -2, "prismatic");
    set_number(L, "lower", joint.lower);
    set_number(L, "upper", joint.upper);
    lua_rawseti(L, -2, ++i);
  }
}

void push_solids(lua_State* L, const HandModel& hand) {
  lua_newtable(L);
  lua_Integer i = 0;
  for (const LinkSolid& link : hand.solids()) {
    lua_createtable(L, 0, 6);
    if (link.finger >= 0) set_integer(L, "finger", link.finger + 1);
    set_integer(L, "link", link.link);
    set_solid(L, link.solid);
    push_pose(L, link.X_LS);
    lua_setfield(L, -2, "X_LS");
    lua_rawseti(L, -2, ++i);
  }
}

}  // namespace

int call_forward(lua_State* L, const HandModel& hand) {
  const auto fingers = hand.fingers();
  const auto number = lua_tointeger(L, 1);
  if (!lua_isinteger(L, 1) || number < 1 || number > std::ssize(fingers)) {
    throw ScriptError(
        fmt::format("forward: expected a finger in 1 .. {}, got {}", fingers.size(), told_of(L, 1)));
  }
  std::vector<double> q(static_cast<std::size_t>(fingers[static_cast<std::size_t>(number - 1)].joint_count));
  if (const auto wrong = read_numbers(L, 2, q); !wrong.empty())
    throw ScriptError("forward: expected " + wrong);
  std::vector<Pose> poses(q.size() + 2);
  hand.forward(static_cast<int>(number - 1), q, poses);
  lua_createtable(L, static_cast<int>(poses.size()), 0);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    push_pose(L, poses[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

int call_object_distance(lua_State* L, const CollisionScene& object_O) {
  const SourcePlace caller = lua::innermost_place(L);
  const Value list = lua::to_value(L, 1, caller);
  if (!list.is_list())
    throw ScriptError(fmt::format("object_distance: expected a list of solids, got {}", list.kind()));
  std::vector<PosedSolid> solids;
  for (const Value& table : list.items()) {
    const std::string what = fmt::format("object_distance, solid {}", solids.size() + 1);
    Keys keys{what, solid_keys(), {}, {}, {"finger", "link", "X_LS"}};  // a solid of the hand, given its pose
    keys.data.push_back(required_table("X_OS", "pose in the object's frame"));
    const Parameters p = keys.check(table, caller);
    solids.push_back({read_solid(p, caller, what), read_pose(p.value("X_OS"), caller, what + ", X_OS")});
  }
  std::vector<double> distances(solids.size());
  object_O.distance(solids, distances);
  push_numbers(L, distances);
  return 1;
}

void push_task(lua_State* L, const SimulationTask& task, const HostCall& forward,
               const HostCall& object_distance) {
  if (!lua_checkstack(L, 20)) throw ScriptError("calls go too deep");
  lua_createtable(L, 0, 8);
  push_contacts(L, task.contacts);
  lua_setfield(L, -2, "contacts");
  lua_newtable(L);
  for (std::size_t i = 0; i < task.fingers.size(); ++i) {
    lua_pushstring(L, role_names()[static_cast<std::size_t>(task.fingers[i])].c_str());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(L, -2, "fingers");
  push_numbers(L, {task.approach_O.data(), 3});
  lua_setfield(L, -2, "approach");
  push_numbers(L, {task.opposition_O.data(), 3});
  lua_setfield(L, -2, "opposition");
  set_number(L, "clearance", task.clearance_m);
  lua_createtable(L, 0, 3);
  push_fingers(L, task.hand);
  lua_setfield(L, -2, "fingers");
  push_joints(L, task.hand);
  lua_setfield(L, -2, "joints");
  push_solids(L, task.hand);
  lua_setfield(L, -2, "solids");
  lua_setfield(L, -2, "hand");
  forward.push(L);
  lua_setfield(L, -2, "forward");
  object_distance.push(L);
  lua_setfield(L, -2, "object_distance");
}

}  // namespace preshape::scripted
