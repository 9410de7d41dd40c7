#include <limits>

#include <fmt/format.h>

#include "adapters.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kEvaluate };

std::vector<QualityNumber> read_quality_numbers(const Value& list, const SourcePlace& place,
                                                const std::string& owner) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!list.is_list() || list.items().empty())
    refuse(place, owner, "'numbers' must be a list of at least one number's table");
  std::vector<QualityNumber> numbers;
  for (const Value& table : list.items()) {
    const std::string what = fmt::format("{}, number {}", owner, numbers.size() + 1);
    const Keys keys{
        what,
        {required_text("name", "of the number"), ParameterDeclaration::label("unit", "-", "of the number"),
         required_number("lowest", -kInfinity, kInfinity, "-", "smallest value"),
         required_number("highest", -kInfinity, kInfinity, "-", "largest value"),
         ParameterDeclaration::flag("higher_is_better", true, "or lower")},
        {},
        {},
        {}};
    const Parameters p = keys.check(table, place);
    QualityNumber number{p.text("name"), p.text("unit"), p.number("lowest"), p.number("highest"),
                         p.flag("higher_is_better")};
    if (!(number.lowest < number.highest))
      refuse(place_of(table, place), what, "'lowest' must be below 'highest'");
    for (const auto& other : numbers) {
      if (other.name == number.name)
        refuse(place_of(table, place), what, fmt::format("'{}' is there twice", number.name));
    }
    numbers.push_back(std::move(number));
  }
  return numbers;
}

/// A quality measure whose evaluate is Lua.
class LuaQuality final : public QualityMeasure {
 public:
  LuaQuality(const Value& instance, Blueprint blueprint) : pool_(std::move(blueprint), {"evaluate"}) {
    const std::string owner = pool_.blueprint().owner();
    const Keys keys{owner, {required_table("numbers", "what evaluate gives")}, {"evaluate"}, {}, {}};
    const Value numbers = keys.check(instance, {}).value("numbers");
    numbers_ = read_quality_numbers(numbers, place_of(numbers, instance.place()), owner);
  }

  std::span<const QualityNumber> numbers() const noexcept override { return numbers_; }

  void evaluate(const GraspView& grasp, std::span<double> values) const override {
    require_size("values", numbers_.size(), values.size());
    check_finite(grasp);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const int base = lua_gettop(L);
      state->push(kEvaluate);
      push_grasp(L, grasp);
      lua_call(L, 1, LUA_MULTRET);
      std::string wrong = read_results(L, base, values);
      for (std::size_t i = 0; wrong.empty() && i < values.size(); ++i) wrong = beyond(numbers_[i], values[i]);
      if (!wrong.empty()) state->refuse_result(kEvaluate, wrong, grasp_text(grasp));
    });
  }

 private:
  void check_finite(const GraspView& grasp) const {
    const std::string owner = pool_.blueprint().owner();
    require_finite(owner, grasp.contacts);
    for (const Wrench& F : grasp.F_C_O) require_finite(owner, "a wrench", {F.vector().eval().data(), 6});
    require_finite(owner, "the wrench union",
                   {grasp.wrench_union.data(), static_cast<std::size_t>(grasp.wrench_union.size())});
    require_finite(owner, "the resultant", {grasp.resultant.vector().eval().data(), 6});
    require_finite(owner, "the length", {&grasp.length_m, 1});
  }

  static void push_grasp(lua_State* L, const GraspView& grasp) {
    if (!lua_checkstack(L, 20)) throw ScriptError("calls go too deep");
    lua_createtable(L, 0, 7);
    push_contacts(L, grasp.contacts);
    lua_setfield(L, -2, "contacts");
    lua_createtable(L, static_cast<int>(grasp.F_C_O.size()), 0);
    for (std::size_t i = 0; i < grasp.F_C_O.size(); ++i) {
      const Eigen::Matrix<double, 6, 1> wrench = grasp.F_C_O[i].vector();
      push_numbers(L, {wrench.data(), 6});
      lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    lua_setfield(L, -2, "wrenches");
    push_rows(L, grasp.wrench_union);
    lua_setfield(L, -2, "wrench_union");
    const Eigen::Matrix<double, 6, 1> resultant = grasp.resultant.vector();
    push_numbers(L, {resultant.data(), 6});
    lua_setfield(L, -2, "resultant");
    lua_pushnumber(L, grasp.length_m);
    lua_setfield(L, -2, "length");
    push_axis(L, "approach", grasp.approach_O);
    push_axis(L, "opposition", grasp.opposition_O);
  }

  /// Left out where it is not known.
  static void push_axis(lua_State* L, const char* key, const Eigen::Vector3d& axis) {
    if (!axis.allFinite()) return;
    push_numbers(L, {axis.data(), 3});
    lua_setfield(L, -2, key);
  }

  static std::string grasp_text(const GraspView& grasp) {
    const Eigen::Matrix<double, 6, 1> resultant = grasp.resultant.vector();
    return fmt::format("the grasp of {} contacts with resultant {}", grasp.contacts.size(),
                       text_of(std::span<const double>(resultant.data(), 6)));
  }

  /// "" when the value is in its range.
  static std::string beyond(const QualityNumber& number, double& value) {
    if (settle(value, number.lowest, number.highest)) return "";
    return fmt::format("'{}' in {} .. {}, got {}", number.name, number_text(number.lowest),
                       number_text(number.highest), number_text(value));
  }

  StatePool pool_;
  std::vector<QualityNumber> numbers_;
};

}  // namespace

std::shared_ptr<QualityMeasure> make_quality(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  return std::make_shared<LuaQuality>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
