#include "geometry/smallest_box.h"

#include <algorithm>
#include <limits>
#include <map>

#include "geometry/convex_hull.h"

namespace preshape {

namespace {

constexpr std::size_t kMostFacets = 400;  // directions of the largest facets
constexpr std::size_t kMostEdges = 32;    // longest edges, every pair of which gives a direction
constexpr std::size_t kMostRefined = 12;
constexpr double kSameDirection = 1e-9;  // sine of the angle between directions that count as one

using Points = std::vector<Eigen::Vector3d>;

struct Candidate {
  Eigen::Matrix3d axes;
  double volume;
};

struct Rectangle {
  Eigen::Vector2d side;  ///< unit, along one side
  double area = std::numeric_limits<double>::infinity();
};

/// Smallest rectangle around a convex polygon: it has a side on one of the polygon's; the three other
/// contacts only ever move on while the sides are gone through [Toussaint1983].
Rectangle smallest_rectangle(const std::vector<Eigen::Vector2d>& ring) {
  if (ring.size() < 3) {
    const Eigen::Vector2d along =
        ring.size() == 2 ? Eigen::Vector2d(ring[1] - ring[0]) : Eigen::Vector2d(1, 0);
    return {along.normalized(), 0.0};
  }
  Rectangle best;
  const std::size_t n = ring.size();
  std::size_t right = 1, top = 1, left = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d side = (ring[(i + 1) % n] - ring[i]).normalized(), up(-side.y(), side.x());
    const auto climb = [&](std::size_t& at, const Eigen::Vector2d& along) {
      for (std::size_t step = 0; step < n && along.dot(ring[(at + 1) % n] - ring[at % n]) > 0.0; ++step) ++at;
    };
    right = std::max(right, i + 1);
    climb(right, side);
    top = std::max(top, right);
    climb(top, up);
    left = std::max(left, top);
    climb(left, -side);
    const double width = side.dot(ring[right % n] - ring[left % n]), height = up.dot(ring[top % n] - ring[i]);
    if (width * height < best.area) best = {side, width * height};
  }
  return best;
}

/// The smallest box with two sides across `direction`.
Candidate box_along(const Points& points, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
  std::vector<Eigen::Vector2d> shadow;
  shadow.reserve(points.size());
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const auto& p : points) {
    shadow.emplace_back(u.dot(p), v.dot(p));
    const double along = direction.dot(p);
    lower = std::min(lower, along), upper = std::max(upper, along);
  }
  const Rectangle rectangle = smallest_rectangle(convex_polygon(std::move(shadow)));
  Candidate box;
  box.axes.col(0) = direction;
  box.axes.col(1) = (rectangle.side.x() * u + rectangle.side.y() * v).normalized();
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  box.volume = (upper - lower) * rectangle.area;
  return box;
}

/// Longest first, opposite and equal directions once, at most `most`; zero vectors left out.
std::vector<Eigen::Vector3d> distinct_directions(Points vectors, std::size_t most) {
  std::stable_sort(vectors.begin(), vectors.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
  Points directions;
  for (const auto& vector : vectors) {
    if (directions.size() == most || !(vector.squaredNorm() > 0.0)) break;
    const Eigen::Vector3d unit = vector.normalized();
    const bool known = std::any_of(directions.begin(), directions.end(), [&](const auto& d) {
      return d.cross(unit).squaredNorm() < kSameDirection * kSameDirection;
    });
    if (!known) directions.push_back(unit);
  }
  return directions;
}

/// Edges between facets that are not in one plane.
Points sharp_edges(const TriangleMesh& hull) {
  std::map<std::pair<std::int32_t, std::int32_t>, Eigen::Vector3d> normal_beside;
  Points edges;
  for (std::size_t f = 0; f < hull.triangles.size(); ++f) {
    const Eigen::Vector3d normal = hull.area_vector(f).normalized();
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = hull.triangles[f][k], b = hull.triangles[f][(k + 1) % 3];
      const auto [known, is_new] = normal_beside.try_emplace(std::minmax(a, b), normal);
      if (is_new || known->second.cross(normal).norm() < kSameDirection) continue;
      edges.push_back(hull.corner(f, (k + 1) % 3) - hull.corner(f, k));
    }
  }
  return edges;
}

Points directions_to_try(const Points& points, const std::vector<Triangle>& facets) {
  const TriangleMesh hull{points, facets};
  Points across;
  for (std::size_t f = 0; f < facets.size(); ++f) across.push_back(hull.area_vector(f));
  Points directions = distinct_directions(std::move(across), kMostFacets);
  const Points edges = distinct_directions(sharp_edges(hull), kMostEdges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size(); ++k)
      directions.push_back(edges[i].cross(edges[k]).normalized());
  }
  return directions;
}

Candidate refined(const Points& points, Candidate box) {
  constexpr int kMostRounds = 50;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = box.volume;
    for (int k = 0; k < 3; ++k) {
      const Candidate turned = box_along(points, box.axes.col(k));
      if (turned.volume < box.volume) box = turned;
    }
    if (!(box.volume < before * (1.0 - 1e-12))) break;
  }
  return box;
}

/// Axes of points in a plane: its normal and the smallest rectangle in it.
Eigen::Matrix3d flat_axes(const Points& points) {
  const auto far_from = [&](auto value) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const auto& a, const auto& b) { return value(a) < value(b); });
  };
  const Eigen::Vector3d a = points.front();
  const Eigen::Vector3d along = (far_from([&](const auto& p) { return (p - a).norm(); }) - a).normalized();
  const Eigen::Vector3d aside = far_from([&](const auto& p) { return (p - a).cross(along).norm(); }) - a;
  return box_along(points, along.cross(aside).normalized()).axes;
}

}  // namespace

Eigen::Matrix3d smallest_box(const Points& points, const std::vector<Triangle>& facets,
                             std::span<const Eigen::Matrix3d> guesses) {
  if (facets.empty()) return flat_axes(points);
  std::vector<Candidate> tried;
  for (const auto& guess : guesses) {
    for (int k = 0; k < 3; ++k) tried.push_back(box_along(points, guess.col(k)));
  }
  for (const auto& direction : directions_to_try(points, facets))
    tried.push_back(box_along(points, direction));
  const auto smaller = [](const Candidate& a, const Candidate& b) { return a.volume < b.volume; };
  std::stable_sort(tried.begin(), tried.end(), smaller);
  tried.resize(std::min(tried.size(), kMostRefined));
  for (auto& candidate : tried) candidate = refined(points, candidate);
  return std::min_element(tried.begin(), tried.end(), smaller)->axes;
}

}  // namespace preshape
