#include "scene_parts.h"

#include <cmath>

#include "io/scene_marks.h"
#include "preshape/geometry/solid_mesh.h"

namespace preshape {

namespace {

constexpr SceneColour kObject{"object", {0.85f, 0.76f, 0.60f, 1.0f}};
constexpr SceneColour kPalm{"palm", {0.45f, 0.50f, 0.56f, 1.0f}};
constexpr SceneColour kLink{"link", {0.62f, 0.69f, 0.77f, 1.0f}};
constexpr SceneColour kContact{"contact", {0.72f, 0.29f, 0.00f, 1.0f}};
constexpr SceneColour kNormal{"normal", {0.08f, 0.62f, 0.44f, 1.0f}};
constexpr SceneColour kForce{"force", {0.80f, 0.15f, 0.17f, 1.0f}};
constexpr SceneColour kMoment{"moment", {0.68f, 0.30f, 0.82f, 1.0f}};
constexpr SceneColour kResultant{"resultant", {0.16f, 0.40f, 0.90f, 1.0f}};
constexpr SceneColour kAxis{"axis", {0.72f, 0.54f, 0.12f, 1.0f}};
constexpr SceneColour kPlane{"plane", {0.35f, 0.55f, 0.85f, 0.25f}};
constexpr SceneColour kCollision{"collision", {1.00f, 0.08f, 0.58f, 1.0f}};
constexpr SceneColour kVolume{"approach volume", {0.94f, 0.74f, 0.12f, 0.22f}};
constexpr SceneColour kEntrance{"entrance", {0.78f, 0.56f, 0.00f, 1.0f}};
constexpr double kUnitArrow = 0.2;  // of a wrench's unit, in diagonals of the object
constexpr double kNothing = 1e-9;   // force or moment that is drawn as none

TriangleMesh arrow(double length, double radius, int heads) {
  return arrow_mesh(length, radius, heads, 16);
}

class Parts {
 public:
  explicit Parts(const GraspScene& scene) : scene_(scene), size_(scene_size(scene)) {}

  std::vector<ScenePart> take() {
    parts_.push_back({"object", "", scene_.object_O, {}, &kObject});
    add_links();
    if (scene_.approach_volume) add_approach_volume();
    for (std::size_t i = 0; i < scene_.contacts.size(); ++i)
      add_contact(scene_.contacts[i], scene_.fingers[i], scene_.F_C_O[i]);
    if (!scene_.contacts.empty()) {
      const Eigen::Vector3d O = Eigen::Vector3d::Zero();
      add_arrow("resultant force", scene_.resultant_O.force(), O, O, 1, kResultant);
      add_arrow("resultant moment", scene_.resultant_O.moment(), O, O, 2, kResultant);
      add_plane();
    }
    return std::move(parts_);
  }

 private:
  void add_links() {
    for (const SceneLink& link : scene_.links) {
      const bool box = link.solid.kind == Solid::Kind::kBox;
      parts_.push_back({link.name, "hand", solid_mesh(link.solid, 16), link.X_OS.back(),
                        link.collides                   ? &kCollision
                        : link.name.starts_with("palm") ? &kPalm
                                                        : &kLink,
                        !box, link.X_OS});
    }
  }

  void add_approach_volume() {
    const ApproachVolume& volume = *scene_.approach_volume;
    parts_.push_back({"approach volume", "approach", volume.mesh_O, {}, &kVolume});
    parts_.push_back(
        {"entrance", "approach", outline_mesh(volume.entrance_O, 0.006 * size_), {}, &kEntrance});
    parts_.push_back({"entrance normal", "approach", arrow(0.3 * size_, 0.006 * size_, 1),
                      pose_along(volume.centroid_O, volume.normal_O), &kEntrance});
  }

  void add_contact(const ContactFrame& C, const std::string& finger, const Wrench& F_C_O) {
    const Solid ball{Solid::Kind::kSphere, 0.018 * size_, 0.0, {}};
    parts_.push_back({"contact " + finger,
                      "contacts",
                      solid_mesh(ball, 16),
                      {Eigen::Matrix3d::Identity(), C.p_OC},
                      &kContact,
                      true});
    const double length = 1.4 * kUnitArrow * size_;  // seen behind the arrow of a unit force
    parts_.push_back({"normal " + finger, "normals", arrow(length, 0.004 * size_, 1),
                      pose_along(C.p_OC - length * C.n, C.n), &kNormal});
    add_arrow("force " + finger, F_C_O.force(), C.p_OC, C.n, 1, kForce);
    add_arrow("moment " + finger, F_C_O.moment(), C.p_OC, C.n, 2, kMoment);
  }

  /// @param inwards an arrow that goes that way ends at its point, else it begins there: so it is not in the
  /// object
  void add_arrow(const std::string& name, const Eigen::Vector3d& value, const Eigen::Vector3d& at,
                 const Eigen::Vector3d& inwards, int heads, const SceneColour& colour) {
    const double length = kUnitArrow * size_ * value.norm();
    if (value.norm() <= kNothing) return;
    const Eigen::Vector3d direction = value.normalized();
    const Eigen::Vector3d from = direction.dot(inwards) > 0 ? Eigen::Vector3d(at - length * direction) : at;
    parts_.push_back(
        {name, "wrenches", arrow(length, 0.008 * size_, heads), pose_along(from, direction), &colour});
  }

  void add_plane() {
    const double half = 0.62 * size_;
    const Eigen::Vector3d a = half * scene_.approach_O, o = half * scene_.opposition_O,
                          beside = middle_beside_O(scene_);
    TriangleMesh plane{{-a - o, a - o, a + o, -a + o}, {{0, 1, 2}, {0, 2, 3}}};
    parts_.push_back(
        {"approach plane", "plane", std::move(plane), {Eigen::Matrix3d::Identity(), beside}, &kPlane});
    const double thin = 0.0045 * size_;
    parts_.push_back({"approach axis", "plane", arrow(0.4 * size_, thin, 1),
                      pose_along(beside - 1.6 * a, scene_.approach_O), &kAxis});
    const Eigen::Vector3d station = beside + scene_.approach_m * scene_.approach_O;
    parts_.push_back({"opposition axis", "plane", arrow(2 * half, thin, 1),
                      pose_along(station - o, scene_.opposition_O), &kAxis});
  }

  const GraspScene& scene_;
  double size_;
  std::vector<ScenePart> parts_;
};

}  // namespace

double scene_size(const GraspScene& scene) {
  return bounding_box(scene.object_O).extents().norm();
}

std::vector<ScenePart> scene_parts(const GraspScene& scene) {
  return Parts(scene).take();
}

}  // namespace preshape
