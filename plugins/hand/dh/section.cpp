#include "section.h"

#include <numbers>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "turned.h"

namespace preshape::dh {

namespace {

constexpr double kLongest = 1000.0;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

}  // namespace

Section::Section(std::string owner, std::vector<ParameterDeclaration> keys, const Value& table,
                 const SourcePlace& place)
    : owner_(std::move(owner)), place_(table.place().known() ? table.place() : place), given_(&table) {
  values_ = ParameterSchema(owner_, std::move(keys)).resolve(table, place_);
}

std::vector<double> Section::numbers(std::string_view key, std::size_t count) const {
  const auto numbers = values_.numbers(key);
  if (numbers.size() != count) refuse(key, fmt::format("must have {} numbers, got {}", count, numbers.size()));
  return numbers;
}

Eigen::Vector3d Section::vector(std::string_view key) const {
  const auto n = numbers(key, 3);
  return {n[0], n[1], n[2]};
}

Eigen::Matrix3d Section::rotation(std::string_view key) const {
  return turned(vector(key));
}

std::span<const Value> Section::list(std::string_view key) const {
  const Value& value = values_.value(key);
  if (value.is_list()) return value.items();
  if (!value.entries().empty()) refuse(key, "must be a list of tables: { {...}, {...} }");
  return {};
}

void Section::refuse(std::string_view key, std::string_view sentence) const {
  const Value* value = given_->find(key);
  const SourcePlace& place = value && value->place().known() ? value->place() : place_;
  throw InputError(Mistake{place, fmt::format("{}: '{}' {}", owner_, key, sentence)}.text());
}

ParameterDeclaration length(std::string name, double default_value, std::string text) {
  return ParameterDeclaration::number(std::move(name), default_value, -kLongest, kLongest, "length", std::move(text));
}

ParameterDeclaration positive_length(std::string name, std::string text) {
  auto declaration =
      ParameterDeclaration::number(std::move(name), 0.0, 1e-6, kLongest, "length", std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration angle(std::string name, std::string text) {
  return ParameterDeclaration::number(std::move(name), 0.0, -kFullTurn, kFullTurn, "rad", std::move(text));
}

ParameterDeclaration optional_label(std::string name, std::string text) {
  return ParameterDeclaration::label(std::move(name), "", std::move(text));
}

ParameterDeclaration required_label(std::string name, std::string text) {
  auto declaration = optional_label(std::move(name), std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration optional_list(std::string name, std::string text) {
  auto declaration = ParameterDeclaration::description(std::move(name), std::move(text));
  declaration.default_value = Value::list({});
  return declaration;
}

ParameterDeclaration required_numbers(std::string name, std::string unit, std::string text) {
  auto declaration =
      ParameterDeclaration::list(std::move(name), {}, -kLongest, kLongest, std::move(unit), std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration point(std::string name, std::string text) {
  return ParameterDeclaration::list(std::move(name), {0, 0, 0}, -kLongest, kLongest, "length", std::move(text));
}

ParameterDeclaration roll_pitch_yaw(std::string name, std::string text) {
  return ParameterDeclaration::list(std::move(name), {0, 0, 0}, -kFullTurn, kFullTurn, "rad", std::move(text));
}

}  // namespace preshape::dh
