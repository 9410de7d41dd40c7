// What every search keeps to, and what some promise: X01 and on.
#include <algorithm>
#include <cmath>

#include "landscape.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// A search on a terrain with a budget, and what is wrong with it or "".
using Law = std::function<std::string(const Terrain&, std::int64_t budget, const Search&)>;

std::vector<Block> searches(double least_budget, double most_budget) {
  auto blocks = terrain_blocks();
  blocks.push_back({"budget", 1, least_budget, most_budget, {1, 2, 7, 50}, true});
  return blocks;
}

void for_searches(Context& context, const Law& law, double least_budget = 1, double most_budget = 400) {
  const auto explorer = context.create<Explorer>();
  context.for_all(searches(least_budget, most_budget), context.cases(400), [&](Case c) -> std::string {
    const Terrain terrain = terrain_of(c);
    const auto budget = static_cast<std::int64_t>(c[kTerrainNumbers]);
    return law(terrain, budget, search(*explorer, terrain, budget));
  });
}

void x01_keeps_to_the_budget(Context& context) {
  for_searches(context, [](const Terrain&, std::int64_t budget, const Search& found) -> std::string {
    if (std::ssize(found.asked) <= budget) return "";
    return fmt::format("it asked for {} stations with a budget of {}", found.asked.size(), budget);
  });
}

void x02_budget_of_none(Context& context) {
  const auto explorer = context.create<Explorer>();
  context.for_all(terrain_blocks(), context.cases(50), [&](Case c) -> std::string {
    const Search found = search(*explorer, terrain_of(c), 0);
    if (!found.asked.empty())
      return fmt::format("it asked for {} stations with a budget of 0", found.asked.size());
    if (!found.result.score.feasible()) return "";
    return fmt::format("it found the score {} with a budget of 0", score_text(found.result.score));
  });
}

void x03_counts_truly(Context& context) {
  for_searches(context, [](const Terrain&, std::int64_t, const Search& found) -> std::string {
    if (found.result.evaluations == std::ssize(found.asked)) return "";
    return fmt::format("it tells of {} evaluations and asked for {}", found.result.evaluations,
                       found.asked.size());
  });
}

/// Whether it is one of the problem's stations; a multiple of a step may be rounded over the border.
bool belongs(const Station& s, const Terrain& terrain) {
  constexpr double kRounding = 1e-12;
  return s.plane >= 0 && s.plane < terrain.planes && s.approach >= terrain.lowest - kRounding &&
         s.approach <= terrain.highest + kRounding &&
         std::find(terrain.fingers.begin(), terrain.fingers.end(), s.virtual_fingers) !=
             terrain.fingers.end() &&
         std::find(terrain.offsets.begin(), terrain.offsets.end(), s.transverse) != terrain.offsets.end();
}

void x04_asks_for_stations_of_the_problem(Context& context) {
  for_searches(context, [](const Terrain& terrain, std::int64_t, const Search& found) -> std::string {
    for (const Station& s : found.asked) {
      if (!belongs(s, terrain))
        return fmt::format("it asked for {}, which is none of the problem's", station_text(s));
    }
    return "";
  });
}

void x05_best_was_evaluated(Context& context) {
  for_searches(context, [](const Terrain& terrain, std::int64_t, const Search& found) -> std::string {
    const ExplorationResult& r = found.result;
    const bool any = std::any_of(found.asked.begin(), found.asked.end(),
                                 [&](const Station& s) { return terrain.score(s).feasible(); });
    if (!r.score.feasible() || !any) return "";
    if (std::find(found.asked.begin(), found.asked.end(), r.best) == found.asked.end()) {
      return fmt::format("the best, {}, was never evaluated", station_text(r.best));
    }
    if (same(r.score, terrain.score(r.best))) return "";
    return fmt::format("it tells the score {} of {}, the problem {}", score_text(r.score),
                       station_text(r.best), score_text(terrain.score(r.best)));
  });
}

/// The first of the evaluated stations that is better than the best, by `better`.
template <class Better>
std::string overlooked(const Terrain& terrain, const Search& found, const Better& better) {
  for (const Station& s : found.asked) {
    const StationScore score = terrain.score(s);
    if (!better(score, found.result.score)) continue;
    return fmt::format("{} with {} was evaluated, but the best is told to be {} with {}", station_text(s),
                       score_text(score), station_text(found.result.best), score_text(found.result.score));
  }
  return "";
}

void x06_best_of_the_evaluated(Context& context) {
  for_searches(context, [](const Terrain& terrain, std::int64_t, const Search& found) {
    return overlooked(terrain, found,
                      [](const StationScore& a, const StationScore& b) { return a.first > b.first; });
  });
}

void x07_second_breaks_ties(Context& context) {
  for_searches(context, [](const Terrain& terrain, std::int64_t, const Search& found) {
    return overlooked(terrain, found, [](const StationScore& a, const StationScore& b) {
      return a.first == b.first && a.second > b.second;
    });
  });
}

void x08_tells_whether_the_budget_ended_it(Context& context) {
  const auto explorer = context.create<Explorer>();
  for_searches(context, [&](const Terrain& terrain, std::int64_t budget, const Search& found) -> std::string {
    const Search whole = search(*explorer, terrain, kAmple);
    const auto all = std::ssize(whole.asked), some = std::ssize(found.asked);
    if (all < kAmple && whole.result.budget_spent) {
      return fmt::format("it says that a budget of {} was spent, and asked for {} stations", kAmple, all);
    }
    // A search that needs just the budget may or may not know that it is at its own end.
    if (some == all && some == budget) return "";
    if (found.result.budget_spent == (some < all)) return "";
    return fmt::format("it says that the budget of {} was {}spent; with {} it asks for {} stations, not {}",
                       budget, found.result.budget_spent ? "" : "not ", kAmple, all, some);
  });
}

void x09_anytime(Context& context) {
  const auto explorer = context.create<Explorer>();
  auto blocks = searches(1, 400);
  blocks.push_back({"more", 1, 1, 300, {1, 2}, true});
  context.for_all(blocks, context.cases(400), [&](Case c) -> std::string {
    const Terrain terrain = terrain_of(c);
    const auto small = static_cast<std::int64_t>(c[kTerrainNumbers]),
               more = static_cast<std::int64_t>(c.back());
    const StationScore before = search(*explorer, terrain, small).result.score;
    const StationScore after = search(*explorer, terrain, small + more).result.score;
    if (!before.better_than(after)) return "";
    return fmt::format("a budget of {} finds {}, one of {} only {}", small, score_text(before), small + more,
                       score_text(after));
  });
}

void x10_exhausts_the_symbols(Context& context) {
  const auto explorer = context.create<Explorer>();
  context.for_all(terrain_blocks(), context.cases(60), [&](Case c) -> std::string {
    const Terrain terrain = terrain_of(c);
    const ExplorationResult found = search(*explorer, terrain, kAmple).result;
    for (const Station& s : terrain.symbol_grid()) {
      if (!terrain.score(s).better_than(found.score)) continue;
      return fmt::format("it found {}, but {} has {}", score_text(found.score), station_text(s),
                         score_text(terrain.score(s)));
    }
    return "";
  });
}

void x11_says_that_there_is_none(Context& context) {
  const auto explorer = context.create<Explorer>();
  for_searches(context, [&](const Terrain& given, std::int64_t budget, const Search&) -> std::string {
    Terrain terrain = given;
    terrain.barren = 1.1;
    const ExplorationResult found = search(*explorer, terrain, budget).result;
    const bool none = !found.score.feasible() && !std::isnan(found.score.first);
    return none ? ""
                : fmt::format("no station has a grasp, but it tells the score {}", score_text(found.score));
  });
}

void x12_ends_on_the_smallest_problems(Context& context) {
  const auto explorer = context.create<Explorer>();
  const std::vector<double> symbol_lists[] = {{}, {0.25}};
  for (const auto& symbols : symbol_lists) {
    for (const std::int64_t budget : {std::int64_t{1}, std::int64_t{2}, kAmple}) {
      const Terrain terrain{1, symbols, 0.25, 0.25, {0}, {0.0}, 1, 0.0, true};
      const Search found = search(*explorer, terrain, budget);
      for (const Station& s : found.asked) {
        context.require(belongs(s, terrain), "with one plane and one approach value, 0.25, it asked for {}",
                        station_text(s));
      }
      context.require(
          found.asked.empty() == !found.result.score.feasible(),
          "with one plane, {} symbols and a budget of {} it asked for {} stations and tells the score {}",
          symbols.size(), budget, found.asked.size(), score_text(found.result.score));
    }
  }
}

/// Notes what is wrong with what it is told.
class Listener final : public Progress {
 public:
  void advance(std::string_view stage, double fraction, std::string_view) override {
    if (stage.empty()) wrong = "a stage without a name";
    if (!(fraction <= 1.0)) wrong = fmt::format("the fraction {}", fraction);
  }
  std::string wrong;
};

void x13_tells_its_progress(Context& context) {
  const auto explorer = context.create<Explorer>();
  context.for_all(searches(1, 400), context.cases(50), [&](Case c) -> std::string {
    Listener listener;
    search(*explorer, terrain_of(c), static_cast<std::int64_t>(c[kTerrainNumbers]), &listener);
    return listener.wrong.empty() ? "" : fmt::format("it told its progress {}", listener.wrong);
  });
}

void x14_passes_the_problems_errors_on(Context& context) {
  const auto explorer = context.create<Explorer>();
  context.for_all(searches(1, 400), context.cases(50), [&](Case c) -> std::string {
    const Terrain terrain = terrain_of(c);
    const auto asked = std::ssize(search(*explorer, terrain, kAmple).asked);
    if (asked == 0) return "";
    Landscape landscape(terrain);
    const auto last = std::min<std::int64_t>(static_cast<std::int64_t>(c[kTerrainNumbers]), asked) - 1;
    landscape.fail_after(static_cast<std::size_t>(last));
    try {
      explorer->explore(landscape, kAmple, kSearchSeed, nullptr);
    } catch (const InputError& error) {
      return std::string_view(error.what()) == Landscape::kFailure
                 ? ""
                 : fmt::format("the problem's error came out as \"{}\"", error.what());
    }
    return fmt::format("the problem failed after {} stations and the search did not tell", last);
  });
}

void x15_gives_room_for_the_scores(Context& context) {
  for_searches(context, [](const Terrain&, std::int64_t, const Search& found) -> std::string {
    return found.wrong_size ? "it gave the problem another number of scores than of stations" : "";
  });
}

void x16_finds_something(Context& context) {
  const auto explorer = context.create<Explorer>();
  context.for_all(terrain_blocks(), context.cases(50), [&](Case c) -> std::string {
    Terrain terrain = terrain_of(c);
    terrain.barren = 0.0;
    if (terrain.symbols.empty()) terrain.symbols = {0.0};
    const Search found = search(*explorer, terrain, kAmple);
    if (found.result.score.feasible()) return "";
    return fmt::format("every station has a grasp, and of {} it found none", found.asked.size());
  });
}

constexpr Check kChecks[] = {
    {"X01", "explorer", "it never evaluates more stations than the budget", x01_keeps_to_the_budget},
    {"X02", "explorer", "with a budget of 0 it asks for nothing and finds nothing", x02_budget_of_none},
    {"X03", "explorer", "it tells the number of its evaluations truly", x03_counts_truly},
    {"X04", "explorer", "every station is in the problem's planes, approach bounds, finger counts and offsets",
     x04_asks_for_stations_of_the_problem},
    {"X05", "explorer", "the best is one of the evaluated stations, with the score that the problem gave",
     x05_best_was_evaluated},
    {"X06", "explorer", "no evaluated station has a higher first score than the best",
     x06_best_of_the_evaluated},
    {"X07", "explorer", "of stations with the same first score the second one decides",
     x07_second_breaks_ties},
    {"X08", "explorer", "it tells truly whether the budget ended it", x08_tells_whether_the_budget_ended_it},
    {"X09", "explorer", "declared anytime: a larger budget never gives a worse station", x09_anytime,
     "anytime"},
    {"X10", "explorer", "declared exhaustive: no station of the symbols' grid is better than what it found",
     x10_exhausts_the_symbols, "exhaustive"},
    {"X11", "explorer", "where no station has a grasp its result has none", x11_says_that_there_is_none},
    {"X12", "explorer", "one plane, one approach value, one symbol or none: it ends and tells the truth",
     x12_ends_on_the_smallest_problems},
    {"X13", "explorer", "the progress that it tells is a named stage and a share of one",
     x13_tells_its_progress},
    {"X14", "explorer", "an error of the problem comes out unchanged", x14_passes_the_problems_errors_on},
    {"X15", "explorer", "it gives the problem room for as many scores as it asks stations",
     x15_gives_room_for_the_scores},
    {"X16", "explorer", "where every station has a grasp it finds one", x16_finds_something},
};

}  // namespace

std::span<const Check> explorer_checks() {
  return kChecks;
}

}  // namespace preshape::conformance
