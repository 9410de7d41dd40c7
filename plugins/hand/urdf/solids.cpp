#include "solids.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "document.h"
#include "mesh_bounds.h"

namespace preshape::urdf_hand {

namespace fs = std::filesystem;

namespace {

constexpr int kFoldersUp = 8;  // above the URDF's, in which a package is looked for

/// The file that a mesh's name means: below the URDF's folder, or in the package, whose folder is one above
/// the URDF's.
fs::path find_mesh(const fs::path& urdf, std::string name) {
  std::error_code ignored;
  for (const char* scheme : {"file://", "model://"}) {
    if (name.starts_with(scheme)) name.erase(0, std::string(scheme).size());
  }
  const bool package = name.starts_with("package://");
  if (package) name.erase(0, std::string("package://").size());
  const fs::path whole = name;
  const fs::path within = whole.lexically_relative(*whole.begin());  // without the package's name
  fs::path folder = fs::absolute(urdf, ignored).parent_path();
  for (int up = 0; up <= (package ? kFoldersUp : 0); ++up, folder = folder.parent_path()) {
    if (fs::is_regular_file(folder / whole, ignored)) return folder / whole;
    if (package && fs::is_regular_file(folder / within, ignored)) return folder / within;
  }
  return {};
}

class Collector {
 public:
  Collector(const Description& description, const Document& document, const Fingers& fingers)
      : description_(description), document_(document), fingers_(fingers), found_{{}, document.notes} {}

  Solids collect() {
    visit(description_.base_link, {}, description_.X_LH.inverse(), "");
    return std::move(found_);
  }

 private:
  /// @param X_CL of the link in its carrier's frame, that is H or a finger's link; @param from the joint that
  /// was crossed
  void visit(const std::string& link, const Carrier& carrier, const Pose& X_CL, const std::string& from);
  void cross(const urdf::Joint& joint, bool down, const Carrier& carrier, const Pose& X_CL);
  void append(const urdf::Link& link, const urdf::Collision& collision, const Carrier& carrier,
              const Pose& X_CL);
  std::optional<Bounds> solid_of(const std::string& element, const urdf::Geometry& geometry);
  std::optional<Bounds> mesh(const std::string& element, const urdf::Mesh& mesh);
  void demand_positive(const std::string& element, const Eigen::Vector3d& sizes) const;

  const Description& description_;
  const Document& document_;
  const Fingers& fingers_;
  Solids found_;
  std::set<std::string> visited_;
  std::map<fs::path, std::optional<std::vector<Eigen::Vector3d>>> meshes_;
};

void Collector::visit(const std::string& name, const Carrier& carrier, const Pose& X_CL,
                      const std::string& from) {
  if (!visited_.insert(name).second) return;
  const auto link = document_.model->getLink(name);
  for (const auto& collision : link->collision_array) {
    if (collision) append(*link, *collision, carrier, X_CL);
  }
  for (const auto& joint : link->child_joints) cross(*joint, true, carrier, X_CL);
  if (link->parent_joint && link->parent_joint->name != from)
    cross(*link->parent_joint, false, carrier, X_CL);
}

void Collector::cross(const urdf::Joint& joint, bool down, const Carrier& carrier, const Pose& X_CL) {
  const auto moved_by = fingers_.moved_by.find(joint.name);
  if (down && moved_by != fingers_.moved_by.end()) {
    visit(joint.child_link_name, moved_by->second, {}, joint.name);
  } else if (joint.type == urdf::Joint::FIXED || joint.type == urdf::Joint::UNKNOWN ||
             (down && !motion_of(document_, joint))) {
    const Pose X = pose_at_rest(document_, joint);
    visit(down ? joint.child_link_name : joint.parent_link_name, carrier, X_CL * (down ? X : X.inverse()),
          joint.name);
  } else {
    found_.notes.push_back(
        fmt::format("joint '{}' moves no finger: what is behind it is left out", joint.name));
  }
}

void Collector::append(const urdf::Link& link, const urdf::Collision& collision, const Carrier& carrier,
                       const Pose& X_CL) {
  if (!collision.geometry) return;
  const std::string element = fmt::format("link '{}', <collision>", link.name);
  const auto bounds = solid_of(element, *collision.geometry);
  if (!bounds) return;
  const Pose X_LS = pose_of(document_, element, collision.origin) * bounds->X;
  found_.solids.push_back({carrier.finger, carrier.link, bounds->solid, X_CL * X_LS});
}

std::optional<Bounds> Collector::solid_of(const std::string& element, const urdf::Geometry& geometry) {
  Bounds bounds;
  Solid& solid = bounds.solid;
  if (geometry.type == urdf::Geometry::SPHERE) {
    solid.radius = static_cast<const urdf::Sphere&>(geometry).radius;
    demand_positive(element, Eigen::Vector3d::Constant(solid.radius));
  } else if (geometry.type == urdf::Geometry::BOX) {
    const auto& size = static_cast<const urdf::Box&>(geometry).dim;
    solid.kind = Solid::Kind::kBox;
    solid.half_extents = 0.5 * Eigen::Vector3d(size.x, size.y, size.z);
    demand_positive(element, solid.half_extents);
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    demand_positive(element, {cylinder.radius, cylinder.length, 1.0});
    const bool flat = 0.5 * cylinder.length < cylinder.radius;
    solid.kind = flat ? Solid::Kind::kBox : Solid::Kind::kCapsule;
    if (flat)
      solid.half_extents = {cylinder.radius, cylinder.radius, 0.5 * cylinder.length};
    else
      solid.radius = cylinder.radius, solid.half_length = 0.5 * cylinder.length - cylinder.radius;
  } else {
    return mesh(element, static_cast<const urdf::Mesh&>(geometry));
  }
  return bounds;
}

std::optional<Bounds> Collector::mesh(const std::string& element, const urdf::Mesh& mesh) {
  const fs::path file = find_mesh(document_.file, mesh.filename);
  if (file.empty()) {
    found_.notes.push_back(fmt::format("{}: mesh '{}' is not there and is left out", element, mesh.filename));
    return std::nullopt;
  }
  const auto known = meshes_.find(file);
  const auto& vertices =
      known != meshes_.end() ? known->second : meshes_.emplace(file, read_vertices(file)).first->second;
  const Eigen::Vector3d scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
  if (!vertices || !scale.allFinite()) {
    found_.notes.push_back(
        fmt::format("{}: mesh '{}' cannot be read and is left out", element, file.string()));
    return std::nullopt;
  }
  std::vector<Eigen::Vector3d> scaled = *vertices;
  for (auto& p : scaled) p = p.cwiseProduct(scale);
  return bounds_of(scaled);
}

void Collector::demand_positive(const std::string& element, const Eigen::Vector3d& sizes) const {
  if (!sizes.allFinite() || sizes.minCoeff() <= 0.0)
    refuse(document_.file, fmt::format("{}: its sizes must be positive numbers, got {}", element, sizes.minCoeff()));
}

}  // namespace

Solids build_solids(const Description& description, const Document& document, const Fingers& fingers) {
  return Collector(description, document, fingers).collect();
}

}  // namespace preshape::urdf_hand
