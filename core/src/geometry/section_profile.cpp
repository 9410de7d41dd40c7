#include "preshape/geometry/section_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "preshape/base/assert.h"

namespace preshape {

namespace {

void widen(SectionSpan& span, double value) {
  span.lower = span.empty ? value : std::min(span.lower, value);
  span.upper = span.empty ? value : std::max(span.upper, value);
  span.empty = false;
}

/// Where the segment from a (below the station) to b (above) crosses it. Both triangles of an edge ask in the
/// same direction, so they get the same number; clamped, so that rounding never leaves the segment.
double crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int axis, double station, int transverse) {
  const double share = (station - a[axis]) / (b[axis] - a[axis]);
  const double value = a[transverse] + share * (b[transverse] - a[transverse]);
  return std::clamp(value, std::min(a[transverse], b[transverse]), std::max(a[transverse], b[transverse]));
}

}  // namespace

SectionProfile::SectionProfile(const TriangleMesh& mesh, int axis) : mesh_(&mesh), axis_(axis) {
  PRESHAPE_DEMAND(axis >= 0 && axis < 3);
  const std::size_t count = mesh.triangles.size();
  std::vector<double> lower(count);
  for (std::size_t t = 0; t < count; ++t) {
    const double a = mesh.corner(t, 0)[axis], b = mesh.corner(t, 1)[axis], c = mesh.corner(t, 2)[axis];
    lower[t] = std::min({a, b, c});
    longest_ = std::max(longest_, std::max({a, b, c}) - lower[t]);
  }
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
    const double la = lower[static_cast<std::size_t>(a)], lb = lower[static_cast<std::size_t>(b)];
    return la != lb ? la < lb : a < b;
  });
  lower_.resize(count);
  for (std::size_t i = 0; i < count; ++i) lower_[i] = lower[static_cast<std::size_t>(order_[i])];
}

SectionSpan SectionProfile::cut(double station, int transverse) const {
  PRESHAPE_DEMAND(transverse >= 0 && transverse < 3 && transverse != axis_);
  SectionSpan span;
  // A hair further down: longest_ is a rounded difference, and a triangle that just reaches the plane counts.
  constexpr double kSlack = 4 * std::numeric_limits<double>::epsilon();
  const double lowest = station - longest_ - kSlack * (std::abs(station) + longest_);
  auto i = std::lower_bound(lower_.begin(), lower_.end(), lowest) - lower_.begin();
  for (; i < std::ssize(lower_) && lower_[static_cast<std::size_t>(i)] <= station; ++i) {
    const auto t = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d *a = &mesh_->corner(t, k), *b = &mesh_->corner(t, (k + 1) % 3);
      if ((*a)[axis_] > (*b)[axis_]) std::swap(a, b);
      // A corner in the plane belongs to the section: with it a side or a face that lies in the plane.
      if ((*a)[axis_] == station) widen(span, (*a)[transverse]);
      if ((*b)[axis_] == station) widen(span, (*b)[transverse]);
      if ((*a)[axis_] < station && station < (*b)[axis_]) widen(span, crossing(*a, *b, axis_, station, transverse));
    }
  }
  return span;
}

}  // namespace preshape
