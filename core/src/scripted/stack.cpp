#include "stack.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape::scripted {

void refill(lua_State* L, int table, std::span<const double> numbers) {
  lua_Integer i = 0;
  for (const double number : numbers) {
    lua_pushnumber(L, number);
    lua_rawseti(L, table, ++i);
  }
}

void refill(lua_State* L, int table, const Eigen::Vector3d& vector) {
  refill(L, table, std::span(vector.data(), 3));
}

void push_numbers(lua_State* L, std::span<const double> numbers) {
  lua_createtable(L, static_cast<int>(numbers.size()), 0);
  refill(L, lua_gettop(L), numbers);
}

void push_rows(
    lua_State* L,
    const Eigen::Ref<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>& rows) {
  lua_createtable(L, static_cast<int>(rows.rows()), 0);
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    lua_createtable(L, static_cast<int>(rows.cols()), 0);
    for (Eigen::Index c = 0; c < rows.cols(); ++c) {
      lua_pushnumber(L, rows(r, c));
      lua_rawseti(L, -2, c + 1);
    }
    lua_rawseti(L, -2, r + 1);
  }
}

ContactTable::ContactTable(lua_State* L) : L_(L), table_(lua_gettop(L) + 1) {
  if (!lua_checkstack(L, 20)) throw ScriptError("calls go too deep");
  lua_createtable(L, 0, 4);
  for (int i = 0; i < 4; ++i) lua_createtable(L, 3, 0);
}

void ContactTable::push(const ContactFrame& C) const {
  const Eigen::Vector3d* const vectors[] = {&C.p_OC, &C.n, &C.a, &C.t};
  static constexpr const char* kNames[] = {"p", "n", "a", "t"};
  for (int i = 0; i < 4; ++i) {
    refill(L_, table_ + 1 + i, *vectors[i]);
    lua_pushvalue(L_, table_ + 1 + i);
    lua_setfield(L_, table_, kNames[i]);
  }
  lua_pushvalue(L_, table_);
}

void push_contacts(lua_State* L, std::span<const ContactFrame> contacts) {
  lua_createtable(L, static_cast<int>(contacts.size()), 0);
  const int list = lua_gettop(L);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactTable table(L);  // of its own: a list holds them all at once
    table.push(contacts[i]);
    lua_rawseti(L, list, static_cast<lua_Integer>(i + 1));
    lua_settop(L, list);
  }
}

std::string told_of(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) return "number " + number_text(lua_tonumber(L, index));
  if (lua_type(L, index) == LUA_TSTRING) return fmt::format("text '{}'", lua_tostring(L, index));
  return luaL_typename(L, index);
}

std::string read_number(lua_State* L, int index, double& number) {
  number = lua_type(L, index) == LUA_TNUMBER ? lua_tonumber(L, index) : std::nan("");
  return std::isfinite(number) ? "" : "a finite number, got " + told_of(L, index);
}

std::string read_numbers(lua_State* L, int index, std::span<double> numbers) {
  const auto expected = [&](const std::string& got) {
    return fmt::format("a list of {} finite numbers, got {}", numbers.size(), got);
  };
  if (!lua_istable(L, index)) return expected(told_of(L, index));
  if (const auto length = lua_rawlen(L, index); length > numbers.size())
    return expected(fmt::format("{} items", length));
  index = lua_absindex(L, index);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(i + 1));
    const bool finite = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(numbers[i] = lua_tonumber(L, -1));
    if (!finite) return expected(fmt::format("item {} = {}", i + 1, told_of(L, -1)));
    lua_pop(L, 1);
  }
  return "";
}

std::string read_results(lua_State* L, int base, std::span<double> numbers) {
  const int count = lua_gettop(L) - base;
  if (count != static_cast<int>(numbers.size()) || lua_istable(L, base + 1)) {
    lua_settop(L, base + 1);
    return read_numbers(L, base + 1, numbers);
  }
  std::string wrong;
  for (int i = 0; i < count && wrong.empty(); ++i) {
    wrong = read_number(L, base + 1 + i, numbers[static_cast<std::size_t>(i)]);
  }
  return wrong;
}

bool settle(double& number, double lowest, double highest) {
  if (number >= lowest && number <= highest) return true;
  const double size = std::max({1.0, std::isfinite(lowest) ? std::abs(lowest) : 0.0,
                                std::isfinite(highest) ? std::abs(highest) : 0.0});
  const double rounding = 1e-9 * std::min(size, highest - lowest);
  if (!(number >= lowest - rounding && number <= highest + rounding)) return false;
  number = std::clamp(number, lowest, highest);
  return true;
}

void require_finite(const std::string& owner, std::string_view what, std::span<const double> numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) return;
  throw InputError(fmt::format("{}: {} must be finite, got {}", owner, what, text_of(numbers)));
}

void require_finite(const std::string& owner, std::span<const ContactFrame> contacts) {
  for (const ContactFrame& C : contacts) {
    const std::pair<const char*, const Eigen::Vector3d*> vectors[] = {{"p of a contact", &C.p_OC},
                                                                      {"n of a contact", &C.n},
                                                                      {"a of a contact", &C.a},
                                                                      {"t of a contact", &C.t}};
    for (const auto& [what, vector] : vectors) require_finite(owner, what, {vector->data(), 3});
  }
}

std::string text_of(std::span<const double> numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
  return "(" + text + ")";
}

}  // namespace preshape::scripted
