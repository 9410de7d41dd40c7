#pragma once

#include "preshape/grasp/simulator.h"
#include "state.h"

namespace preshape::scripted {

/// `forward(finger, q)`: the poses of a finger's base, links and tip in the hand. Body of a HostCall.
int call_forward(lua_State* L, const HandModel& hand);

/// `object_distance(solids)`: the distance of each solid to the object's surface. Body of a HostCall.
int call_object_distance(lua_State* L, const CollisionScene& object_O);

/// Pushes a task as a script sees it. Inside of Host::enter.
void push_task(lua_State* L, const SimulationTask& task, const HostCall& forward,
               const HostCall& object_distance);

}  // namespace preshape::scripted
