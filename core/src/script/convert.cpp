#include "convert.h"

#include <algorithm>

#include <fmt/format.h>

#include "host.h"
#include "preshape/base/error.h"

namespace preshape::lua {

namespace {

constexpr std::size_t kMaximumDepth = 100;
constexpr std::size_t kMaximumCount = 2'000'000;  // values; a table that stands in many places counts in each

/// The place of a value, and whether it is that of its own key rather than of something around it.
struct Where {
  SourcePlace place;
  bool exact = false;
};

/// The keys of a table, counted and sorted.
struct Keys {
  lua_Integer positional = 0;  ///< how many
  lua_Integer highest = 0;     ///< of the positional ones
  std::vector<std::string> names;
};

class Reader {
 public:
  explicit Reader(lua_State* L) : L_(L), host_(host_of(L)) {}

  Value read(int index, const Where& where) {
    index = lua_absindex(L_, index);
    if (++count_ > kMaximumCount) fail(where.place, fmt::format("more than {} values", kMaximumCount));
    Value value = lua_istable(L_, index) ? Value{} : read_plain(index, where.place);
    if (lua_istable(L_, index)) return read_table(index, where);
    value.at(where.place);
    return value;
  }

 private:
  Value read_plain(int index, const SourcePlace& place) {
    switch (lua_type(L_, index)) {
      case LUA_TNIL:
        return {};
      case LUA_TBOOLEAN:
        return lua_toboolean(L_, index) != 0;
      case LUA_TNUMBER:
        if (lua_isinteger(L_, index)) return std::int64_t{lua_tointeger(L_, index)};
        return lua_tonumber(L_, index);
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* text = lua_tolstring(L_, index, &size);
        return std::string(text, size);
      }
      case LUA_TFUNCTION:
        return function(index);
      default:
        fail(place, fmt::format("a {} is not data", luaL_typename(L_, index)));
    }
  }

  /// Each function has one number in the life of its script.
  Value::Function function(int index) {
    push_anchor(L_, Anchor::kFunctionNumbers);
    lua_pushvalue(L_, index);
    lua_rawget(L_, -2);
    auto number = lua_tointeger(L_, -1);
    lua_pop(L_, 1);
    if (number == 0) {
      push_anchor(L_, Anchor::kFunctions);
      number = static_cast<lua_Integer>(lua_rawlen(L_, -1)) + 1;
      lua_pushvalue(L_, index);
      lua_rawseti(L_, -2, number);
      lua_pop(L_, 1);
      lua_pushvalue(L_, index);
      lua_pushinteger(L_, number);
      lua_rawset(L_, -3);
    }
    lua_pop(L_, 1);
    return {static_cast<int>(number)};
  }

  Value read_table(int index, const Where& where) {
    if (!lua_checkstack(L_, 8) || open_.size() >= kMaximumDepth) {
      fail(where.place, fmt::format("tables in tables more than {} deep", kMaximumDepth));
    }
    const void* self = lua_topointer(L_, index);
    if (std::find(open_.begin(), open_.end(), self) != open_.end())
      fail(where.place, "the table contains itself");
    const TablePlaces* page = page_of(index);
    const SourcePlace place = !where.exact && page ? page->place : where.place;
    open_.push_back(self);
    const Keys keys = keys_of(index, place);
    Value value =
        keys.names.empty() ? read_list(index, keys, page, place) : read_named(index, keys, page, place);
    open_.pop_back();
    value.at(place);
    return value;
  }

  const TablePlaces* page_of(int index) {
    push_anchor(L_, Anchor::kPages);
    lua_pushvalue(L_, index);
    lua_rawget(L_, -2);
    const long page = lua_isinteger(L_, -1) ? static_cast<long>(lua_tointeger(L_, -1)) : -1;
    lua_pop(L_, 2);
    return host_.places.page(page);
  }

  Keys keys_of(int index, const SourcePlace& place) {
    Keys keys;
    for (lua_pushnil(L_); lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      if (lua_type(L_, -2) == LUA_TSTRING) {
        std::size_t size = 0;
        const char* name = lua_tolstring(L_, -2, &size);
        keys.names.emplace_back(name, size);
      } else if (lua_isinteger(L_, -2) && lua_tointeger(L_, -2) > 0) {
        ++keys.positional;
        keys.highest = std::max(keys.highest, lua_tointeger(L_, -2));
      } else {
        fail(place, fmt::format("a key must be a name or a position from 1, got a {}", key_text()));
      }
    }
    std::sort(keys.names.begin(), keys.names.end());
    return keys;
  }

  /// The key below the top, for a message.
  std::string key_text() {
    if (lua_isinteger(L_, -2)) return fmt::format("number {}", lua_tointeger(L_, -2));
    if (lua_type(L_, -2) == LUA_TNUMBER) return fmt::format("number {}", number_text(lua_tonumber(L_, -2)));
    return luaL_typename(L_, -2);
  }

  Value read_list(int index, const Keys& keys, const TablePlaces* page, const SourcePlace& place) {
    if (keys.highest != keys.positional) {
      lua_Integer hole = 1;
      while (lua_rawgeti(L_, index, hole) != LUA_TNIL) lua_pop(L_, 1), ++hole;
      fail(place, fmt::format("the list has no item {} but an item {}", hole, keys.highest));
    }
    Value::List items;
    for (lua_Integer i = 1; i <= keys.highest; ++i) {
      const auto k = static_cast<std::size_t>(i - 1);
      const bool known = page && k < page->items.size() && page->items[k].known();
      const Step step(*this, {{}, i});
      lua_rawgeti(L_, index, i);
      items.push_back(read(-1, known ? Where{page->items[k], true} : Where{place, false}));
      lua_pop(L_, 1);
    }
    return Value::list(std::move(items));
  }

  Value read_named(int index, const Keys& keys, const TablePlaces* page, const SourcePlace& place) {
    Value::Table entries;
    if (keys.positional > 0) entries.emplace_back("name", read_component_name(index, keys, page, place));
    for (const auto& name : keys.names) {
      const Step step(*this, {name, 0});
      lua_pushlstring(L_, name.data(), name.size());
      lua_rawget(L_, index);
      entries.emplace_back(name, read(-1, key_place(name, page, place)));
      lua_pop(L_, 1);
    }
    return Value::table(std::move(entries));
  }

  /// The string in front of `{ "salisbury_soft_finger", ka = 0.45 }`.
  Value read_component_name(int index, const Keys& keys, const TablePlaces* page, const SourcePlace& place) {
    const bool is_name = lua_rawgeti(L_, index, 1) == LUA_TSTRING;
    if (keys.positional != 1 || !is_name) {
      fail(place, fmt::format("a table has either positions or names ('{}'), or one text before the names",
                              keys.names.front()));
    }
    if (std::binary_search(keys.names.begin(), keys.names.end(), "name")) {
      fail(place, "the name is given twice, in front and as 'name'");
    }
    Value name = read(-1, page && !page->items.empty() ? Where{page->items[0], true} : Where{place, false});
    lua_pop(L_, 1);
    return name;
  }

  Where key_place(const std::string& key, const TablePlaces* page, const SourcePlace& place) {
    if (page) {
      const auto exact = page->keys.find(key);
      if (exact != page->keys.end() && exact->second.known()) return {exact->second, true};
    }
    const SourcePlace last = host_.places.last_key(page ? page->place.file : place.file, key);
    return {last.known() ? last : place, false};
  }

  /// One key of the way to a value: a name, or the position of an item.
  struct Key {
    std::string_view name;
    lua_Integer item;
  };

  /// Lengthens the way for its scope.
  class Step {
   public:
    Step(Reader& reader, Key key) : path_(reader.path_) { path_.push_back(key); }
    ~Step() { path_.pop_back(); }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

   private:
    std::vector<Key>& path_;
  };

  std::string path_text() const {
    std::string text;
    for (const auto& key : path_) {
      text += key.item > 0 ? fmt::format("[{}]", key.item)
                           : fmt::format("{}{}", text.empty() ? "" : ".", key.name);
    }
    return text;
  }

  [[noreturn]] void fail(const SourcePlace& place, const std::string& sentence) const {
    const std::string where = place.known() ? place.text() : host_.name;
    throw ScriptError(path_.empty() ? fmt::format("{}: {}", where, sentence)
                                    : fmt::format("{}: '{}': {}", where, path_text(), sentence));
  }

  lua_State* L_;
  Host& host_;
  std::vector<const void*> open_;
  std::size_t count_ = 0;
  std::vector<Key> path_;
};

}  // namespace

Value to_value(lua_State* L, int index, const SourcePlace& place) {
  return Reader(L).read(index, {place, false});
}

}  // namespace preshape::lua
