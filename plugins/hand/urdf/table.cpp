#include "table.h"

#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "preshape/base/error.h"

namespace preshape::urdf_hand {

namespace {

constexpr double kLongest = 1000.0;
constexpr double kFullTurn = 2.0 * std::numbers::pi;

}  // namespace

Table::Table(std::string owner, std::vector<ParameterDeclaration> keys, const Value& table,
             const SourcePlace& place)
    : owner_(std::move(owner)), place_(table.place().known() ? table.place() : place), given_(&table) {
  values_ = ParameterSchema(owner_, std::move(keys)).resolve(table, place_);
}

const SourcePlace& Table::place_of(std::string_view key) const {
  const Value* value = given_->find(key);
  return value && value->place().known() ? value->place() : place_;
}

Eigen::Vector3d Table::vector(std::string_view key) const {
  const auto n = values_.numbers(key);
  if (n.size() != 3) refuse(key, fmt::format("must have 3 numbers, got {}", n.size()));
  return {n[0], n[1], n[2]};
}

Pose Table::pose() const {
  return {turned(vector("rotation")), vector("position")};
}

std::span<const Value> Table::list(std::string_view key) const {
  const Value& value = values_.value(key);
  if (!value.is_list()) refuse(key, "must be a list of tables: { {...}, {...} }");
  return value.items();
}

void Table::refuse(std::string_view key, std::string_view sentence) const {
  throw InputError(Mistake{place_of(key), fmt::format("{}: '{}' {}", owner_, key, sentence)}.text());
}

ParameterDeclaration positive_length(std::string name, std::string text) {
  auto declaration = ParameterDeclaration::number(std::move(name), 0.0, 1e-6, kLongest, "m", std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration required_label(std::string name, std::string text) {
  auto declaration = ParameterDeclaration::label(std::move(name), "", std::move(text));
  declaration.default_value = Value{};
  return declaration;
}

ParameterDeclaration point(std::string name, std::string text) {
  return ParameterDeclaration::list(std::move(name), {0, 0, 0}, -kLongest, kLongest, "m", std::move(text));
}

ParameterDeclaration roll_pitch_yaw(std::string name, std::string text) {
  return ParameterDeclaration::list(std::move(name), {0, 0, 0}, -kFullTurn, kFullTurn, "rad",
                                    std::move(text));
}

Eigen::Matrix3d turned(const Eigen::Vector3d& rpy) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return (AngleAxisd(rpy.z(), Vector3d::UnitZ()) * AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace preshape::urdf_hand
