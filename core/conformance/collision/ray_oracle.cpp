// Nearest hits in long double.
#include <cmath>

#include <fmt/format.h>

#include "oracle.h"

namespace preshape::conformance {

namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

enum class Meeting { kNo, kOpen, kYes };

struct Met {
  Meeting meeting = Meeting::kNo;
  Real distance = 0;
  Real slack = 0;  ///< of the distance
};

/// Of one ray and one triangle. @param scale what rounding goes with [m]
Met met(const Ray& ray, const Vector& a, const Vector& b, const Vector& c, Real scale) {
  constexpr Real kRounding = 1e-13L, kGrazing = 1e-6L, kAccuracy = 1e-9L;
  const Vector o = ray.origin.cast<Real>(), d = ray.direction.cast<Real>().normalized();
  const Vector area = (b - a).cross(c - a);
  const Real longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  if (!(area.norm() > kFlatTriangle * longest * longest)) return {};
  const Vector n = area.normalized();
  const Real steep = n.dot(d), height = n.dot(a - o), doubt = kRounding * scale;
  if (std::abs(steep) < kGrazing) {
    return {std::abs(height) <= kGrazing * scale ? Meeting::kOpen : Meeting::kNo, 0, INFINITY};
  }
  const Real t = height / steep;
  const Vector p = o + t * d;
  // How far inside of its sides the ray passes, seen along the ray as rounding sees it.
  Real inside = INFINITY;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
    inside = std::min(inside, n.cross((to - from).normalized()).dot(p - from));
  }
  const Real margin = doubt / std::abs(steep);
  if (inside < -margin || t < -kAccuracy * scale) return {};
  const bool sure = inside > margin && t > kAccuracy * scale;
  return {sure ? Meeting::kYes : Meeting::kOpen, t, kAccuracy * scale};
}

}  // namespace

std::string wrong_hit(const Body& body, const Ray& ray, const RayHit& hit) {
  if (std::isnan(hit.distance) || hit.distance < 0.0) return fmt::format("the distance is {}", hit.distance);
  if (hit.triangle < -1 || hit.triangle >= std::ssize(body.mesh.triangles) ||
      hit.met() != std::isfinite(hit.distance)) {
    return fmt::format("the hit is triangle {} of {} at {}", hit.triangle, body.mesh.triangles.size(),
                       hit.distance);
  }
  const Real scale =
      std::max(body.extent(), (ray.origin - body.centre()).norm()) + 1e-3 * body.centre().norm();
  for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
    const Met m = met(ray, body.mesh.corner(t, 0).cast<Real>(), body.mesh.corner(t, 1).cast<Real>(),
                      body.mesh.corner(t, 2).cast<Real>(), scale);
    const auto told = static_cast<Real>(hit.distance), index = static_cast<Real>(t);
    if (m.meeting == Meeting::kYes && m.distance + m.slack < told) {
      return fmt::format("it meets triangle {} at {}, nearer than what was told: triangle {} at {}", index,
                         static_cast<double>(m.distance), hit.triangle, hit.distance);
    }
    if (static_cast<std::int32_t>(t) != hit.triangle) continue;
    if (m.meeting == Meeting::kNo) return fmt::format("it does not meet triangle {}", t);
    if (!(std::abs(m.distance - told) <= m.slack)) {
      return fmt::format("it meets triangle {} at {}, not at {}", t, static_cast<double>(m.distance),
                         hit.distance);
    }
  }
  return "";
}

}  // namespace preshape::conformance
