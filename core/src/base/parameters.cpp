#include "preshape/base/parameters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape {

std::string_view parameter_type_name(ParameterType type) {
  switch (type) {
    case ParameterType::kBoolean: return "boolean";
    case ParameterType::kInteger: return "integer";
    case ParameterType::kNumber: return "number";
    case ParameterType::kText: return "string";
    case ParameterType::kChoice: return "choice";
    case ParameterType::kNumbers: return "list of numbers";
    case ParameterType::kTable: return "table";
  }
  return "?";
}

ParameterDeclaration ParameterDeclaration::number(std::string name, double default_value, double minimum,
                                                  double maximum, std::string unit, std::string text) {
  return {std::move(name), ParameterType::kNumber, default_value, minimum, maximum,
          std::move(unit), std::move(text), {}};
}

ParameterDeclaration ParameterDeclaration::integer(std::string name, std::int64_t default_value, double minimum,
                                                   double maximum, std::string unit, std::string text) {
  return {std::move(name), ParameterType::kInteger, default_value, minimum, maximum,
          std::move(unit), std::move(text), {}};
}

ParameterDeclaration ParameterDeclaration::flag(std::string name, bool default_value, std::string text) {
  ParameterDeclaration declaration;
  declaration.name = std::move(name);
  declaration.type = ParameterType::kBoolean;
  declaration.default_value = default_value;
  declaration.text = std::move(text);
  return declaration;
}

ParameterDeclaration ParameterDeclaration::label(std::string name, std::string default_value, std::string text) {
  ParameterDeclaration declaration;
  declaration.name = std::move(name);
  declaration.type = ParameterType::kText;
  declaration.default_value = std::move(default_value);
  declaration.text = std::move(text);
  return declaration;
}

ParameterDeclaration ParameterDeclaration::choice(std::string name, std::string default_value,
                                                  std::vector<std::string> choices, std::string text) {
  ParameterDeclaration declaration = label(std::move(name), std::move(default_value), std::move(text));
  declaration.type = ParameterType::kChoice;
  declaration.choices = std::move(choices);
  return declaration;
}

ParameterDeclaration ParameterDeclaration::list(std::string name, std::vector<double> default_value,
                                                double minimum, double maximum, std::string unit,
                                                std::string text) {
  return {std::move(name), ParameterType::kNumbers, Value::numbers(default_value), minimum, maximum,
          std::move(unit), std::move(text), {}};
}

ParameterDeclaration ParameterDeclaration::description(std::string name, std::string text) {
  ParameterDeclaration declaration;
  declaration.name = std::move(name);
  declaration.type = ParameterType::kTable;
  declaration.text = std::move(text);
  return declaration;
}

std::string ParameterDeclaration::bounds_text() const {
  if (type == ParameterType::kChoice) return fmt::format("{}", fmt::join(choices, " | "));
  if (type == ParameterType::kBoolean) return "true | false";
  const bool numeric = type == ParameterType::kNumber || type == ParameterType::kInteger ||
                       type == ParameterType::kNumbers;
  if (!numeric || (std::isinf(minimum) && std::isinf(maximum))) return "any";
  if (std::isinf(maximum)) return fmt::format(">= {}", number_text(minimum));
  if (std::isinf(minimum)) return fmt::format("<= {}", number_text(maximum));
  return fmt::format("{} .. {}", number_text(minimum), number_text(maximum));
}

std::string Mistake::text() const {
  const std::string where = place.text();
  return where.empty() ? sentence : fmt::format("{}: {}", where, sentence);
}

const Value& Parameters::value(std::string_view name) const {
  for (const auto& [key, value] : values_) {
    if (key == name) return value;
  }
  detail::fail_demand("parameter was declared", std::string(name).c_str(), 0);
}

double Parameters::number(std::string_view name) const { return value(name).number(); }
std::int64_t Parameters::integer(std::string_view name) const { return value(name).integer(); }
bool Parameters::flag(std::string_view name) const { return value(name).boolean(); }
const std::string& Parameters::text(std::string_view name) const { return value(name).string(); }

std::vector<double> Parameters::numbers(std::string_view name) const {
  std::vector<double> numbers;
  for (const auto& item : value(name).items()) numbers.push_back(item.number());
  return numbers;
}

ParameterSchema::ParameterSchema(std::string owner, std::vector<ParameterDeclaration> declarations)
    : owner_(std::move(owner)), declarations_(std::move(declarations)) {}

const ParameterDeclaration* ParameterSchema::find(std::string_view name) const {
  const auto found = std::find_if(declarations_.begin(), declarations_.end(),
                                  [&](const auto& declaration) { return declaration.name == name; });
  return found == declarations_.end() ? nullptr : &*found;
}

std::vector<std::string> ParameterSchema::names() const {
  std::vector<std::string> names;
  for (const auto& declaration : declarations_) names.push_back(declaration.name);
  return names;
}

namespace {

std::string number_fault(const ParameterDeclaration& declaration, const Value& value) {
  const double number = value.number();
  if (std::isnan(number)) return "is not a number (NaN)";
  if (declaration.type == ParameterType::kInteger && !value.is_integer()) {
    return fmt::format("must be a whole number, got {}", value.text());
  }
  if (number < declaration.minimum || number > declaration.maximum) {
    return fmt::format("must be {}{}, got {}", declaration.minimum > -1e300 && declaration.maximum < 1e300 ? "in " : "",
                       declaration.bounds_text(), value.text());
  }
  return "";
}

/// What is wrong with a value, as the end of a sentence that begins with the parameter's name; "" if nothing.
std::string fault(const ParameterDeclaration& declaration, const Value& value) {
  const auto expected = [&] {
    return fmt::format("must be a {}, got {} {}", parameter_type_name(declaration.type), value.kind(), value.text());
  };
  switch (declaration.type) {
    case ParameterType::kBoolean: return value.is_boolean() ? "" : expected();
    case ParameterType::kInteger:
    case ParameterType::kNumber: return value.is_number() ? number_fault(declaration, value) : expected();
    case ParameterType::kText: return value.is_string() ? "" : expected();
    case ParameterType::kTable: return value.is_table() || value.is_list() ? "" : expected();
    case ParameterType::kChoice:
      if (!value.is_string()) return expected();
      if (std::find(declaration.choices.begin(), declaration.choices.end(), value.string()) !=
          declaration.choices.end()) {
        return "";
      }
      return fmt::format("cannot be '{}'{}", value.string(), did_you_mean(value.string(), declaration.choices));
    case ParameterType::kNumbers:
      if (!value.is_list()) return expected();
      for (std::size_t i = 0; i < value.items().size(); ++i) {
        const Value& item = value.items()[i];
        if (!item.is_number()) return fmt::format("element {} must be a number, got {}", i + 1, item.text());
        const std::string wrong = number_fault(declaration, item);
        if (!wrong.empty()) return fmt::format("element {} {}", i + 1, wrong);
      }
      return "";
  }
  return "";
}

}  // namespace

std::vector<Mistake> ParameterSchema::check(const Value& given, const SourcePlace& place,
                                            std::span<const std::string> also_known) const {
  std::vector<Mistake> mistakes;
  const auto place_of = [&](const Value& value) { return value.place().known() ? value.place() : place; };
  if (!given.is_nil() && !given.is_table() && !(given.is_list() && given.items().empty())) {
    return {{place_of(given), fmt::format("{}: expected a table of parameters, got {} {}", owner_, given.kind(),
                                          given.text())}};
  }
  if (given.is_table()) {
    std::vector<std::string> known = names();
    known.insert(known.end(), also_known.begin(), also_known.end());
    for (const auto& [key, value] : given.entries()) {
      const ParameterDeclaration* declaration = find(key);
      if (!declaration) {
        if (std::find(also_known.begin(), also_known.end(), key) != also_known.end()) continue;
        const std::string hint = known.empty() ? "; it has no parameters" : did_you_mean(key, known);
        mistakes.push_back({place_of(value), fmt::format("{}: unknown key '{}'{}", owner_, key, hint)});
        continue;
      }
      const std::string wrong = fault(*declaration, value);
      if (!wrong.empty()) mistakes.push_back({place_of(value), fmt::format("{}: '{}' {}", owner_, key, wrong)});
    }
  }
  for (const auto& declaration : declarations_) {
    if (declaration.default_value.is_nil() && !given.find(declaration.name)) {
      mistakes.push_back({place_of(given), fmt::format("{}: '{}' is missing ({})", owner_, declaration.name,
                                                       declaration.text)});
    }
  }
  return mistakes;
}

Parameters ParameterSchema::resolve(const Value& given, const SourcePlace& place,
                                    std::span<const std::string> also_known) const {
  const auto mistakes = check(given, place, also_known);
  if (!mistakes.empty()) throw InputError(mistakes.front().text());
  Value::Table values;
  for (const auto& declaration : declarations_) {
    const Value* value = given.find(declaration.name);
    values.emplace_back(declaration.name, value ? *value : declaration.default_value);
  }
  return Parameters(std::move(values));
}

}  // namespace preshape
