#include "preshape/contact/wrench_hull.h"

#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "growing_hull.h"
#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "preshape/base/random.h"

namespace preshape {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kJoggles = 3;
constexpr double kJoggle = 1e-10;               ///< share of the space's radius
constexpr std::size_t kMostFacets = 2'000'000;  ///< each takes some 150 bytes

/// The space with each primitive wrench moved a little, the same way each time.
GraspWrenchSpace joggled(const GraspWrenchSpace& space, int attempt) {
  Random random(static_cast<std::uint64_t>(attempt));
  const double most = kJoggle * std::pow(10.0, attempt - 1) * space.radius();
  WrenchBasis moved = space.primitives();
  for (double& x : moved.reshaped()) x += random.uniform(-most, most);
  return {std::move(moved), space.per_contact(), space.bound()};
}

/// The factor at which the ellipsoid meets the facet; negative when the origin is beyond it.
double meeting(const GrowingHull::Facet& facet, const WrenchEllipsoid& ellipsoid, double tolerance) {
  const double reach = ellipsoid.reach(facet.n);
  if (reach <= 0.0) return facet.offset >= -tolerance ? kInfinity : facet.offset;
  return facet.offset / reach;
}

/// Nothing when rounding spoils the hull.
std::optional<EllipsoidFit> fit(const GraspWrenchSpace& space, const WrenchEllipsoid& ellipsoid) {
  auto hull = GrowingHull::inside(space);
  if (!hull) return EllipsoidFit{};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  const auto queue = [&](std::size_t first) {
    for (std::size_t i = first; i < hull->facets().size(); ++i) {
      next.emplace(meeting(hull->facets()[i], ellipsoid, hull->tolerance()), static_cast<int>(i));
    }
  };
  queue(0);
  while (!next.empty() && hull->facets().size() < kMostFacets) {
    const auto [factor, index] = next.top();
    next.pop();
    const GrowingHull::Facet& facet = hull->facets()[index];
    if (!facet.alive) continue;
    const WrenchVector vertex = space.support(facet.n);
    const double reach = facet.n.dot(vertex);
    if (reach <= hull->tolerance() && ellipsoid.reach(facet.n) > 0.0) return EllipsoidFit{0.0, true};
    if (reach <= facet.offset + hull->tolerance()) return EllipsoidFit{std::max(0.0, factor), true};
    const std::size_t first = hull->facets().size();
    if (!hull->add(vertex, index)) return std::nullopt;
    queue(first);
  }
  return std::nullopt;
}

}  // namespace

EllipsoidFit largest_ellipsoid(const GraspWrenchSpace& space, const WrenchEllipsoid& ellipsoid) {
  PRESHAPE_DEMAND(ellipsoid.centre.allFinite() && ellipsoid.half_axes.allFinite());
  if (const auto found = fit(space, ellipsoid)) return *found;
  for (int attempt = 1; attempt <= kJoggles; ++attempt) {
    if (const auto found = fit(joggled(space, attempt), ellipsoid)) return *found;
  }
  throw InputError("grasp wrench space: rounding spoils its hull, or it takes too many facets; use fewer edges (`resolution`)");
}

}  // namespace preshape
