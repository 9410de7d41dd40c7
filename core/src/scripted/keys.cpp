#include "keys.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape::scripted {

void refuse(const SourcePlace& place, const std::string& owner, const std::string& sentence) {
  throw ScriptError(place.known() ? fmt::format("{}: {}: {}", place.text(), owner, sentence)
                                  : fmt::format("{}: {}", owner, sentence));
}

const SourcePlace& place_of(const Value& value, const SourcePlace& enclosing) {
  return value.place().known() ? value.place() : enclosing;
}

Parameters Keys::check(const Value& table, const SourcePlace& enclosing) const {
  const SourcePlace& place = place_of(table, enclosing);
  std::vector<std::string> also_known = functions;
  also_known.insert(also_known.end(), optional_functions.begin(), optional_functions.end());
  also_known.insert(also_known.end(), others.begin(), others.end());
  const ParameterSchema schema(owner, data);
  if (const auto mistakes = schema.check(table, place, also_known); !mistakes.empty()) {
    throw ScriptError(mistakes.front().text());
  }
  for (const auto& name : functions) {
    if (!table.find(name)) refuse(place, owner, fmt::format("the function '{}' is missing", name));
  }
  for (const auto* names : {&functions, &optional_functions}) {
    for (const auto& name : *names) {
      const Value* value = table.find(name);
      if (!value || value->is_function()) continue;
      refuse(place_of(*value, place), owner,
             fmt::format("'{}' must be a function, got {} {}", name, value->kind(), value->text()));
    }
  }
  return schema.resolve(table, place, also_known);
}

ParameterDeclaration required_text(std::string name, std::string text) {
  auto declaration = ParameterDeclaration::label(std::move(name), "", std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration required_choice(std::string name, std::vector<std::string> choices, std::string text) {
  auto declaration = ParameterDeclaration::choice(std::move(name), "", std::move(choices), std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration required_number(std::string name, double minimum, double maximum, std::string unit,
                                     std::string text) {
  auto declaration =
      ParameterDeclaration::number(std::move(name), 0.0, minimum, maximum, std::move(unit), std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration required_table(std::string name, std::string text) {
  return ParameterDeclaration::description(std::move(name), std::move(text));
}

ParameterDeclaration optional_table(std::string name, std::string text) {
  auto declaration = required_table(std::move(name), std::move(text));
  declaration.default_value = Value::list({});
  return declaration;
}

}  // namespace preshape::scripted
