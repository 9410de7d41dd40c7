#include "preshape/agent/environment_sensing.h"

#include <algorithm>

namespace preshape {

EnvironmentSensing::EnvironmentSensing(std::shared_ptr<const CollisionBackend> collision, HandDimensions hand,
                                       ApproachPlanes planes, AnalysisSettings settings)
    : collision_(std::move(collision)), hand_(hand), planes_(std::move(planes)), settings_(settings) {}

namespace {

double furthest(const TriangleMesh& mesh, const Eigen::Vector3d& axis) {
  double furthest = 0.0;
  for (const auto& vertex : mesh.vertices) furthest = std::max(furthest, std::abs(axis.dot(vertex)));
  return furthest;
}

}  // namespace

std::shared_ptr<const SensedObject> EnvironmentSensing::sense(RawObject raw, const ObjectPlacement& placement) const {
  auto sensed = std::make_shared<SensedObject>();
  sensed->object = place_object(std::move(raw), placement, hand_.unit_length_m);
  sensed->length_m = settings_.length_U * hand_.unit_length_m;
  sensed->attributes = sensed->object.attributes(sensed->length_m);
  const TriangleMesh& mesh_O = sensed->object.mesh_O;
  sensed->scene = build_scene(collision_, mesh_O);

  std::vector<Eigen::Vector3d> axes;
  sensed->profiles.reserve(planes_.size());
  for (const auto& plane : planes_) {
    auto known = std::find(axes.begin(), axes.end(), plane.a);
    if (known == axes.end()) {
      sensed->profiles.emplace_back(mesh_O, plane.a);
      axes.push_back(plane.a);
      known = axes.end() - 1;
    }
    sensed->profile_of.push_back(static_cast<std::size_t>(known - axes.begin()));
    sensed->half_extent_a_m.push_back(furthest(mesh_O, plane.a));
    sensed->half_extent_o_m.push_back(furthest(mesh_O, plane.n_f));
  }
  return sensed;
}

}  // namespace preshape
