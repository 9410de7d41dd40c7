#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "preshape/base/export.h"

namespace preshape {

/// Where a value was written: a script's file and line (0 = unknown).
struct PRESHAPE_API SourcePlace {
  std::string file;
  int line = 0;

  bool known() const { return !file.empty(); }
  /// "file:line", "file", or "" when unknown.
  std::string text() const;
};

/// A tree of plain data as a script describes it: scenarios, hand and object descriptions, parameters.
/// Tables keep their keys sorted, so that nothing depends on a hash order. Each value knows its place.
class PRESHAPE_API Value {
 public:
  using List = std::vector<Value>;
  using Table = std::vector<std::pair<std::string, Value>>;

  /// A script's function, by its number in the script that owns it.
  struct Function {
    int reference = 0;
    bool operator==(const Function&) const = default;
  };

  Value() = default;
  // The data is assigned, not copied in place: where memory runs out in the middle, libstdc++ 12 would destroy an
  // alternative of the variant that was never made.
  Value(const Value& other) : place_(other.place_) { data_ = other.data_; }
  Value(Value&&) noexcept = default;
  Value& operator=(const Value&) = default;
  Value& operator=(Value&&) noexcept = default;
  ~Value() = default;
  Value(bool v) : data_(v) {}
  Value(int v) : data_(std::int64_t{v}) {}
  Value(std::int64_t v) : data_(v) {}
  Value(double v) : data_(v) {}
  Value(const char* v) : data_(std::string(v)) {}
  Value(std::string v) : data_(std::move(v)) {}
  Value(Function v) : data_(v) {}
  static Value list(List items);
  static Value table(Table entries);
  static Value numbers(const std::vector<double>& numbers);

  bool is_nil() const { return std::holds_alternative<std::monostate>(data_); }
  bool is_boolean() const { return std::holds_alternative<bool>(data_); }
  /// A whole number, also one written as 3.0.
  bool is_integer() const;
  bool is_number() const;
  bool is_string() const { return std::holds_alternative<std::string>(data_); }
  bool is_list() const { return std::holds_alternative<List>(data_); }
  bool is_table() const { return std::holds_alternative<Table>(data_); }
  bool is_function() const { return std::holds_alternative<Function>(data_); }
  /// "nil", "boolean", "number", "string", "list", "table" or "function".
  std::string_view kind() const;

  /// Unchecked by type at compile time; PRESHAPE_DEMANDs that the kind fits.
  bool boolean() const;
  std::int64_t integer() const;
  double number() const;
  const std::string& string() const;
  const List& items() const;
  List& items();
  const Table& entries() const;
  Function function() const;

  /// The entry of a table, or nullptr when this is no table or has no such key.
  const Value* find(std::string_view key) const;
  Value* find(std::string_view key);
  /// Sets a table's entry (a nil value becomes a table first) and returns it.
  Value& set(std::string key, Value value);
  void erase(std::string_view key);
  /// The keys of a table, sorted.
  std::vector<std::string> keys() const;

  const SourcePlace& place() const { return place_; }
  Value& at(SourcePlace place);

  /// As a person would write it in Lua, on one line; numbers with 17 significant digits only where needed.
  std::string text() const;

  /// Same data; places do not count.
  bool operator==(const Value& other) const { return data_ == other.data_; }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Function, List, Table> data_;
  SourcePlace place_;
};

/// The shortest decimal text that reads back as the same double.
PRESHAPE_API std::string number_text(double number);

}  // namespace preshape
