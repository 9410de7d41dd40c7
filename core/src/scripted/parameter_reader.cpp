#include "parameter_reader.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "keys.h"
#include "preshape/base/error.h"

namespace preshape::scripted {

namespace {

struct TypeName {
  const char* name;
  ParameterType type;
};
constexpr TypeName kTypes[] = {{"boolean", ParameterType::kBoolean}, {"integer", ParameterType::kInteger},
                               {"number", ParameterType::kNumber},   {"text", ParameterType::kText},
                               {"choice", ParameterType::kChoice},   {"numbers", ParameterType::kNumbers},
                               {"table", ParameterType::kTable}};

Keys parameter_keys(const std::string& owner) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<std::string> types;
  for (const auto& type : kTypes) types.emplace_back(type.name);
  Keys keys;
  keys.owner = owner;
  keys.data = {
      required_text("name", "of the parameter"),
      required_choice("type", types, "what it is"),
      ParameterDeclaration::number("minimum", -kInfinity, -kInfinity, kInfinity, "-", "smallest value"),
      ParameterDeclaration::number("maximum", kInfinity, -kInfinity, kInfinity, "-", "largest value"),
      ParameterDeclaration::label("unit", "-", "\"m\", \"rad\", \"1\" for a ratio"),
      required_text("text", "one line"),
      optional_table("choices", "texts to choose from")};
  keys.others = {"default"};
  return keys;
}

void read_choices(const Value& choices, const SourcePlace& place, const std::string& owner,
                  ParameterDeclaration& declared) {
  const bool chosen = declared.type == ParameterType::kChoice;
  if (!choices.is_list() || choices.items().empty() == chosen) {
    refuse(place, owner, "a choice, and nothing else, has 'choices', a list of texts");
  }
  for (const Value& choice : choices.items()) {
    if (!choice.is_string()) refuse(place, owner, fmt::format("a choice is a text, got {}", choice.text()));
    declared.choices.push_back(choice.string());
  }
}

}  // namespace

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

ParameterDeclaration read_parameter(const Value& table, const SourcePlace& enclosing,
                                    std::span<const ParameterDeclaration> before) {
  const SourcePlace& place = place_of(table, enclosing);
  std::string owner = fmt::format("parameter {}", before.size() + 1);
  if (const Value* name = table.find("name"); name && name->is_string()) {
    owner = fmt::format("parameter '{}'", name->string());
  }
  const Parameters values = parameter_keys(owner).check(table, place);
  ParameterDeclaration declared;
  declared.name = values.text("name");
  declared.type = std::find_if(std::begin(kTypes), std::end(kTypes), [&](const auto& type) {
                    return values.text("type") == type.name;
                  })->type;
  declared.minimum = values.number("minimum");
  declared.maximum = values.number("maximum");
  declared.unit = values.text("unit");
  declared.text = values.text("text");
  if (!is_name(declared.name)) refuse(place, owner, "letters, digits and '_' make a name");
  if (declared.text.empty()) refuse(place, owner, "'text' is empty");
  if (!(declared.minimum <= declared.maximum)) refuse(place, owner, "'minimum' is above 'maximum'");
  for (const auto& other : before) {
    if (other.name == declared.name) refuse(place, owner, "it is declared twice");
  }
  read_choices(values.value("choices"), place, owner, declared);
  if (const Value* standard = table.find("default")) {
    const ParameterSchema schema(owner, {declared});
    const auto mistakes = schema.check(Value::table({{declared.name, *standard}}), place);
    if (!mistakes.empty()) throw ScriptError(mistakes.front().text());
    declared.default_value = *standard;
  }
  return declared;
}

}  // namespace preshape::scripted
