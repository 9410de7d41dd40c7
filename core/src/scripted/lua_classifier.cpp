#include <atomic>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "adapters.h"
#include "keys.h"
#include "lua_classifier_state.h"
#include "preshape/base/error.h"
#include "script/convert.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kFit, kExtend, kPredict };

using Rows = Eigen::Ref<const RowMatrix>;

/// Every model that was ever learned or loaded has its own number, so that a state knows whether it has it as
/// Lua.
std::uint64_t next_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// What `fit` says of how it ended; all of it may be left out.
TrainingOutcome outcome_of(const Value& table, const SourcePlace& place, const std::string& owner,
                           const TrainingOutcome& measured) {
  if (table.is_nil()) return measured;
  const std::string standard = measured.status == TrainingOutcome::Status::kArrived ? "arrived" : "stalled";
  const Keys keys{owner + ", outcome",
                  {ParameterDeclaration::choice("status", standard, {"arrived", "stalled"}, "how it ended"),
                   ParameterDeclaration::integer("epochs", 0, 0, 1e15, "-", "passes over the rows"),
                   ParameterDeclaration::integer("restarts", 0, 0, 1e15, "-", "runs begun anew"),
                   ParameterDeclaration::number("mean_squared_error", measured.mean_squared_error, 0.0, 1.0,
                                                "-", "over rows and bits"),
                   ParameterDeclaration::integer("wrong_rows", measured.wrong_rows, 0, 1e15, "-",
                                                 "rows with a wrong bit")},
                  {},
                  {},
                  {}};
  const Parameters p = keys.check(table, place);
  return {
      p.text("status") == "arrived" ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled,
      p.integer("epochs"), p.integer("restarts"), p.number("mean_squared_error"), p.integer("wrong_rows")};
}

/// A classifier whose fit and predict are Lua. What it has learned is data, the same for all its states.
class LuaClassifier final : public Classifier {
 public:
  LuaClassifier(const Value& instance, Blueprint blueprint)
      : owner_(blueprint.owner()),
        extends_(instance.find("extend") != nullptr),
        pool_(std::move(blueprint), {"fit", "extend", "predict"}, Chance::kSeeded) {
    Keys{owner_, {}, {"fit", "predict"}, {"extend"}, {}}.check(instance, {});
  }

  TrainingOutcome fit(const Rows& inputs, const Rows& targets, std::uint64_t seed,
                      Progress* progress) override {
    check_rows(inputs, targets);
    return learn(kFit, inputs, targets, 0, seed, progress);
  }

  TrainingOutcome extend(const Rows& inputs, const Rows& targets, std::int64_t first_new, std::uint64_t seed,
                         Progress* progress) override {
    check_rows(inputs, targets);
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError(
          fmt::format("{}: the first new row must be in 0 .. {}, got {}", owner_, inputs.rows(), first_new));
    }
    const bool same = learned_ && inputs.cols() == learned_->features && targets.cols() == learned_->bits;
    return learn(extends_ && same ? kExtend : kFit, inputs, targets, first_new, seed, progress);
  }

  bool trained() const noexcept override { return learned_.has_value(); }

  void predict(const Rows& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (!learned_) throw InputError(fmt::format("{} has learned nothing yet; fit it first", owner_));
    if (inputs.cols() != learned_->features || bits.cols() != learned_->bits ||
        bits.rows() != inputs.rows()) {
      throw InputError(fmt::format(
          "{} has learned {} inputs and {} bits, but is asked with {} x {} inputs for {} x {} bits", owner_,
          learned_->features, learned_->bits, inputs.rows(), inputs.cols(), bits.rows(), bits.cols()));
    }
    ask(*learned_, version_, inputs, bits);
  }

  std::string save() const override {
    if (!learned_)
      throw InputError(fmt::format("{} has learned nothing that could be saved; fit it first", owner_));
    return model_text(pool_.blueprint().name, *learned_);
  }

  void load(std::string_view state) override {
    learned_ = model_from(pool_.blueprint().name, state);
    version_ = next_version();
  }

 private:
  void check_rows(const Rows& inputs, const Rows& targets) const {
    if (inputs.rows() < 1)
      throw InputError(fmt::format("{}: there are no rows to learn; give at least one", owner_));
    if (inputs.rows() != targets.rows() || inputs.cols() < 1 || targets.cols() < 1) {
      throw InputError(fmt::format(
          "{}: {} x {} inputs do not go with {} x {} targets; give one row of targets to each row of inputs",
          owner_, inputs.rows(), inputs.cols(), targets.rows(), targets.cols()));
    }
    check_finite(inputs);
    for (Eigen::Index r = 0; r < targets.rows(); ++r) {
      for (Eigen::Index k = 0; k < targets.cols(); ++k) {
        if (targets(r, k) == 0.0 || targets(r, k) == 1.0) continue;
        throw InputError(fmt::format("{}: target {} of row {} must be 0 or 1, got {}", owner_, k + 1, r + 1,
                                     number_text(targets(r, k))));
      }
    }
  }

  void check_finite(const Rows& inputs) const {
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      if (!inputs.row(r).allFinite()) {
        throw InputError(fmt::format("{}: row {} holds a number that is not finite", owner_, r + 1));
      }
    }
  }

  TrainingOutcome learn(Function function, const Rows& inputs, const Rows& targets, std::int64_t first_new,
                        std::uint64_t seed, Progress* progress) {
    if (progress) progress->advance("training", -1.0, "");
    LearnedModel learned{{}, static_cast<int>(inputs.cols()), static_cast<int>(targets.cols())};
    Value told;
    SourcePlace place;
    {
      const StatePool::Lease state(pool_);
      state->enter_long([&](lua_State* L) {
        if (!lua_checkstack(L, 20)) throw ScriptError("calls go too deep");
        state->seed(L, seed);
        state->push(function);
        place = definition(L, -1);
        if (function == kExtend) lua::push_value(L, learned_->model);
        push_rows(L, inputs);
        push_rows(L, targets);
        if (function == kExtend) lua_pushinteger(L, first_new + 1);
        lua_pushinteger(L, static_cast<lua_Integer>(seed));
        lua_call(L, function == kExtend ? 5 : 3, 2);
        if (lua_isnil(L, -2)) state->refuse_result(function, "a model, got nil", "");
        learned.model = lua::to_value(L, -2, place);
        told = lua::to_value(L, -1, place);
      });
    }
    refuse_functions(learned.model, place);
    // Asking it once for what it was taught shows that the model serves, before the old one is given up.
    const std::uint64_t version = next_version();
    RowMatrix bits(targets.rows(), targets.cols());
    ask(learned, version, inputs, bits);
    const TrainingOutcome outcome = outcome_of(told, place, owner_, measure(bits, targets));
    learned_ = std::move(learned);
    version_ = version;
    return outcome;
  }

  void refuse_functions(const Value& value, const SourcePlace& place) const {
    if (value.is_function())
      refuse(place_of(value, place), owner_, "a model is plain data, but it holds a function");
    if (value.is_list()) {
      for (const Value& item : value.items()) refuse_functions(item, place);
    } else if (value.is_table()) {
      for (const auto& [key, entry] : value.entries()) refuse_functions(entry, place);
    }
  }

  static TrainingOutcome measure(const RowMatrix& bits, const Rows& targets) {
    TrainingOutcome outcome;
    outcome.mean_squared_error = (bits - targets).squaredNorm() / static_cast<double>(bits.size());
    for (Eigen::Index r = 0; r < bits.rows(); ++r) {
      if (((bits.row(r) - targets.row(r)).array().abs() >= 0.5).any()) ++outcome.wrong_rows;
    }
    outcome.status =
        outcome.wrong_rows == 0 ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    return outcome;
  }

  /// Leaves the model on the stack; a state makes a model's table once.
  static void push_model(lua_State* L, State& state, const LearnedModel& learned, std::uint64_t version) {
    if (state.kept_version != version) {
      luaL_unref(L, LUA_REGISTRYINDEX, state.kept_reference);
      state.kept_version = 0;
      state.kept_reference = LUA_NOREF;
      lua::push_value(L, learned.model);
      state.kept_reference = luaL_ref(L, LUA_REGISTRYINDEX);
      state.kept_version = version;
    }
    lua_rawgeti(L, LUA_REGISTRYINDEX, state.kept_reference);
  }

  void ask(const LearnedModel& learned, std::uint64_t version, const Rows& inputs,
           Eigen::Ref<RowMatrix> bits) const {
    check_finite(inputs);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      state->seed(L, 0);
      push_model(L, *state, learned, version);
      const int base = lua_gettop(L);
      for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
        const std::span<const double> row(inputs.row(r).data(), static_cast<std::size_t>(inputs.cols()));
        state->count_anew();
        state->push(kPredict);
        lua_pushvalue(L, base);
        push_numbers(L, row);
        lua_call(L, 2, LUA_MULTRET);
        const std::span<double> answer(bits.row(r).data(), static_cast<std::size_t>(bits.cols()));
        std::string wrong = read_results(L, base, answer);
        for (std::size_t k = 0; wrong.empty() && k < answer.size(); ++k) {
          if (!settle(answer[k], 0.0, 1.0))
            wrong = fmt::format("probabilities in 0 .. 1, got {}", number_text(answer[k]));
        }
        if (!wrong.empty()) state->refuse_result(kPredict, wrong, "the input " + text_of(row));
        lua_settop(L, base);
      }
    });
  }

  std::string owner_;
  bool extends_;
  StatePool pool_;
  std::optional<LearnedModel> learned_;
  std::uint64_t version_ = 0;
};

}  // namespace

std::shared_ptr<Classifier> make_classifier(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  return std::make_shared<LuaClassifier>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
