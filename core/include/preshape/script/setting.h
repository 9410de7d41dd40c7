#pragma once

#include <string>
#include <string_view>

#include "preshape/base/export.h"
#include "preshape/base/value.h"

namespace preshape {

/// One `--set contact.mu=0.6`.
struct Setting {
  std::string key;  ///< "contact.mu"
  Value value;      ///< nil takes the key away; its place is the setting itself
};

/// Reads "key=value".
/// @throws InputError when there is no '=', the key is no dotted name, or the value cannot be read
PRESHAPE_API Setting parse_setting(std::string_view text);

/// Reads a value as Lua writes it: a number or arithmetic on numbers ("-1/3", "30 * math.pi / 180"), true,
/// false, nil, "text", { 1, 2 }, { "knn", k = 3 }. A bare word or file name is a string.
/// @throws InputError in one sentence
PRESHAPE_API Value parse_value(std::string_view text);

/// Sets `root.a.b` for the dotted key "a.b". Missing tables are made on the way. A component given by its
/// name alone ("knn") becomes { name = "knn" } when one of its parameters is set. A number picks an item of a
/// list, from 1; one past the end appends. A nil value takes the entry away.
/// @throws InputError when the way leads through something that has no keys
PRESHAPE_API void set_path(Value& root, std::string_view dotted_key, Value value);

/// The value as Lua source that reads back as the same value, one entry a line.
/// @throws InputError for a function
PRESHAPE_API std::string lua_source(const Value& value);

}  // namespace preshape
