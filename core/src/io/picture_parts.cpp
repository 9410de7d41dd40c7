#include "io/picture_parts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "io/scene_marks.h"
#include "preshape/base/error.h"
#include "preshape/geometry/solid_mesh.h"

namespace preshape {

namespace {

constexpr int kRound = 20;  ///< segments of balls and arrows

PictureMaterial material(PictureInk ink, float opacity = 1.0F, float hidden = 0.0F, bool shaded = true) {
  const Rgb colour = picture_ink(ink);
  return {Eigen::Vector3f(colour[0], colour[1], colour[2]), opacity, hidden, shaded};
}

TriangleMesh ball(const Eigen::Vector3d& p_O, double radius) {
  return transformed(solid_mesh({Solid::Kind::kSphere, radius, 0.0, {}}, kRound),
                     {Eigen::Matrix3d::Identity(), p_O});
}

/// Sizes of marks go with the object's.
double size_of(const GraspScene& scene) {
  double size = 0.0;
  for (const auto& vertex : scene.object_O.vertices) size = std::max(size, vertex.norm());
  return size;
}

/// Arrows of forces and couples in one scale.
struct ArrowScale {
  double longest = 0.0;  ///< [m] of the arrow of `greatest`
  double greatest = 0.0;
  double radius = 0.0;  ///< [m]

  void add(PicturePart& part, const Eigen::Vector3d& from, const Eigen::Vector3d& vector, int heads,
           const PictureMaterial& look) const {
    if (!(vector.norm() > 0.02 * greatest)) return;
    const double length = vector.norm() / greatest * longest;
    part.add(transformed(arrow_mesh(length, radius, heads, kRound), pose_along(from, vector)), look);
  }
};

void add_wrenches(PicturePart& marks, const GraspScene& scene, double size) {
  ArrowScale contacts{0.62 * size, 0.0, 0.016 * size}, resultant{0.8 * size, 0.0, 0.022 * size};
  for (const Wrench& wrench : scene.F_C_O)
    contacts.greatest = std::max({contacts.greatest, wrench.force().norm(), wrench.moment().norm()});
  resultant.greatest = std::max(scene.resultant_O.force().norm(), scene.resultant_O.moment().norm());
  constexpr float kThrough = 0.5F;
  for (std::size_t i = 0; i < std::min(scene.F_C_O.size(), scene.contacts.size()); ++i) {
    const Eigen::Vector3d& p = scene.contacts[i].p_OC;
    contacts.add(marks, p, scene.F_C_O[i].force(), 1, material(PictureInk::kForce, 1.0F, kThrough));
    contacts.add(marks, p, scene.F_C_O[i].moment(), 2, material(PictureInk::kMoment, 1.0F, kThrough));
  }
  const Eigen::Vector3d o = Eigen::Vector3d::Zero();
  resultant.add(marks, o, scene.resultant_O.force(), 1, material(PictureInk::kResultant, 1.0F, 0.6F));
  resultant.add(marks, o, scene.resultant_O.moment(), 2, material(PictureInk::kResultantMoment, 1.0F, 0.6F));
}

PicturePart marks_of(const GraspScene& scene, double size) {
  PicturePart marks;
  for (const ContactFrame& contact : scene.contacts) {
    marks.add(ball(contact.p_OC, 0.04 * size), material(PictureInk::kContact, 1.0F, 0.4F));
    const Pose X_OA = pose_along(contact.p_OC - 0.34 * size * contact.n, contact.n);
    marks.add(transformed(arrow_mesh(0.31 * size, 0.009 * size, 1, kRound), X_OA),
              material(PictureInk::kNormal, 1.0F, 0.3F));
  }
  add_wrenches(marks, scene, size);
  const Eigen::Vector3d station = scene.approach_m * scene.approach_O + middle_beside_O(scene),
                        reach = 1.35 * size * scene.opposition_O;
  marks.add(bar_mesh(station - reach, station + reach, 0.006 * size),
            material(PictureInk::kAxis, 0.9F, 0.25F));
  return marks;
}

/// The square in which approach and opposition axis lie, beside O.
PicturePart plane_of(const GraspScene& scene, double size) {
  PicturePart plane;
  const Eigen::Vector3d a = 1.2 * size * scene.approach_O, n = 1.2 * size * scene.opposition_O;
  const Eigen::Vector3d middle = middle_beside_O(scene);
  const TriangleMesh square{{middle - a - n, middle + n - a, middle + a + n, middle + a - n},
                            {{0, 1, 2}, {0, 2, 3}}};
  plane.add(outline_mesh(square.vertices, 0.005 * size), material(PictureInk::kPlane, 0.8F, 0.1F, false));
  plane.add(square, material(PictureInk::kPlane, 0.1F, 0.0F, false));
  return plane;
}

/// The volume apart from its entrance, which is seen through it.
std::vector<PicturePart> approach_of(const ApproachVolume& volume, double size) {
  std::vector<PicturePart> parts(2);
  parts[0].add(volume.mesh_O, material(PictureInk::kVolume, 0.26F, 0.0F, false));
  const PictureMaterial solid = material(PictureInk::kEntrance, 1.0F, 0.35F);
  parts[1].add(outline_mesh(volume.entrance_O, 0.012 * size), solid);
  const Pose X_OA = pose_along(volume.centroid_O, volume.normal_O);
  parts[1].add(transformed(arrow_mesh(0.5 * size, 0.014 * size, 1, kRound), X_OA), solid);
  return parts;
}

int frame_of(const GraspScene& scene, const PictureOptions& options) {
  const int frame = options.frame < 0 ? scene.frames + options.frame : options.frame;
  if (frame >= 0 && frame < scene.frames) return frame;
  throw InputError(fmt::format("a picture of posture {} cannot be made: the motion has {} postures",
                               options.frame, scene.frames));
}

/// The palm, the fingers and the links that collide, each by itself: they are seen through one another.
std::vector<PicturePart> hand_of(const GraspScene& scene, const PictureOptions& options) {
  std::vector<PicturePart> parts, colliding;
  if (scene.links.empty() || scene.frames < 1 || !(options.hand_opacity > 0.0)) return parts;
  const auto frame = static_cast<std::size_t>(frame_of(scene, options));
  const auto opacity = static_cast<float>(options.hand_opacity);
  std::string_view last = "";
  for (const SceneLink& link : scene.links) {
    const std::string_view of = std::string_view(link.name).substr(0, link.name.find(" link "));
    if (parts.empty() || of != last) parts.emplace_back();
    last = of;
    const TriangleMesh mesh_O = transformed(solid_mesh(link.solid, 28), link.X_OS[frame]);
    if (link.collides) {
      colliding.emplace_back();
      colliding.back().add(mesh_O, material(PictureInk::kCollision, std::max(opacity, 0.8F), 0.5F));
    } else {
      parts.back().add(mesh_O, material(PictureInk::kHand, opacity, 0.3F * opacity));
    }
  }
  std::erase_if(parts, [](const PicturePart& part) { return part.materials.empty(); });  // all of it collides
  parts.insert(parts.end(), colliding.begin(), colliding.end());
  return parts;
}

}  // namespace

void PicturePart::add(const TriangleMesh& mesh, const PictureMaterial& look) {
  append(mesh_O, mesh);
  material_of.resize(mesh_O.triangles.size(), materials.size());
  materials.push_back(look);
}

std::vector<PicturePart> picture_parts(const GraspScene& scene, const PictureOptions& options) {
  std::vector<PicturePart> parts(1);
  parts.front().add(scene.object_O, material(PictureInk::kObject));
  const double size = size_of(scene);
  for (auto& part : hand_of(scene, options)) parts.push_back(std::move(part));
  if (options.marks && !scene.contacts.empty()) {
    parts.push_back(marks_of(scene, size));
    parts.push_back(plane_of(scene, size));
  }
  if (options.marks && scene.approach_volume) {
    for (auto& part : approach_of(*scene.approach_volume, size)) parts.push_back(std::move(part));
  }
  return parts;
}

Rgb picture_ink(PictureInk ink) {
  switch (ink) {
    case PictureInk::kBackground:
      return {250, 250, 247};
    case PictureInk::kObject:
      return {206, 196, 178};
    case PictureInk::kHand:
      return {86, 132, 190};
    case PictureInk::kContact:
      return {196, 24, 48};
    case PictureInk::kNormal:
      return {70, 70, 74};
    case PictureInk::kForce:
      return {232, 112, 10};
    case PictureInk::kMoment:
      return {150, 70, 160};
    case PictureInk::kResultant:
      return {0, 128, 96};
    case PictureInk::kResultantMoment:
      return {96, 168, 40};
    case PictureInk::kPlane:
      return {90, 110, 150};
    case PictureInk::kAxis:
      return {30, 30, 36};
    case PictureInk::kVolume:
      return {255, 205, 40};
    case PictureInk::kEntrance:
      return {200, 142, 0};
    case PictureInk::kCollision:
      return {255, 20, 147};
  }
  return {};
}

}  // namespace preshape
