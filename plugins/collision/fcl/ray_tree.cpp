#include "ray_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fcl_mesh.h"
#include "preshape/geometry/query_checks.h"

namespace {

using namespace preshape;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Boxes are grown by this share of the extent and the ray's way to it: more than the rounding of the test
/// itself and of the triangle test, so that no box hides a triangle that would be met.
constexpr double kMargin = 1e-12;

/// Where the ray enters a box; never, when it passes by.
class BoxProbe {
 public:
  BoxProbe(const Ray& ray, double margin)
      : origin_(ray.origin), inverse_(ray.direction.cwiseInverse()), margin_(margin) {}

  double enter(const fcl::AABBd& box) const {
    double from = 0.0, to = kNever;
    for (int k = 0; k < 3; ++k) {
      const double lower = box.min_[k] - margin_ - origin_[k], upper = box.max_[k] + margin_ - origin_[k];
      // Parallel to the sides, both are infinite: of one sign, and the ray passes by, or not, and there is no limit.
      // Zero times infinity comes at the margin's own end only, where either answer is right.
      const double first = lower * inverse_[k], second = upper * inverse_[k];
      from = std::max(from, std::min(first, second));
      to = std::min(to, std::max(first, second));
    }
    return from <= to ? from : kNever;
  }

 private:
  Eigen::Vector3d origin_, inverse_;
  double margin_;
};

}  // namespace

RayTree::RayTree(TriangleMeshView mesh, const std::vector<std::int32_t>& touchable) {
  for (const std::int32_t t : touchable) {
    const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(corners[k])]; };
    faces_.push_back({corner(0), corner(1), corner(2), t});
  }
  extent_ = extent_of(mesh);
  fill(tree_, mesh, touchable);
}

RayHit RayTree::cast(const Ray& ray) const {
  NearestHit nearest(extent_);
  if (faces_.empty()) return nearest.hit();
  const RayProbe probe(ray);
  const BoxProbe boxes(ray, kMargin * (extent_ + (ray.origin - tree_.getBV(0).bv.center()).norm()));
  struct Step {
    int node;
    double enter;
  };
  std::vector<Step> open;
  open.push_back({0, boxes.enter(tree_.getBV(0).bv)});
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    if (std::isinf(step.enter) || step.enter > nearest.limit()) continue;
    const auto& node = tree_.getBV(step.node);
    if (node.isLeaf()) {
      const Face& face = faces_[static_cast<std::size_t>(node.primitiveId())];
      nearest.offer(probe.distance(face.a, face.b, face.c), face.triangle);
      continue;
    }
    Step near{node.leftChild(), boxes.enter(tree_.getBV(node.leftChild()).bv)};
    Step far{node.rightChild(), boxes.enter(tree_.getBV(node.rightChild()).bv)};
    if (near.enter > far.enter) std::swap(near, far);
    open.push_back(far);
    open.push_back(near);  // looked at first: its hit may make the other one needless
  }
  return nearest.hit();
}
