#include "preshape/geometry/section_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace preshape {

namespace {

void widen(SectionSpan& span, double value) {
  span.lower = span.empty ? value : std::min(span.lower, value);
  span.upper = span.empty ? value : std::max(span.upper, value);
  span.empty = false;
}

/// A vertex as a cut sees it: height along the axis, place along the transverse axis.
struct Corner {
  double height, place;
};

/// Where the segment from a (below the station) to b (above) crosses it. Both triangles of an edge ask in the
/// same direction, so they get the same number; clamped, so that rounding never leaves the segment.
double crossing(const Corner& a, const Corner& b, double station) {
  const double share = (station - a.height) / (b.height - a.height);
  const double place = a.place + share * (b.place - a.place);
  return std::clamp(place, std::min(a.place, b.place), std::max(a.place, b.place));
}

}  // namespace

SectionProfile::SectionProfile(const TriangleMesh& mesh, const Eigen::Vector3d& axis) : mesh_(&mesh) {
  heights_.reserve(mesh.vertices.size());
  for (const auto& vertex : mesh.vertices) heights_.push_back(axis.dot(vertex));
  const std::size_t count = mesh.triangles.size();
  std::vector<double> lower(count);
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle& corners = mesh.triangles[t];
    const auto height = [&](int k) { return heights_[static_cast<std::size_t>(corners[k])]; };
    const auto [low, high] = std::minmax({height(0), height(1), height(2)});
    lower[t] = low;
    longest_ = std::max(longest_, high - low);
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

SectionSpan SectionProfile::cut(double station, const Eigen::Vector3d& transverse) const {
  SectionSpan span;
  // A hair further down: longest_ is a rounded difference, and a triangle that just reaches the plane counts.
  constexpr double kSlack = 4 * std::numeric_limits<double>::epsilon();
  const double lowest = station - longest_ - kSlack * (std::abs(station) + longest_);
  auto i = std::lower_bound(lower_.begin(), lower_.end(), lowest) - lower_.begin();
  for (; i < std::ssize(lower_) && lower_[static_cast<std::size_t>(i)] <= station; ++i) {
    const Triangle& triangle =
        mesh_->triangles[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
    Corner corners[3];
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(triangle[k]);
      corners[k] = {heights_[vertex], transverse.dot(mesh_->vertices[vertex])};
    }
    for (int k = 0; k < 3; ++k) {
      Corner a = corners[k], b = corners[(k + 1) % 3];
      // A corner in the plane belongs to the section: with it a side or a face that lies in the plane.
      if (a.height == station) widen(span, a.place);
      if (a.height > b.height) std::swap(a, b);
      if (a.height < station && station < b.height) widen(span, crossing(a, b, station));
    }
  }
  return span;
}

}  // namespace preshape
