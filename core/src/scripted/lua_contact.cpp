#include <fmt/format.h>

#include "adapters.h"
#include "keys.h"
#include "preshape/base/error.h"
#include "preshape/base/require.h"
#include "preshape/contact/contact_limits.h"
#include "stack.h"
#include "state.h"

namespace preshape::scripted {

namespace {

enum Function { kBasis, kPattern, kPrimitives, kAdmits };

constexpr int kMostBasis = 64;

std::string text_of(const ContactFrame& C) {
  using scripted::text_of;
  return fmt::format("the contact with p = {}, n = {}, a = {}", text_of({C.p_OC.data(), 3}),
                     text_of({C.n.data(), 3}), text_of({C.a.data(), 3}));
}

/// A contact model whose basis and pattern are Lua.
class LuaContact : public ContactModel {
 public:
  LuaContact(const Value& instance, Blueprint blueprint)
      : owner_(blueprint.owner()), pool_(std::move(blueprint), {"basis", "pattern", "primitives", "admits"}) {
    auto size =
        ParameterDeclaration::integer("basis_size", 0, 1, kMostBasis, "-", "unit wrenches of one contact");
    size.default_value = Value{};
    const Keys keys{owner_, {size}, {"basis", "pattern"}, {"primitives", "admits"}, {}};
    basis_size_ = static_cast<int>(keys.check(instance, {}).integer("basis_size"));
    if ((instance.find("primitives") == nullptr) != (instance.find("admits") == nullptr)) {
      refuse(instance.place(), owner_, "'primitives' and 'admits' go together; give both or neither");
    }
  }

  int basis_size() const noexcept override { return basis_size_; }

  void wrench_basis(std::span<const ContactFrame> contacts, Eigen::Ref<WrenchBasis> basis) const override {
    const auto size = static_cast<std::size_t>(basis_size_);
    require_size("columns of the basis", contacts.size() * size, static_cast<std::size_t>(basis.cols()));
    require_finite(owner_, contacts);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const ContactTable table(L);
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        call(L, *state, kBasis, table, contacts[i], 0);
        read_wrenches(L, *state, kBasis, contacts[i],
                      basis.middleCols(static_cast<Eigen::Index>(i * size), basis_size_));
      }
    });
  }

  void pattern_wrenches(std::span<const ContactFrame> contacts, std::span<Wrench> F_C_O) const override {
    require_size("pattern wrenches", contacts.size(), F_C_O.size());
    require_finite(owner_, contacts);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const ContactTable table(L);
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        const int base = lua_gettop(L);
        state->count_anew();
        state->push(kPattern);
        table.push(contacts[i]);
        lua_call(L, 1, LUA_MULTRET);
        F_C_O[i] = read_pattern(L, *state, base, contacts[i]);
        lua_settop(L, base);
      }
    });
  }

 protected:
  /// Leaves the result on the stack.
  /// @param resolution second argument; 0: none
  static void call(lua_State* L, State& state, Function function, const ContactTable& table,
                   const ContactFrame& C, int resolution) {
    state.count_anew();
    state.push(function);
    table.push(C);
    if (resolution > 0) lua_pushinteger(L, resolution);
    lua_call(L, resolution > 0 ? 2 : 1, 1);
  }

  /// Reads the list of wrenches at the top and takes it off.
  static void read_wrenches(lua_State* L, State& state, Function function, const ContactFrame& C,
                            Eigen::Ref<WrenchBasis> wrenches) {
    const auto count = static_cast<std::size_t>(wrenches.cols());
    if (!lua_istable(L, -1) || lua_rawlen(L, -1) != count) {
      const std::string got = lua_istable(L, -1) ? fmt::format("{}", lua_rawlen(L, -1)) : told_of(L, -1);
      state.refuse_result(function, fmt::format("a list of {} wrenches, got {}", count, got), text_of(C));
    }
    for (std::size_t i = 0; i < count; ++i) {
      lua_rawgeti(L, -1, static_cast<lua_Integer>(i + 1));
      const std::string wrong = read_numbers(L, -1, {wrenches.col(static_cast<Eigen::Index>(i)).data(), 6});
      if (!wrong.empty()) {
        state.refuse_result(
            function, fmt::format("wrenches of 6 numbers; wrench {} must be {}", i + 1, wrong), text_of(C));
      }
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }

  std::string owner_;
  StatePool pool_;

 private:
  /// Six numbers, or one table of six, above `base`.
  static Wrench read_pattern(lua_State* L, State& state, int base, const ContactFrame& C) {
    Eigen::Matrix<double, 6, 1> numbers;
    const std::string wrong = read_results(L, base, {numbers.data(), 6});
    if (!wrong.empty()) state.refuse_result(kPattern, wrong, text_of(C));
    return Wrench::from_vector(numbers);
  }

  int basis_size_ = 0;
};

/// One that says what a contact can bear.
class LuaLimitedContact final : public LuaContact, public ContactLimits {
 public:
  using LuaContact::LuaContact;

  const void* extension(const char* id) const noexcept override {
    return std::string_view(id) == kId ? static_cast<const ContactLimits*>(this) : nullptr;
  }

  int primitive_count(int resolution) const noexcept override {
    try {
      return counted(resolution);
    } catch (const std::exception&) {
      return 0;  // primitive_wrenches tells the reason
    }
  }

  void primitive_wrenches(std::span<const ContactFrame> contacts, int resolution,
                          Eigen::Ref<WrenchBasis> wrenches) const override {
    if (resolution < 3)
      throw InputError(fmt::format("{}: the resolution must be at least 3, got {}", owner_, resolution));
    const auto each = static_cast<std::size_t>(counted(resolution));
    require_size("columns of the primitive wrenches", contacts.size() * each,
                 static_cast<std::size_t>(wrenches.cols()));
    require_finite(owner_, contacts);
    const StatePool::Lease state(pool_);
    state->host().enter([&](lua_State* L) {
      const ContactTable table(L);
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        call(L, *state, kPrimitives, table, contacts[i], resolution);
        read_wrenches(
            L, *state, kPrimitives, contacts[i],
            wrenches.middleCols(static_cast<Eigen::Index>(i * each), static_cast<Eigen::Index>(each)));
      }
    });
  }

  bool admits(const ContactFrame& C, const Wrench& F_C_O, double tolerance) const override {
    require_finite(owner_, {&C, 1});
    const Eigen::Matrix<double, 6, 1> wrench = F_C_O.vector();
    require_finite(owner_, "the wrench", {wrench.data(), 6});
    const StatePool::Lease state(pool_);
    bool admitted = false;
    state->host().enter([&](lua_State* L) {
      const ContactTable table(L);
      state->push(kAdmits);
      table.push(C);
      push_numbers(L, {wrench.data(), 6});
      lua_pushnumber(L, tolerance);
      lua_call(L, 3, 1);
      if (!lua_isboolean(L, -1))
        state->refuse_result(kAdmits, "true or false, got " + told_of(L, -1), text_of(C));
      admitted = lua_toboolean(L, -1) != 0;
    });
    return admitted;
  }

 private:
  /// How many there are of a contact at the origin: the same for every contact.
  int counted(int resolution) const {
    const StatePool::Lease state(pool_);
    int count = 0;
    state->host().enter([&](lua_State* L) {
      const ContactTable table(L);
      const ContactFrame C = ContactFrame::at({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
      call(L, *state, kPrimitives, table, C, resolution);
      count = lua_istable(L, -1) ? static_cast<int>(lua_rawlen(L, -1)) : 0;
      if (count == 0)
        state->refuse_result(kPrimitives, "a list of wrenches, got " + told_of(L, -1), text_of(C));
    });
    return count;
  }
};

}  // namespace

std::shared_ptr<ContactModel> make_contact(Blueprint blueprint) {
  const Value instance = inspect(blueprint);
  if (instance.find("primitives")) return std::make_shared<LuaLimitedContact>(instance, std::move(blueprint));
  return std::make_shared<LuaContact>(instance, std::move(blueprint));
}

}  // namespace preshape::scripted
