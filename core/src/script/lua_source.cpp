#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/script/setting.h"

namespace preshape {

namespace {

constexpr std::array<std::string_view, 22> kKeywords = {
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += fmt::format("\\{}", c);
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\x{:02x}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string key_source(const std::string& key) {
  const bool name =
      !key.empty() && !std::isdigit(static_cast<unsigned char>(key.front())) &&
      std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; }) &&
      std::find(kKeywords.begin(), kKeywords.end(), key) == kKeywords.end();
  return name ? key : fmt::format("[{}]", quoted(key));
}

/// A whole double keeps its point, so that it reads back as a double.
std::string number_source(double number) {
  if (std::isnan(number)) return "0/0";
  if (std::isinf(number)) return number > 0 ? "math.huge" : "-math.huge";
  const std::string text = fmt::format("{}", number);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

bool is_plain(const Value& value) {
  return !value.is_list() && !value.is_table();
}

std::string source(const Value& value, std::size_t indent) {
  if (value.is_function()) throw InputError("a function cannot be written as Lua source");
  if (value.is_string()) return quoted(value.string());
  if (value == Value(std::numeric_limits<std::int64_t>::min()))
    return "math.mininteger";  // its digits overflow
  if (value.is_number() && !(value.is_integer() && value == Value(value.integer()))) {
    return number_source(value.number());
  }
  if (is_plain(value)) return value.text();
  if (value.is_list()) {
    if (value.items().empty()) return "{}";
    const bool row = std::all_of(value.items().begin(), value.items().end(), is_plain);
    const std::string margin(indent + 2, ' ');
    std::string text = row ? "{ " : "{\n";
    for (std::size_t i = 0; i < value.items().size(); ++i) {
      const std::string item = source(value.items()[i], indent + 2);
      text += row ? (i > 0 ? ", " : "") + item : margin + item + ",\n";
    }
    return text + (row ? " }" : std::string(indent, ' ') + "}");
  }
  if (value.entries().empty()) return "{}";
  std::string text = "{\n";
  for (const auto& [key, entry] : value.entries()) {
    text += fmt::format("{:{}}{} = {},\n", "", indent + 2, key_source(key), source(entry, indent + 2));
  }
  return text + std::string(indent, ' ') + "}";
}

}  // namespace

std::string lua_source(const Value& value) {
  return source(value, 0);
}

}  // namespace preshape
