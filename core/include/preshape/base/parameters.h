#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "preshape/base/value.h"

namespace preshape {

enum class ParameterType { kBoolean, kInteger, kNumber, kText, kChoice, kNumbers, kTable };

PRESHAPE_API std::string_view parameter_type_name(ParameterType type);

/// One thing that a person can set, declared once: the declaration drives the checking of scripts, `--set`,
/// `preshape plugins NAME`, and the reference page.
struct PRESHAPE_API ParameterDeclaration {
  std::string name;
  ParameterType type = ParameterType::kNumber;
  Value default_value;  ///< nil: must be given
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::string unit = "-";            ///< "m", "rad", "1" for a ratio, "-" for none
  std::string text;                  ///< one line
  std::vector<std::string> choices;  ///< of a kChoice

  static ParameterDeclaration number(std::string name, double default_value, double minimum, double maximum,
                                     std::string unit, std::string text);
  static ParameterDeclaration integer(std::string name, std::int64_t default_value, double minimum,
                                      double maximum, std::string unit, std::string text);
  static ParameterDeclaration flag(std::string name, bool default_value, std::string text);
  static ParameterDeclaration label(std::string name, std::string default_value, std::string text);
  static ParameterDeclaration choice(std::string name, std::string default_value,
                                     std::vector<std::string> choices, std::string text);
  static ParameterDeclaration list(std::string name, std::vector<double> default_value, double minimum,
                                   double maximum, std::string unit, std::string text);
  /// A table of the owner's own schema (a hand's fingers, fuzzy sets); nil default = must be given.
  static ParameterDeclaration description(std::string name, std::string text);

  /// "0.45, in [0, 10]" and the like, for messages and tables.
  std::string bounds_text() const;
};

/// One thing that is wrong with what a person wrote: where, and the sentence that says what and the mend.
struct PRESHAPE_API Mistake {
  SourcePlace place;
  std::string sentence;
  /// "file:line: sentence".
  std::string text() const;
};

/// Parameters with every default filled in. Asking for a name that was not declared, or as another type than
/// it was declared, is our own bug (PRESHAPE_DEMAND).
class PRESHAPE_API Parameters {
 public:
  Parameters() = default;
  explicit Parameters(Value::Table values) : values_(std::move(values)) {}

  double number(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  bool flag(std::string_view name) const;
  const std::string& text(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
  const Value& value(std::string_view name) const;
  const Value::Table& values() const { return values_; }

 private:
  Value::Table values_;
};

/// An owner's declared parameters ("contact 'salisbury_soft_finger'", "thresholds").
class PRESHAPE_API ParameterSchema {
 public:
  ParameterSchema() = default;
  ParameterSchema(std::string owner, std::vector<ParameterDeclaration> declarations);

  const std::string& owner() const { return owner_; }
  std::span<const ParameterDeclaration> declarations() const { return declarations_; }
  const ParameterDeclaration* find(std::string_view name) const;
  std::vector<std::string> names() const;

  /// Every mistake in `given` (nil or a table): unknown key with the nearest right one, wrong type, value out
  /// of its bounds, NaN, missing. Places fall back to `place`. Keys named in `also_known` are passed over.
  std::vector<Mistake> check(const Value& given, const SourcePlace& place = {},
                             std::span<const std::string> also_known = {}) const;

  /// `given` with defaults filled in.
  /// @throws InputError with the first mistake
  Parameters resolve(const Value& given, const SourcePlace& place = {},
                     std::span<const std::string> also_known = {}) const;

  Parameters defaults() const { return resolve(Value{}); }

 private:
  std::string owner_;
  std::vector<ParameterDeclaration> declarations_;
};

}  // namespace preshape
