#include "geometry_value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/LU>

#include "keys.h"
#include "stack.h"

namespace preshape::scripted {

namespace {

constexpr double kRotationTolerance = 1e-6;
constexpr double kLongest = 1000.0;  // [m]: more is a mistake in the unit

const std::vector<std::string> kShapes = {"sphere", "capsule", "box"};

bool is_rotation(const Eigen::Matrix3d& R) {
  const double error = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  return error <= kRotationTolerance && R.determinant() > 0.0;
}

bool is_empty(const Value& value) {
  return value.is_list() && value.items().empty();
}

}  // namespace

std::vector<double> read_list(const Value& list, std::size_t count, const SourcePlace& place,
                              const std::string& owner) {
  std::vector<double> numbers;
  for (const Value& item : list.is_list() ? list.items() : Value::List{}) {
    if (item.is_number() && std::isfinite(item.number())) numbers.push_back(item.number());
  }
  const bool whole = list.is_list() && list.items().size() == count && numbers.size() == count;
  if (!whole)
    refuse(place_of(list, place), owner,
           fmt::format("expected {} finite numbers, got {}", count, list.text()));
  return numbers;
}

Pose read_pose(const Value& table, const SourcePlace& enclosing, const std::string& owner) {
  const SourcePlace& place = place_of(table, enclosing);
  const Keys keys{
      owner, {optional_table("R", "rotation, row by row"), optional_table("p", "position [m]")}, {}, {}, {}};
  const Parameters values = keys.check(table, place);
  Pose pose;
  if (const Value& R = values.value("R"); !is_empty(R)) {
    pose.R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
        read_list(R, 9, place, owner + ", R").data());
    if (!is_rotation(pose.R))
      refuse(place_of(R, place), owner, "R is no rotation (rows at right angles, of length 1)");
  }
  if (const Value& p = values.value("p"); !is_empty(p)) {
    pose.p = Eigen::Map<const Eigen::Vector3d>(read_list(p, 3, place, owner + ", p").data());
  }
  return pose;
}

void push_pose(lua_State* L, const Pose& pose) {
  lua_createtable(L, 0, 2);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = pose.R;
  push_numbers(L, {rows.data(), 9});
  lua_setfield(L, -2, "R");
  push_numbers(L, {pose.p.data(), 3});
  lua_setfield(L, -2, "p");
}

std::vector<ParameterDeclaration> solid_keys() {
  return {required_choice("shape", kShapes, "what the solid is"),
          ParameterDeclaration::number("radius", 0.0, 0.0, kLongest, "m", "of a sphere or a capsule"),
          ParameterDeclaration::number("half_length", 0.0, 0.0, kLongest, "m",
                                       "of a capsule, along z, to the centre of an end"),
          optional_table("half_extents", "of a box")};
}

Solid read_solid(const Parameters& values, const SourcePlace& place, const std::string& owner) {
  Solid solid;
  const auto shape = std::find(kShapes.begin(), kShapes.end(), values.text("shape")) - kShapes.begin();
  solid.kind = static_cast<Solid::Kind>(shape);
  solid.radius = values.number("radius");
  solid.half_length = values.number("half_length");
  const Value& extents = values.value("half_extents");
  if (solid.kind == Solid::Kind::kBox) {
    solid.half_extents =
        Eigen::Map<const Eigen::Vector3d>(read_list(extents, 3, place, owner + ", half_extents").data());
    if (solid.half_extents.minCoeff() <= 0.0) refuse(place, owner, "'half_extents' must be positive");
  } else if (solid.radius <= 0.0 || !is_empty(extents)) {
    refuse(place, owner,
           fmt::format("a {} has a positive 'radius' and no 'half_extents'", values.text("shape")));
  }
  return solid;
}

void set_solid(lua_State* L, const Solid& solid) {
  lua_pushstring(L, kShapes[static_cast<std::size_t>(solid.kind)].c_str());
  lua_setfield(L, -2, "shape");
  if (solid.kind == Solid::Kind::kBox) {
    push_numbers(L, {solid.half_extents.data(), 3});
    lua_setfield(L, -2, "half_extents");
    return;
  }
  lua_pushnumber(L, solid.radius);
  lua_setfield(L, -2, "radius");
  if (solid.kind != Solid::Kind::kCapsule) return;
  lua_pushnumber(L, solid.half_length);
  lua_setfield(L, -2, "half_length");
}

const std::vector<std::string>& role_names() {
  static const std::vector<std::string> names = {"thumb", "index", "middle", "ring", "little"};
  return names;
}

FingerRole role_of(const std::string& name) {
  const auto& names = role_names();
  return static_cast<FingerRole>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace preshape::scripted
