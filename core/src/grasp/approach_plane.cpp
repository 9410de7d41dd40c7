#include "preshape/grasp/approach_plane.h"

#include <Eigen/Geometry>
#include <cmath>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/grasp/task_space.h"

namespace preshape {

namespace {

constexpr double kRightAngle = 1e-6;  // between axes written with six digits

Eigen::Vector3d axis_vector(std::string_view text) {
  const SignedAxis axis = parse_axis(text);
  return axis.sign * Eigen::Vector3d::Unit(axis.axis);
}

std::string axis_text(const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(v[i]) == 1.0) return fmt::format("{}{}", v[i] > 0 ? '+' : '-', "XYZ"[i]);
  }
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", v.x(), v.y(), v.z());
}

Eigen::Vector3d axis_from_value(const Value& value) {
  if (value.is_string()) return axis_vector(value.string());
  const bool triple = value.is_list() && value.items().size() == 3;
  if (!triple) throw InputError(fmt::format("an axis is \"+X\" .. \"-Z\" or {{x, y, z}}, got {}", value.text()));
  Eigen::Vector3d v;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!value.items()[i].is_number()) throw InputError(fmt::format("an axis has three numbers, got {}", value.text()));
    v[static_cast<Eigen::Index>(i)] = value.items()[i].number();
  }
  return v;
}

ApproachPlane plane_from_value(const Value& value) {
  static const ParameterSchema schema("approach plane", {});
  if (!value.is_table()) throw InputError("a plane is { approach = \"+X\", push = \"-Y\" }, got " + value.text());
  const Value* approach = value.find("approach");
  const Value* push = value.find("push");
  const std::vector<std::string> known = {"approach", "push"};
  const auto mistakes = schema.check(value, value.place(), known);
  if (!mistakes.empty()) throw InputError(mistakes.front().sentence);
  if (!approach || !push) throw InputError("a plane needs both 'approach' and 'push' (the forefingers' direction)");
  return ApproachPlane::along(axis_from_value(*approach), axis_from_value(*push));
}

/// Planes that are sampled instead of listed.
const ParameterSchema& sampling_schema() {
  using D = ParameterDeclaration;
  static const ParameterSchema schema(
      "planes", {D::integer("directions", 60, 1, 2000, "-", "approach directions, spread evenly over the sphere"),
                 D::integer("rolls", 8, 1, 64, "-", "planes of each direction, turned evenly about it"),
                 D::flag("thesis", true, "the thesis's twelve planes stand before them")});
  return schema;
}

}  // namespace

ApproachPlane ApproachPlane::along(const Eigen::Vector3d& a, const Eigen::Vector3d& n_f) {
  if (!a.allFinite() || !n_f.allFinite() || a.norm() == 0.0 || n_f.norm() == 0.0) {
    throw InputError("the axes of an approach plane must be finite and not zero");
  }
  ApproachPlane plane{a.normalized(), n_f.normalized(), {}};
  if (std::abs(plane.a.dot(plane.n_f)) > kRightAngle) {
    throw InputError("the approach axis and the push axis of a plane must be at right angles");
  }
  plane.transverse = plane.n_f.cross(plane.a).normalized();
  Eigen::Index largest = 0;
  if (plane.transverse.cwiseAbs().maxCoeff(&largest) == 1.0) plane.transverse = Eigen::Vector3d::Unit(largest);
  return plane;
}

std::string ApproachPlane::text() const {
  return fmt::format("approach {}, forefingers push {}", axis_text(a), axis_text(n_f));
}

ApproachPlanes thesis_planes() {
  static constexpr const char* kAxes[12][2] = {{"+X", "-Y"}, {"+Y", "-X"}, {"+Y", "-Z"}, {"+Z", "-Y"},
                                               {"+X", "+Y"}, {"+Y", "+X"}, {"+Z", "+Y"}, {"+Y", "+Z"},
                                               {"+X", "+Z"}, {"+Z", "+X"}, {"+X", "-Z"}, {"+Z", "-X"}};
  ApproachPlanes planes;
  for (const auto& [a, n_f] : kAxes) planes.push_back(ApproachPlane::along(axis_vector(a), axis_vector(n_f)));
  return planes;
}

std::vector<Mistake> check_planes(const Value& planes) {
  if (planes.is_table() && !planes.entries().empty()) return sampling_schema().check(planes, planes.place());
  if (!planes.is_list() || planes.items().empty()) {
    return {{planes.place(), "planes: expected a list of planes or { directions = , rolls = }, got " + planes.text()}};
  }
  std::vector<Mistake> mistakes;
  for (const auto& item : planes.items()) {
    try {
      plane_from_value(item);
    } catch (const InputError& problem) {
      mistakes.push_back({item.place().known() ? item.place() : planes.place(), std::string("planes: ") + problem.what()});
    }
  }
  return mistakes;
}

ApproachPlanes planes_from_value(const Value& value) {
  const auto mistakes = check_planes(value);
  if (!mistakes.empty()) throw InputError(mistakes.front().text());
  ApproachPlanes planes;
  if (value.is_table()) {
    const Parameters p = sampling_schema().resolve(value);
    if (p.flag("thesis")) planes = thesis_planes();
    const auto sampled = sampled_planes(static_cast<int>(p.integer("directions")), static_cast<int>(p.integer("rolls")));
    planes.insert(planes.end(), sampled.begin(), sampled.end());
    return planes;
  }
  for (const auto& item : value.items()) planes.push_back(plane_from_value(item));
  return planes;
}

}  // namespace preshape
