#include "geometry/convex_hull.h"

#include <algorithm>
#include <limits>

namespace preshape {

namespace {

constexpr double kThickness = 1e-9;  // of the extent

using Points = std::vector<Eigen::Vector3d>;
using Index = std::int32_t;

const Eigen::Vector3d& at(const Points& points, Index i) {
  return points[static_cast<std::size_t>(i)];
}

struct Facet {
  std::array<Index, 3> corners;
  std::array<Index, 3> neighbours;  ///< across the side from corner k to corner k + 1
  Eigen::Vector3d normal;
  double offset = 0.0;
  std::vector<Index> outside;  ///< points in front of it, each kept by one facet only
  double farthest = 0.0;       ///< distance of outside.back()
  bool alive = true;
};

class Quickhull {
 public:
  explicit Quickhull(const Points& points) : points_(points) {}

  ConvexHull build() {
    if (!start()) return {};
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      while (facets_[f].alive && !facets_[f].outside.empty()) grow(static_cast<Index>(f));
    }
    return result();
  }

 private:
  Facet& facet(Index f) { return facets_[static_cast<std::size_t>(f)]; }

  double height(const Facet& f, Index point) const { return f.normal.dot(at(points_, point)) - f.offset; }

  Facet make(Index a, Index b, Index c) const {
    Facet f{{a, b, c}, {-1, -1, -1}, Eigen::Vector3d::Zero(), 0.0, {}, 0.0, true};
    f.normal = (at(points_, b) - at(points_, a)).cross(at(points_, c) - at(points_, a)).normalized();
    f.offset = f.normal.dot(at(points_, a));
    return f;
  }

  /// The point for which `value` is largest, the first of equal ones.
  template <class Value>
  Index farthest(Value value) const {
    Index best = 0;
    double best_value = -std::numeric_limits<double>::infinity();
    for (Index i = 0; i < static_cast<Index>(points_.size()); ++i) {
      const double v = value(at(points_, i));
      if (v > best_value) best_value = v, best = i;
    }
    return best;
  }

  /// A first tetrahedron; false when the points are flat.
  bool start() {
    if (points_.size() < 4) return false;
    const Index a = farthest([](const auto& p) { return -p.x(); });
    const Eigen::Vector3d& pa = at(points_, a);
    const Index b = farthest([&](const auto& p) { return (p - pa).squaredNorm(); });
    const double extent = (at(points_, b) - pa).norm();
    tolerance_ = kThickness * extent;
    const Eigen::Vector3d along = (at(points_, b) - pa) / (extent > 0 ? extent : 1.0);
    Index c = farthest([&](const auto& p) { return (p - pa).cross(along).squaredNorm(); });
    if (!((at(points_, c) - pa).cross(along).norm() > tolerance_)) return false;
    const Eigen::Vector3d up = along.cross(at(points_, c) - pa).normalized();
    const Index d = farthest([&](const auto& p) { return std::abs(up.dot(p - pa)); });
    const double side = up.dot(at(points_, d) - pa);
    if (!(std::abs(side) > tolerance_)) return false;
    Index bb = b;
    if (side > 0) std::swap(bb, c);
    facets_ = {make(a, bb, c), make(a, c, d), make(c, bb, d), make(bb, a, d)};
    facets_[0].neighbours = {3, 2, 1};
    facets_[1].neighbours = {0, 2, 3};
    facets_[2].neighbours = {0, 3, 1};
    facets_[3].neighbours = {0, 1, 2};
    std::vector<Index> all;
    for (Index i = 0; i < static_cast<Index>(points_.size()); ++i) all.push_back(i);
    share_out(all, 0);
    return true;
  }

  /// Gives each point to the first facet from `first` on that it lies in front of.
  void share_out(const std::vector<Index>& points, std::size_t first) {
    for (const Index i : points) {
      for (std::size_t f = first; f < facets_.size(); ++f) {
        const double h = height(facets_[f], i);
        if (!(h > tolerance_)) continue;
        auto& outside = facets_[f].outside;
        outside.push_back(i);
        if (h > facets_[f].farthest)
          facets_[f].farthest = h;
        else
          std::swap(outside[outside.size() - 1], outside[outside.size() > 1 ? outside.size() - 2 : 0]);
        break;
      }
    }
  }

  struct HorizonSide {
    Index from, to, beyond;
  };

  /// Adds the farthest point of a facet: the facets it sees go, a cone over their outline comes.
  void grow(Index f) {
    const Index apex = facet(f).outside.back();
    facet(f).outside.pop_back();
    std::vector<Index> seen;
    std::vector<HorizonSide> horizon;
    look(f, apex, seen, horizon);
    if (!order(horizon)) {  // rounding tied a knot into the outline: leave this point out
      for (const Index s : seen) facet(s).alive = true;
      renew_farthest(facet(f));
      return;
    }
    std::vector<Index> orphans;
    for (const Index s : seen) {
      for (const Index i : facet(s).outside) orphans.push_back(i);
      facet(s).outside = {};
    }
    std::sort(orphans.begin(), orphans.end());
    const std::size_t first = facets_.size();
    attach(horizon, apex);
    share_out(orphans, first);
  }

  /// Collects the connected facets that see the apex, and the sides of their outline.
  void look(Index f, Index apex, std::vector<Index>& seen, std::vector<HorizonSide>& horizon) {
    facet(f).alive = false;
    seen.push_back(f);
    for (std::size_t next = 0; next < seen.size(); ++next) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index n = facet(seen[next]).neighbours[k];
        if (!facet(n).alive || !(height(facet(n), apex) > tolerance_)) continue;
        facet(n).alive = false;
        seen.push_back(n);
      }
    }
    for (const Index s : seen) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index n = facet(s).neighbours[k];
        if (facet(n).alive) horizon.push_back({facet(s).corners[k], facet(s).corners[(k + 1) % 3], n});
      }
    }
  }

  /// Puts the outline's sides in turn; false when they are not one simple ring.
  static bool order(std::vector<HorizonSide>& horizon) {
    if (horizon.size() < 3) return false;
    for (std::size_t i = 0; i + 1 < horizon.size(); ++i) {
      std::size_t next = i + 1;
      while (next < horizon.size() && horizon[next].from != horizon[i].to) ++next;
      if (next == horizon.size()) return false;
      std::swap(horizon[i + 1], horizon[next]);
    }
    return horizon.back().to == horizon.front().from;
  }

  void attach(const std::vector<HorizonSide>& horizon, Index apex) {
    const auto first = static_cast<Index>(facets_.size());
    const auto count = static_cast<Index>(horizon.size());
    for (Index i = 0; i < count; ++i) {
      const HorizonSide& side = horizon[static_cast<std::size_t>(i)];
      Facet f = make(side.from, side.to, apex);
      f.neighbours = {side.beyond, first + (i + 1) % count, first + (i + count - 1) % count};
      Facet& beyond = facet(side.beyond);
      for (std::size_t k = 0; k < 3; ++k) {
        if (beyond.corners[k] == side.to && beyond.corners[(k + 1) % 3] == side.from)
          beyond.neighbours[k] = first + i;
      }
      facets_.push_back(std::move(f));
    }
  }

  void renew_farthest(Facet& f) {
    std::sort(f.outside.begin(), f.outside.end(),
              [&](Index a, Index b) { return height(f, a) < height(f, b); });
    f.farthest = f.outside.empty() ? 0.0 : height(f, f.outside.back());
  }

  ConvexHull result() const {
    ConvexHull hull;
    std::vector<Index> number(points_.size(), -1);
    for (const Facet& f : facets_) {
      if (!f.alive) continue;
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        Index& n = number[static_cast<std::size_t>(f.corners[static_cast<std::size_t>(k)])];
        if (n < 0) {
          n = static_cast<Index>(hull.points.size());
          hull.points.push_back(at(points_, f.corners[static_cast<std::size_t>(k)]));
        }
        triangle[k] = n;
      }
      hull.facets.push_back(triangle);
    }
    return hull;
  }

  const Points& points_;
  std::vector<Facet> facets_;
  double tolerance_ = 0.0;
};

}  // namespace

ConvexHull convex_hull(const Points& points) {
  return Quickhull(points).build();
}

std::vector<Eigen::Vector2d> convex_polygon(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> ring;
  const auto add = [&](const Eigen::Vector2d& p, std::size_t base) {
    while (ring.size() >= base + 2) {
      const Eigen::Vector2d u = ring.back() - ring[ring.size() - 2], v = p - ring.back();
      if (u.x() * v.y() - u.y() * v.x() > 0.0) break;
      ring.pop_back();
    }
    ring.push_back(p);
  };
  for (const auto& p : points) add(p, 0);
  const std::size_t lower = ring.size() - 1;
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) add(*p, lower);
  if (ring.size() > 1) ring.pop_back();
  return ring;
}

}  // namespace preshape
