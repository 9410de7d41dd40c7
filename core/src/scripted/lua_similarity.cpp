#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "adapters.h"
#include "keys.h"
#include "pattern_table.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kWhole, kPart, kParts, kScale };

constexpr auto kCount = static_cast<std::size_t>(kComponents);

std::string inputs_text(const PatternView& task, const PatternView& pattern) {
  return fmt::format("task {} and pattern {}", text_of({task.crisp, kCount}),
                     text_of({pattern.crisp, kCount}));
}

/// A measure whose compare, or component, is Lua.
class LuaSimilarity final : public Similarity {
 public:
  explicit LuaSimilarity(Blueprint blueprint)
      : owner_(blueprint.owner()),
        instance_(inspect(blueprint)),
        pool_(std::move(blueprint), {"compare", "component", "components", "scale"}) {
    check_keys();
    additive_ = instance_.find("component") != nullptr;
    explained_ = instance_.find("components") != nullptr;
    asked_ = instance_.find("scale")->is_function();
    if (!asked_)
      scale_ = scale_of(*instance_.find("scale"));
    else
      ask_scale(kProbeSets);
  }

  SimilarityScale scale(int sets) const noexcept override {
    if (!asked_) return scale_;
    try {
      return ask_scale(sets);
    } catch (const std::exception&) {
      // compare tells the reason; whoever asks for the scale alone sees that there is none.
      return {std::nan(""), std::nan("")};
    }
  }

  void compare(const PatternView& task, const PatternView& patterns,
               std::span<double> scores) const override {
    require_size("scores", static_cast<std::size_t>(patterns.count), scores.size());
    require_size("fuzzy sets of the patterns", static_cast<std::size_t>(task.sets),
                 static_cast<std::size_t>(patterns.sets));
    check_finite("task", task);
    check_finite("pattern", patterns);
    const SimilarityScale scale = asked_ ? ask_scale(task.sets) : scale_;
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const Tables tables(L, task, additive_);
      for (int i = 0; i < patterns.count; ++i) {
        state->count_anew();
        const PatternView pattern = patterns[i];
        const double score =
            additive_ ? sum(L, *state, tables, task, pattern) : whole(L, *state, tables, task, pattern);
        scores[static_cast<std::size_t>(i)] = within(*state, scale, score, task, pattern);
      }
    });
  }

  void component_scores(const PatternView& task, const PatternView& pattern,
                        std::span<double, kComponents> scores) const override {
    require_size("fuzzy sets of the pattern", static_cast<std::size_t>(task.sets),
                 static_cast<std::size_t>(pattern.sets));
    check_finite("task", task);
    check_finite("pattern", pattern);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const Tables tables(L, task, additive_);
      if (additive_) return parts(L, *state, tables, task, pattern, scores);
      if (explained_) return explained(L, *state, tables, task, pattern, scores);
      for (int k = 0; k < kComponents; ++k) {
        state->count_anew();
        tables.task.fill(task, k);
        scores[static_cast<std::size_t>(k)] = whole(L, *state, tables, task, pattern, k);
      }
    });
  }

 private:
  static constexpr int kProbeSets = 7;

  struct Tables {
    Tables(lua_State* L, const PatternView& view, bool by_component)
        : task(L, view.sets), pattern(L, view.sets) {
      if (!by_component) task.fill(view);
      for (std::size_t k = 0; by_component && k < kCount; ++k) task.fill_component(view, k);
    }
    PatternTable task, pattern;
  };

  void check_finite(const char* what, const PatternView& view) const {
    for (int i = 0; i < view.count; ++i) {
      const PatternView one = view[i];
      require_finite(owner_, what, {one.crisp, kCount});
      for (std::size_t k = 0; k < kCount; ++k) {
        const auto sets = static_cast<std::size_t>(view.sets);
        require_finite(owner_, "memberships", {one.memberships + k * sets, sets});
      }
    }
  }

  void check_keys() const {
    const Keys keys{owner_, {}, {}, {"compare", "component", "components"}, {"scale"}};
    keys.check(instance_, {});
    const SourcePlace& place = instance_.place();
    const bool whole = instance_.find("compare"), part = instance_.find("component");
    if (whole == part)
      refuse(place, owner_, "it needs one of the functions 'compare' and 'component', and only one");
    if (part && instance_.find("components")) {
      refuse(place, owner_, "'components' goes with 'compare'; 'component' tells them already");
    }
    if (!instance_.find("scale")) {
      refuse(place, owner_,
             "'scale' is missing; give { farthest = 0, nearest = 1 } or a function of the number of sets");
    }
  }

  SimilarityScale scale_of(const Value& value) const {
    const double most = std::numeric_limits<double>::infinity();
    const Keys keys{owner_ + ", scale",
                    {required_number("farthest", -most, most, "-", "score of what is farthest"),
                     required_number("nearest", -most, most, "-", "score of what is nearest")},
                    {},
                    {},
                    {}};
    const Parameters p = keys.check(value, instance_.place());
    const SimilarityScale scale{p.number("farthest"), p.number("nearest")};
    if (scale.farthest == scale.nearest)
      refuse(place_of(value, instance_.place()), owner_, "'scale' has no length");
    return scale;
  }

  SimilarityScale ask_scale(int sets) const {
    const StatePool::Lease state(pool_);
    SimilarityScale scale;
    state->host().enter([&](lua_State* L) {
      state->push(kScale);
      lua_pushinteger(L, sets);
      lua_call(L, 1, 1);
      const std::string input = fmt::format("{} sets", sets);
      if (!lua_istable(L, -1)) state->refuse_result(kScale, "a table, got " + told_of(L, -1), input);
      double* const ends[] = {&scale.farthest, &scale.nearest};
      const char* const names[] = {"farthest", "nearest"};
      for (int i = 0; i < 2; ++i) {
        lua_getfield(L, -1, names[i]);
        const bool number = lua_type(L, -1) == LUA_TNUMBER && !std::isnan(*ends[i] = lua_tonumber(L, -1));
        if (!number)
          state->refuse_result(kScale, fmt::format("a number '{}', got {}", names[i], told_of(L, -1)), input);
        lua_pop(L, 1);
      }
    });
    return scale;
  }

  double whole(lua_State* L, State& state, const Tables& tables, const PatternView& task,
               const PatternView& pattern, int only = -1) const {
    tables.pattern.fill(pattern, only);
    state.push(kWhole);
    tables.task.push_whole();
    tables.pattern.push_whole();
    return called(L, state, kWhole, 2, task, pattern);
  }

  double called(lua_State* L, State& state, Function function, int arguments, const PatternView& task,
                const PatternView& pattern) const {
    lua_call(L, arguments, 1);
    double score = 0.0;
    if (const std::string wrong = read_number(L, -1, score); !wrong.empty()) {
      state.refuse_result(function, wrong, inputs_text(task, pattern));
    }
    lua_pop(L, 1);
    return score;
  }

  void parts(lua_State* L, State& state, const Tables& tables, const PatternView& task,
             const PatternView& pattern, std::span<double, kComponents> scores) const {
    for (std::size_t k = 0; k < kCount; ++k) {
      tables.pattern.fill_component(pattern, k);
      state.push(kPart);
      tables.task.push_component(k);
      tables.pattern.push_component(k);
      scores[k] = called(L, state, kPart, 2, task, pattern);
    }
  }

  /// In the order of AdditiveSimilarity, so that a twin in C++ has the same bits.
  double sum(lua_State* L, State& state, const Tables& tables, const PatternView& task,
             const PatternView& pattern) const {
    double scores[kCount];
    parts(L, state, tables, task, pattern, scores);
    double total = 0.0;
    for (const double score : scores) total += score;
    return total;
  }

  void explained(lua_State* L, State& state, const Tables& tables, const PatternView& task,
                 const PatternView& pattern, std::span<double, kComponents> scores) const {
    tables.pattern.fill(pattern);
    state.push(kParts);
    tables.task.push_whole();
    tables.pattern.push_whole();
    lua_call(L, 2, 1);
    if (const std::string wrong = read_numbers(L, -1, scores); !wrong.empty()) {
      state.refuse_result(kParts, wrong, inputs_text(task, pattern));
    }
  }

  double within(State& state, const SimilarityScale& scale, double score, const PatternView& task,
                const PatternView& pattern) const {
    const auto [low, high] = std::minmax(scale.farthest, scale.nearest);
    if (settle(score, low, high)) return score;
    state.refuse_result(
        additive_ ? kPart : kWhole,
        fmt::format("scores {}within its scale {} .. {}, got {}", additive_ ? "whose sum lies " : "",
                    number_text(low), number_text(high), number_text(score)),
        inputs_text(task, pattern));
  }

  std::string owner_;
  Value instance_;
  StatePool pool_;
  bool additive_ = false, explained_ = false, asked_ = false;
  SimilarityScale scale_;
};

}  // namespace

std::shared_ptr<Similarity> make_similarity(Blueprint blueprint) {
  return std::make_shared<LuaSimilarity>(std::move(blueprint));
}

}  // namespace preshape::scripted
