#include "preshape/base/value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/assert.h"

namespace preshape {

std::string SourcePlace::text() const {
  if (file.empty()) return "";
  return line > 0 ? fmt::format("{}:{}", file, line) : file;
}

Value Value::list(List items) {
  Value value;
  value.data_ = std::move(items);
  return value;
}

Value Value::table(Table entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Value value;
  value.data_ = std::move(entries);
  return value;
}

Value Value::numbers(const std::vector<double>& numbers) {
  return list(List(numbers.begin(), numbers.end()));
}

bool Value::is_integer() const {
  if (std::holds_alternative<std::int64_t>(data_)) return true;
  const auto* number = std::get_if<double>(&data_);
  return number && std::abs(*number) < 9e15 && std::floor(*number) == *number;
}

bool Value::is_number() const {
  return std::holds_alternative<double>(data_) || std::holds_alternative<std::int64_t>(data_);
}

std::string_view Value::kind() const {
  static constexpr std::string_view kKinds[] = {"nil",    "boolean",  "number", "number",
                                                "string", "function", "list",   "table"};
  return kKinds[data_.index()];
}

bool Value::boolean() const {
  PRESHAPE_DEMAND(is_boolean());
  return std::get<bool>(data_);
}

std::int64_t Value::integer() const {
  PRESHAPE_DEMAND(is_integer());
  if (const auto* integer = std::get_if<std::int64_t>(&data_)) return *integer;
  return static_cast<std::int64_t>(std::get<double>(data_));
}

double Value::number() const {
  PRESHAPE_DEMAND(is_number());
  if (const auto* integer = std::get_if<std::int64_t>(&data_)) return static_cast<double>(*integer);
  return std::get<double>(data_);
}

const std::string& Value::string() const {
  PRESHAPE_DEMAND(is_string());
  return std::get<std::string>(data_);
}

const Value::List& Value::items() const {
  PRESHAPE_DEMAND(is_list());
  return std::get<List>(data_);
}

Value::List& Value::items() {
  PRESHAPE_DEMAND(is_list());
  return std::get<List>(data_);
}

const Value::Table& Value::entries() const {
  PRESHAPE_DEMAND(is_table());
  return std::get<Table>(data_);
}

Value::Function Value::function() const {
  PRESHAPE_DEMAND(is_function());
  return std::get<Function>(data_);
}

const Value* Value::find(std::string_view key) const {
  const auto* entries = std::get_if<Table>(&data_);
  if (!entries) return nullptr;
  for (const auto& [name, value] : *entries) {
    if (name == key) return &value;
  }
  return nullptr;
}

Value* Value::find(std::string_view key) { return const_cast<Value*>(std::as_const(*this).find(key)); }

Value& Value::set(std::string key, Value value) {
  if (is_nil()) data_ = Table{};
  PRESHAPE_DEMAND(is_table());
  auto& entries = std::get<Table>(data_);
  const auto place = std::lower_bound(entries.begin(), entries.end(), key,
                                      [](const auto& entry, const std::string& k) { return entry.first < k; });
  if (place != entries.end() && place->first == key) {
    place->second = std::move(value);
    return place->second;
  }
  return entries.insert(place, {std::move(key), std::move(value)})->second;
}

void Value::erase(std::string_view key) {
  PRESHAPE_DEMAND(is_table());
  std::erase_if(std::get<Table>(data_), [&](const auto& entry) { return entry.first == key; });
}

std::vector<std::string> Value::keys() const {
  std::vector<std::string> keys;
  if (const auto* entries = std::get_if<Table>(&data_)) {
    for (const auto& entry : *entries) keys.push_back(entry.first);
  }
  return keys;
}

Value& Value::at(SourcePlace place) {
  place_ = std::move(place);
  return *this;
}

std::string number_text(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return fmt::format("{}", number);
}

std::string Value::text() const {
  if (is_nil()) return "nil";
  if (is_boolean()) return boolean() ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&data_)) return fmt::format("{}", *integer);
  if (is_number()) return number_text(number());
  if (is_string()) return fmt::format("\"{}\"", string());
  if (is_function()) return "function";
  std::string text = "{";
  if (is_list()) {
    for (const auto& item : items()) text += (text.size() > 1 ? ", " : " ") + item.text();
  } else {
    for (const auto& [key, value] : entries()) {
      text += fmt::format("{}{} = {}", text.size() > 1 ? ", " : " ", key, value.text());
    }
  }
  return text + (text.size() > 1 ? " }" : "}");
}

}  // namespace preshape
