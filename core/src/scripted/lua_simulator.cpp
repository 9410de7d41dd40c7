#include <cmath>

#include <fmt/format.h>

#include "adapters.h"
#include "geometry_value.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "script/convert.h"
#include "simulation_task.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kSimulate };

const std::vector<std::string> kStatuses = {"reached", "unreachable", "collision", "too_few_fingers"};

void check_task(const SimulationTask& task, const std::string& owner) {
  if (task.contacts.size() != task.fingers.size()) {
    throw InputError(
        fmt::format("{}: {} contacts do not go with {} fingers; name one finger for each contact", owner,
                    task.contacts.size(), task.fingers.size()));
  }
  require_finite(owner, task.contacts);
  for (const auto& [name, axis] :
       {std::pair{"approach", task.approach_O}, std::pair{"opposition", task.opposition_O}}) {
    if (axis.allFinite() && std::abs(axis.norm() - 1.0) <= 1e-6) continue;
    throw InputError(fmt::format("{}: the {} axis must be of unit length, got {}", owner, name,
                                 text_of({axis.data(), 3})));
  }
}

/// A simulator whose simulate is Lua.
class LuaSimulator final : public GraspSimulator {
 public:
  LuaSimulator(const Value& instance, Blueprint blueprint)
      : pool_(std::move(blueprint), {"simulate"}, Chance::kSeeded) {
    Keys{pool_.blueprint().owner(), {}, {"simulate"}, {}, {}}.check(instance, {});
  }

  Simulation simulate(const SimulationTask& task, std::uint64_t seed, Progress*) const override {
    check_task(task, pool_.blueprint().owner());
    const StatePool::Lease state(pool_);
    const HostCall fk(*state, "forward", [&](lua_State* L) { return call_forward(L, task.hand); });
    const HostCall distance(*state, "object_distance",
                            [&](lua_State* L) { return call_object_distance(L, task.object_O); });
    Value result;
    SourcePlace place;
    state->enter_long([&](lua_State* L) {
      state->seed(L, seed);
      state->push(kSimulate);
      place = definition(L, -1);
      push_task(L, task, fk, distance);
      lua_pushinteger(L, static_cast<lua_Integer>(seed));
      lua_call(L, 2, 1);
      result = lua::to_value(L, -1, place);
    });
    return simulation_of(result, place, task.hand);
  }

 private:
  Simulation simulation_of(const Value& result, const SourcePlace& place, const HandModel& hand) const {
    const std::string owner = pool_.blueprint().owner() + ", simulate";
    const Keys keys{owner,
                    {required_choice("status", kStatuses, "how it ended"),
                     ParameterDeclaration::label("reason", "", "unless reached"),
                     optional_table("X_OH", "hand in the object's frame"), optional_table("path", "postures"),
                     ParameterDeclaration::number("contact_error_m", 0.0, 0.0, 1e3, "m",
                                                  "largest distance of a fingertip")},
                    {},
                    {},
                    {}};
    const Parameters p = keys.check(result, place);
    Simulation simulation;
    const auto status = std::find(kStatuses.begin(), kStatuses.end(), p.text("status")) - kStatuses.begin();
    simulation.status = static_cast<Simulation::Status>(status);
    simulation.reason = p.text("reason");
    if (status != 0 && simulation.reason.empty()) {
      refuse(place_of(result, place), owner,
             fmt::format("status '{}' needs a 'reason', one sentence", p.text("status")));
    }
    simulation.X_OH = read_pose(p.value("X_OH"), place, owner + ", X_OH");
    const Value& path = p.value("path");
    if (!path.is_list()) refuse(place_of(path, place), owner, "'path' must be a list of postures");
    for (const Value& posture : path.items()) {
      simulation.path.push_back(read_list(posture, hand.joints().size(), place,
                                          fmt::format("{}, posture {}", owner, simulation.path.size() + 1)));
    }
    simulation.contact_error_m = p.number("contact_error_m");
    return simulation;
  }

  StatePool pool_;
};

}  // namespace

std::shared_ptr<GraspSimulator> make_simulator(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  return std::make_shared<LuaSimulator>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
