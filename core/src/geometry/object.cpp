#include "preshape/geometry/object.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "preshape/base/error.h"
#include "preshape/base/sha256.h"

namespace preshape {

namespace {

constexpr double kLargestExtent = 1e6;  // [m]; keeps the hash's whole numbers far from overflow

void check(const RawObject& raw, const ObjectPlacement& placement, double unit_length_m) {
  const Value given = Value::table({{"centre", placement.centre},
                                    {"fit", placement.fit_U},
                                    {"frame", placement.frame},
                                    {"unit", placement.unit}});
  placement_schema().resolve(given);
  if (!(unit_length_m > 0.0) || !std::isfinite(unit_length_m)) {
    throw InputError(fmt::format("object '{}': the hand's unit length U must be positive, got {} m", raw.name,
                                 unit_length_m));
  }
  if (raw.mesh.triangles.empty()) {
    throw InputError(fmt::format("object '{}': no triangle is left; give a mesh with a surface", raw.name));
  }
}

double checked_extent(const Object& object, const Box& box) {
  const double extent = box.extents().maxCoeff();
  if (extent > 0.0 && extent <= kLargestExtent) return extent;
  throw InputError(
      fmt::format("object '{}': its largest extent is {} m, allowed is up to {} m; set its unit or fit",
                  object.name, number_text(extent), number_text(kLargestExtent)));
}

double metres_per_unit(const std::string& unit, double unit_length_m) {
  if (unit == "cm") return 0.01;
  if (unit == "mm") return 0.001;
  if (unit == "inch") return 0.0254;
  if (unit == "U") return unit_length_m;
  return 1.0;
}

Eigen::Matrix3d frame_axes(const TriangleMesh& mesh, const std::string& frame) {
  if (frame == "principal") return principal_axes(mesh);
  if (frame == "smallest_box") return smallest_box_axes(mesh);
  return Eigen::Matrix3d::Identity();
}

void scale_mesh(TriangleMesh& mesh, double factor) {
  for (auto& p : mesh.vertices) p *= factor;
}

void turn_and_scale(Object& object, const ObjectPlacement& placement, double unit_length_m) {
  TriangleMesh& mesh = object.mesh_O;
  if (placement.frame != "file") {
    const Eigen::Matrix3d R_OF = frame_axes(mesh, placement.frame).transpose();
    for (auto& p : mesh.vertices) p = R_OF * p;
  }
  object.scale = metres_per_unit(placement.unit, unit_length_m);
  if (placement.fit_U > 0.0) {
    object.scale = placement.fit_U * unit_length_m / bounding_box(mesh).extents().maxCoeff();
  }
  if (object.scale != 1.0) scale_mesh(mesh, object.scale);
}

void tell_unit(Object& object, const ObjectPlacement& placement, bool unit_known, double extent) {
  if (placement.fit_U > 0.0) return;
  if (placement.unit == "file" && !unit_known) {
    object.warnings.push_back(
        fmt::format("the file states no unit; taken as metres, largest extent {:.4g} m", extent));
  }
  if (placement.unit != "file" && unit_known) {
    object.warnings.push_back(fmt::format(
        "the file's format states lengths in metres, but they are taken as {}, as asked", placement.unit));
  }
}

void centre(Object& object, const ObjectPlacement& placement) {
  const bool has_volume = object.topology.bounds_volume();
  VolumeProperties properties;
  if (has_volume) properties = volume_properties(object.mesh_O);
  const bool usable = has_volume && properties.centroid.allFinite() && properties.volume != 0.0;
  Eigen::Vector3d origin = bounding_box(object.mesh_O).centre();
  if (placement.centre == "volume") {
    if (usable)
      origin = properties.centroid;
    else
      object.warnings.emplace_back(
          "the mesh bounds no volume; the centre of its box is taken for the centre of volume");
  }
  for (auto& p : object.mesh_O.vertices) p -= origin;
  object.volume_centroid_O = usable ? Eigen::Vector3d(properties.centroid - origin)
                                    : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

const ParameterSchema& placement_schema() {
  static const ParameterSchema schema(
      "object", {ParameterDeclaration::choice(
                     "unit", "file", {"file", "m", "cm", "mm", "inch", "U"},
                     "what one unit of the mesh's numbers is; file: as its format states, else metres"),
                 ParameterDeclaration::number(
                     "fit", 0.0, 0.0, 1e6, "U",
                     "scale so that the largest extent is this long, whatever the unit; 0: do not"),
                 ParameterDeclaration::choice(
                     "frame", "file", {"file", "principal", "smallest_box"},
                     "axes of the object: the file's, of inertia, or of the smallest enclosing box"),
                 ParameterDeclaration::choice(
                     "centre", "box", {"box", "volume"},
                     "origin of the object: centre of its axis-aligned box, or of its volume")});
  return schema;
}

ObjectPlacement object_placement(const Parameters& parameters) {
  return {parameters.text("unit"), parameters.number("fit"), parameters.text("frame"),
          parameters.text("centre")};
}

ObjectAttributes Object::attributes(double length_m) const {
  const Eigen::Vector3d extents = box_O.extents() / length_m;
  const auto triangles = static_cast<double>(mesh_O.triangles.size());
  return {extents.x(),
          extents.y(),
          extents.z(),
          static_cast<double>(mesh_O.vertices.size()) / triangles,
          static_cast<double>(file_normals) / triangles,
          static_cast<double>(file_faces) / triangles,
          triangles / 1000.0};
}

Object place_object(RawObject raw, const ObjectPlacement& placement, double unit_length_m) {
  check(raw, placement, unit_length_m);
  Object object;
  object.name = std::move(raw.name);
  object.file = std::move(raw.file);
  object.mesh_O = std::move(raw.mesh);
  object.file_faces = raw.file_faces;
  object.file_normals = raw.file_normals;
  object.topology = raw.topology;
  object.warnings = std::move(raw.warnings);
  turn_and_scale(object, placement, unit_length_m);
  tell_unit(object, placement, raw.unit_known, checked_extent(object, bounding_box(object.mesh_O)));
  centre(object, placement);
  object.box_O = bounding_box(object.mesh_O);
  object.hash = object_hash(object.mesh_O);
  return object;
}

std::string object_hash(const TriangleMesh& mesh) {
  constexpr double kGrain = 1e-9;  // [m]
  Sha256 hash;
  hash.update_little_endian(mesh.vertices.size());
  for (const auto& p : mesh.vertices) {
    for (int k = 0; k < 3; ++k)
      hash.update_little_endian(static_cast<std::uint64_t>(std::llround(p[k] / kGrain)));
  }
  hash.update_little_endian(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) hash.update_little_endian(static_cast<std::uint64_t>(v));
  }
  return hash.hex();
}

}  // namespace preshape
