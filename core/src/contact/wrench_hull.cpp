#include "preshape/contact/wrench_hull.h"

#include <cmath>
#include <limits>
#include <queue>

#include <fmt/format.h>

#include "growing_hull.h"
#include "preshape/base/assert.h"
#include "preshape/base/error.h"
#include "preshape/base/random.h"

namespace preshape {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kAttempts = 4;
constexpr double kJoggle = 1e-10;         ///< share of the space's radius
constexpr std::size_t kMostFacets = 2'000'000;

/// The space with each primitive wrench moved a little, the same way each time.
GraspWrenchSpace joggled(const GraspWrenchSpace& space, int attempt) {
  Random random(static_cast<std::uint64_t>(attempt));
  const double most = kJoggle * std::pow(10.0, attempt - 1) * space.radius();
  WrenchBasis moved = space.primitives();
  for (double& x : moved.reshaped()) x += random.uniform(-most, most);
  return {std::move(moved), space.per_contact(), space.bound()};
}

/// What `compute` makes of the space, or of joggled ones while it has nothing to say.
template <class Result, class Compute>
Result robustly(const GraspWrenchSpace& space, const Compute& compute) {
  if (const std::optional<Result> result = compute(space)) return *result;
  for (int attempt = 1; attempt < kAttempts; ++attempt) {
    if (const std::optional<Result> result = compute(joggled(space, attempt))) return *result;
  }
  throw InputError("grasp wrench space: rounding spoils its hull; use fewer edges (`resolution`)");
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

/// Nothing when rounding spoils the hull.
std::optional<double> volume(const GraspWrenchSpace& space, std::size_t most_facets) {
  auto hull = GrowingHull::inside(space);
  if (!hull) return 0.0;
  for (std::size_t i = 0; i < hull->facets().size(); ++i) {
    const GrowingHull::Facet& facet = hull->facets()[i];
    if (!facet.alive) continue;
    const WrenchVector vertex = space.support(facet.n);
    if (facet.n.dot(vertex) <= facet.offset + hull->tolerance()) continue;
    if (!hull->add(vertex, static_cast<int>(i))) return std::nullopt;
    if (hull->facets().size() > most_facets) {
      throw InputError(fmt::format("grasp wrench space: its hull takes more than {} facets; use fewer edges "
                                   "(`resolution`) or leave the volume out",
                                   most_facets));
    }
  }
  return hull->volume();
}

}  // namespace

EllipsoidFit largest_ellipsoid(const GraspWrenchSpace& space, const WrenchEllipsoid& ellipsoid) {
  PRESHAPE_DEMAND(ellipsoid.centre.allFinite() && ellipsoid.half_axes.allFinite());
  return robustly<EllipsoidFit>(space, [&](const GraspWrenchSpace& s) { return fit(s, ellipsoid); });
}

double wrench_space_volume(const GraspWrenchSpace& space, std::size_t most_facets) {
  return robustly<double>(space, [&](const GraspWrenchSpace& s) { return volume(s, most_facets); });
}

}  // namespace preshape
