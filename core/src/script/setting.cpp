#include "preshape/script/setting.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/script/script.h"

namespace preshape {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = " \t";
  const auto begin = text.find_first_not_of(blank);
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

/// "knn", "objects/mug/mug.obj", "soft-finger", "-Z": what a shell passes for a name. Not Lua's own words.
bool is_word(std::string_view text) {
  if (text == "true" || text == "false" || text == "nil") return false;
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);  // an axis; a number goes on with a digit
  if (text.empty() || text.starts_with("math.")) return false;
  const auto first = static_cast<unsigned char>(text.front());
  if (!std::isalpha(first) && text.find_first_of("_/~") != 0 && !text.starts_with("./") &&
      !text.starts_with("../")) {
    return false;
  }
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c >= 0x80 ||
           std::string_view("_-./~+@:").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

/// What is wrong, without the place in a text that the person wrote on one line.
std::string reason(const std::string& message) {
  const auto place = message.find(":1: ");
  return place == std::string::npos ? message : message.substr(place + 4);
}

bool holds_function(const Value& value) {
  if (value.is_list()) return std::any_of(value.items().begin(), value.items().end(), holds_function);
  if (!value.is_table()) return value.is_function();
  return std::any_of(value.entries().begin(), value.entries().end(),
                     [](const auto& entry) { return holds_function(entry.second); });
}

/// Gives every part of the value the same place.
void place_all(Value& value, const SourcePlace& place) {
  value.at(place);
  if (value.is_list()) {
    for (auto& item : value.items()) place_all(item, place);
  } else if (value.is_table()) {
    for (const auto& key : value.keys()) place_all(*value.find(key), place);
  }
}

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    parts.emplace_back(key.substr(begin, end - begin));
    begin = end + 1;
  }
  const bool named = std::all_of(parts.begin(), parts.end(), [](const std::string& part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char c) {
      return std::isalnum(c) || c == '_' || c == '-';
    });
  });
  if (!named)
    throw InputError(fmt::format("'{}' is no key; expected names with dots between, as 'contact.mu'", key));
  return parts;
}

/// The position that a part of a key is, from 0.
std::optional<std::size_t> position(const std::string& part) {
  std::size_t number = 0;
  const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (fault != std::errc{} || end != part.data() + part.size() || number == 0) return {};
  return number - 1;
}

/// Makes the component "knn" or { "knn" } a table, so that it can take a parameter.
void open_component(Value& value) {
  const SourcePlace place = value.place();
  if (value.is_list() && value.items().empty()) {
    value = Value::table({});
  } else if (value.is_list() && value.items().size() == 1 && value.items().front().is_string()) {
    value = Value::table({{"name", Value(value.items().front())}});
  } else if (value.is_string()) {
    Value name = value;
    value = Value::table({{"name", std::move(name)}});
  }
  value.at(place);
}

/// The item of a list that `part` picks; one past the end is made.
Value& item_of(Value& list, const std::string& part, std::string_view key, std::string_view so_far) {
  const auto at = position(part);
  auto& items = list.items();
  if (!at || *at > items.size()) {
    throw InputError(fmt::format("--set {}: '{}' is a list of {}, '{}' picks none of them", key, so_far,
                                 items.size(), part));
  }
  if (*at == items.size()) items.emplace_back();
  return items[*at];
}

}  // namespace

Value parse_value(std::string_view text) {
  const std::string expression(trimmed(text));
  if (is_word(expression)) return expression;
  if (expression.empty()) throw InputError("a value is missing; write \"\" for an empty text");
  ScriptOptions options;
  options.limits = {.memory_bytes = std::size_t{8} << 20, .instructions = 1'000'000};
  try {
    Value value = Script::from_text("return " + expression, "value.lua", std::move(options)).run();
    if (holds_function(value)) throw ScriptError("a function can only be given in a script");
    place_all(value, {});
    return value;
  } catch (const ScriptError& error) {
    throw InputError(fmt::format("'{}' is no value ({})", expression, reason(error.what())));
  }
}

Setting parse_setting(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == text.npos)
    throw InputError(fmt::format("--set {}: expected KEY=VALUE, as contact.mu=0.6", text));
  Setting setting{std::string(trimmed(text.substr(0, equals))), {}};
  try {
    parts_of(setting.key);
    setting.value = parse_value(text.substr(equals + 1));
  } catch (const InputError& error) {
    throw InputError(fmt::format("--set {}: {}", text, error.what()));
  }
  place_all(setting.value, {fmt::format("--set {}", text), 0});
  return setting;
}

void set_path(Value& root, std::string_view dotted_key, Value value) {
  const auto parts = parts_of(dotted_key);
  Value* at = &root;
  std::string so_far;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    if (!(at->is_list() && position(parts[i]))) open_component(*at);
    if (at->is_list()) {
      at = &item_of(*at, parts[i], dotted_key, so_far);
    } else if (at->is_table() || at->is_nil()) {
      if (last && value.is_nil()) {
        if (at->is_table()) at->erase(parts[i]);
        return;
      }
      Value* next = at->find(parts[i]);
      at = next ? next : &at->set(parts[i], {});
    } else {
      throw InputError(
          fmt::format("--set {}: '{}' is a {} and has no '{}'", dotted_key, so_far, at->kind(), parts[i]));
    }
    so_far += (i > 0 ? "." : "") + parts[i];
  }
  *at = std::move(value);
}

}  // namespace preshape
