#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "adapters.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "script/convert.h"
#include "script/guard.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kExplore };

/// One exploration: hands the stations of the script to the problem, counts, and keeps the best.
class Search {
 public:
  Search(const ExplorationProblem& problem, std::int64_t budget, Progress* progress)
      : problem_(problem), budget_(budget), progress_(progress) {}

  /// `evaluate(stations)`: the list of scores, shorter than the list of stations where the budget ends; nil
  /// when it is spent.
  int evaluate(lua_State* L) {
    const std::vector<Station> all = stations_at(L, 1);
    const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, budget_ - result_.evaluations));
    const std::span<const Station> stations(all.data(), std::min(all.size(), left));
    if (stations.size() < all.size()) result_.budget_spent = true;
    if (stations.empty() && !all.empty()) {
      lua_pushnil(L);
      return 1;
    }
    const std::vector<StationScore> scores = score(stations);
    lua_createtable(L, static_cast<int>(scores.size()), 0);
    for (std::size_t i = 0; i < scores.size(); ++i) {
      lua_createtable(L, 0, 3);
      lua_pushnumber(L, scores[i].first);
      lua_setfield(L, -2, "first");
      lua_pushnumber(L, scores[i].second);
      lua_setfield(L, -2, "second");
      lua_pushboolean(L, scores[i].feasible());
      lua_setfield(L, -2, "feasible");
      lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    return 1;
  }

  /// What the script says is best counts like any other station; nil says nothing.
  void settle_on(lua_State* L, const SourcePlace& place) {
    if (lua_isnil(L, -1)) return;
    const Station station = station_of(lua::to_value(L, -1, place), place);
    const bool known = std::find(seen_.begin(), seen_.end(), station) != seen_.end();
    if (!known && result_.evaluations < budget_) score({&station, 1});
  }

  const ExplorationResult& result() const { return result_; }

 private:
  std::vector<StationScore> score(std::span<const Station> stations) {
    std::vector<StationScore> scores(stations.size());
    problem_.evaluate(stations, scores);
    result_.evaluations += static_cast<std::int64_t>(stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      seen_.push_back(stations[i]);
      if (!scores[i].feasible() || !scores[i].better_than(result_.score)) continue;
      result_.best = stations[i];
      result_.score = scores[i];
    }
    if (progress_ && budget_ > 0) {
      progress_->advance("exploring", static_cast<double>(result_.evaluations) / static_cast<double>(budget_),
                         "");
    }
    return scores;
  }

  std::vector<Station> stations_at(lua_State* L, int index) const {
    const SourcePlace caller = lua::innermost_place(L);
    const Value list = lua::to_value(L, index, caller);
    if (!list.is_list()) {
      throw ScriptError(fmt::format("evaluate: expected a list of stations, got {}", list.kind()));
    }
    std::vector<Station> stations;
    for (const Value& station : list.items()) stations.push_back(station_of(station, caller));
    return stations;
  }

  Station station_of(const Value& table, const SourcePlace& place) const {
    const auto counts = problem_.finger_counts();
    const auto offsets = problem_.transverse_offsets();
    auto plane =
        ParameterDeclaration::integer("plane", 1, 1, problem_.planes(), "-", "approach plane, from 1");
    plane.default_value = Value{};
    const Keys keys{"station",
                    {plane,
                     required_number("approach", problem_.lowest_approach(), problem_.highest_approach(), "1",
                                     "x over the half extent"),
                     ParameterDeclaration::integer("virtual_fingers", counts.front(), 0, 3, "-",
                                                   "forefingers; 0 by the rules"),
                     ParameterDeclaration::number("transverse", offsets.front(), -1, 1, "1",
                                                  "offset over the section's half width")},
                    {},
                    {},
                    {}};
    const Parameters p = keys.check(table, place);
    const Station station{static_cast<int>(p.integer("plane")) - 1, p.number("approach"),
                          static_cast<int>(p.integer("virtual_fingers")), p.number("transverse")};
    if (std::find(counts.begin(), counts.end(), station.virtual_fingers) == counts.end()) {
      refuse(place_of(table, place), "station",
             fmt::format("'virtual_fingers' must be one of finger_counts, got {}", station.virtual_fingers));
    }
    if (std::find(offsets.begin(), offsets.end(), station.transverse) == offsets.end()) {
      refuse(place_of(table, place), "station",
             fmt::format("'transverse' must be one of transverse_offsets, got {}", number_text(station.transverse)));
    }
    return station;
  }

  const ExplorationProblem& problem_;
  std::int64_t budget_;
  Progress* progress_;
  std::vector<Station> seen_;
  ExplorationResult result_;
};

/// An explorer whose explore is Lua.
class LuaExplorer final : public Explorer {
 public:
  LuaExplorer(const Value& instance, Blueprint blueprint)
      : pool_(std::move(blueprint), {"explore"}, Chance::kSeeded) {
    Keys{pool_.blueprint().owner(), {}, {"explore"}, {}, {}}.check(instance, {});
  }

  ExplorationResult explore(const ExplorationProblem& problem, std::int64_t budget, std::uint64_t seed,
                            Progress* progress) const override {
    Search search(problem, budget, progress);
    const StatePool::Lease state(pool_);
    const HostCall evaluate(*state, "evaluate", [&](lua_State* L) { return search.evaluate(L); });
    state->enter_long([&](lua_State* L) {
      state->seed(L, seed);
      state->push(kExplore);
      const SourcePlace place = definition(L, -1);
      push_problem(L, problem, evaluate);
      lua_pushinteger(L, static_cast<lua_Integer>(budget));
      lua_pushinteger(L, static_cast<lua_Integer>(seed));
      lua_call(L, 3, 1);
      search.settle_on(L, place);
    });
    return search.result();
  }

 private:
  static void push_problem(lua_State* L, const ExplorationProblem& problem, const HostCall& evaluate) {
    lua_createtable(L, 0, 7);
    lua_pushinteger(L, problem.planes());
    lua_setfield(L, -2, "planes");
    push_numbers(L, problem.symbol_stations());
    lua_setfield(L, -2, "symbol_stations");
    lua_pushnumber(L, problem.lowest_approach());
    lua_setfield(L, -2, "lowest");
    lua_pushnumber(L, problem.highest_approach());
    lua_setfield(L, -2, "highest");
    lua_newtable(L);
    lua_Integer i = 0;
    for (const int count : problem.finger_counts()) {
      lua_pushinteger(L, count);
      lua_rawseti(L, -2, ++i);
    }
    lua_setfield(L, -2, "finger_counts");
    push_numbers(L, problem.transverse_offsets());
    lua_setfield(L, -2, "transverse_offsets");
    evaluate.push(L);
    lua_setfield(L, -2, "evaluate");
  }

  StatePool pool_;
};

}  // namespace

std::shared_ptr<Explorer> make_explorer(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  return std::make_shared<LuaExplorer>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
