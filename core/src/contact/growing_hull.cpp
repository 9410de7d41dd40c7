#include "growing_hull.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace preshape {

namespace {

constexpr double kTolerance = 1e-11;        ///< share of the space's radius
constexpr double kFlat = 1e-9;              ///< the same, for the width of a space that counts as flat
constexpr std::size_t kMostPoints = 65535;  ///< four of their numbers are packed into one key
constexpr double kPlane = 1e-3;  ///< share of the tolerance that a vertex may be off its facet's plane

/// The unit vector across five rows, by elimination with complete pivoting; zero when they are dependent.
WrenchVector across(Eigen::Matrix<double, 5, 6> rows) {
  std::array<int, 6> order = {0, 1, 2, 3, 4, 5};
  for (int k = 0; k < 5; ++k) {
    Eigen::Index r, c;
    if (rows.bottomRightCorner(5 - k, 6 - k).cwiseAbs().maxCoeff(&r, &c) == 0.0) return WrenchVector::Zero();
    if (r != 0) rows.row(k).swap(rows.row(k + r));
    if (c != 0) rows.col(k).swap(rows.col(k + c)), std::swap(order[k], order[k + c]);
    for (int i = k + 1; i < 5; ++i) {
      rows.row(i).tail(5 - k) -= rows(i, k) / rows(k, k) * rows.row(k).tail(5 - k);
    }
  }
  WrenchVector x;
  x[5] = 1.0;
  for (int k = 4; k >= 0; --k) x[k] = -rows.row(k).tail(5 - k).dot(x.tail(5 - k)) / rows(k, k);
  WrenchVector n;
  for (int k = 0; k < 6; ++k) n[order[k]] = x[k];
  return n.normalized();
}

/// An orthonormal basis that grows, the rest of the space behind it.
class Span {
 public:
  int dimension() const { return dimension_; }
  auto rest() const { return axes_.rightCols(6 - dimension_); }
  double distance(const WrenchVector& v) const { return (rest().transpose() * v).norm(); }
  /// Turns the rest so that v's part in it comes first (Householder), and counts that in.
  void add(const WrenchVector& v) {
    const Eigen::VectorXd part = rest().transpose() * v;
    Eigen::VectorXd mirror = part;
    mirror[0] += std::copysign(part.norm(), part[0]);
    const Eigen::MatrixXd before = rest();
    axes_.rightCols(6 - dimension_) -= 2.0 / mirror.squaredNorm() * (before * mirror) * mirror.transpose();
    ++dimension_;
  }

 private:
  Eigen::Matrix<double, 6, 6> axes_ = Eigen::Matrix<double, 6, 6>::Identity();
  int dimension_ = 0;
};

/// The vertex among those along the axes of the rest that is farthest from the span through `origin`.
WrenchVector farthest(const GraspWrenchSpace& space, const Span& span, const WrenchVector& origin) {
  WrenchVector best = origin;
  double most = 0.0;
  for (Eigen::Index k = 0; k < span.rest().cols(); ++k) {
    for (const double sign : {1.0, -1.0}) {
      const WrenchVector v = space.support(sign * span.rest().col(k));
      const double distance = span.distance(v - origin);
      if (distance > most) most = distance, best = v;
    }
  }
  return best;
}

}  // namespace

std::optional<GrowingHull> GrowingHull::inside(const GraspWrenchSpace& space) {
  GrowingHull hull;
  hull.facets_.reserve(512);
  hull.tolerance_ = kTolerance * space.radius();
  hull.points_.push_back(space.support(WrenchVector::Ones()));
  Span span;
  while (span.dimension() < 6) {
    hull.points_.push_back(farthest(space, span, hull.points_.front()));
    const WrenchVector edge = hull.points_.back() - hull.points_.front();
    if (span.distance(edge) <= kFlat * space.radius()) return std::nullopt;
    span.add(edge);
  }
  hull.inner_.setZero();
  for (const WrenchVector& p : hull.points_) hull.inner_ += p / 7.0;
  for (int left_out = 0; left_out < 7; ++left_out) {
    std::array<int, 6> vertices, neighbours;
    for (int i = 0; i < 6; ++i) vertices[i] = neighbours[i] = i + (i >= left_out);
    Facet& facet = hull.facets_.emplace_back();
    facet.vertex = vertices;
    facet.across = neighbours;  // facet k is the one without point k
    if (!hull.lay_plane(facet)) return std::nullopt;
  }
  return hull;
}

bool GrowingHull::lay_plane(Facet& facet) const {
  Eigen::Matrix<double, 5, 6> edges;
  const WrenchVector& p = points_[facet.vertex[5]];
  for (int i = 0; i < 5; ++i) edges.row(i) = (points_[facet.vertex[i]] - p).transpose();
  facet.n = across(edges);
  facet.offset = facet.n.dot(p);
  const double depth = facet.offset - facet.n.dot(inner_);
  if (depth < 0.0) facet.n = -facet.n, facet.offset = -facet.offset;
  return std::abs(depth) > tolerance_;
}

/// The plane through the apex and the ridge of two facets is one of the pencil that theirs span.
bool GrowingHull::lay_plane(Facet& facet, const Facet& seen, const Facet& beyond) const {
  const WrenchVector& apex = points_[facet.vertex[5]];
  const double above = seen.n.dot(apex) - seen.offset, below = beyond.offset - beyond.n.dot(apex);
  const WrenchVector n = below * seen.n + above * beyond.n;
  const double length = n.norm();
  if (!(length > 0.0)) return lay_plane(facet);
  facet.n = n / length;
  facet.offset = facet.n.dot(apex);
  double missed = 0.0;
  for (int i = 0; i < 5; ++i)
    missed = std::max(missed, std::abs(facet.n.dot(points_[facet.vertex[i]]) - facet.offset));
  if (missed > kPlane * tolerance_) return lay_plane(facet);
  return facet.offset - facet.n.dot(inner_) > tolerance_;
}

void GrowingHull::collect_visible(const WrenchVector& point, int seen) {
  ++visit_;
  visible_.assign(1, seen);
  facets_[seen].visit = visit_;
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    for (const int next : facets_[visible_[k]].across) {
      Facet& facet = facets_[next];
      if (facet.visit == visit_ || facet.n.dot(point) <= facet.offset + tolerance_) continue;
      facet.visit = visit_;
      visible_.push_back(next);
    }
  }
}

bool GrowingHull::cover_horizon(int apex) {
  for (const int v : visible_) {
    for (int i = 0; i < 6; ++i) {
      const int beyond = facets_[v].across[i];
      if (facets_[beyond].visit == visit_) continue;
      const int made = static_cast<int>(facets_.size());
      Facet& facet = facets_.emplace_back();
      for (int k = 0; k < 5; ++k) facet.vertex[k] = facets_[v].vertex[k + (k >= i)];
      facet.vertex[5] = apex;  // the largest number: still ascending
      facet.across[5] = beyond;
      if (!lay_plane(facet, facets_[v], facets_[beyond])) return false;
      auto& back = facets_[beyond].across;
      *std::find(back.begin(), back.end(), v) = made;
    }
  }
  for (const int v : visible_) facets_[v].alive = false;
  return true;
}

/// Two new facets meet at each ridge that has the new vertex.
bool GrowingHull::join_new_facets(std::size_t first) {
  const std::size_t size = std::bit_ceil(10 * (facets_.size() - first) + 1);
  ridges_.assign(size, Ridge{});
  std::size_t open = 0;
  for (std::size_t f = first; f < facets_.size(); ++f) {
    for (int left_out = 0; left_out < 5; ++left_out) {
      std::uint64_t key = 0;
      for (int k = 0; k < 5; ++k) {
        if (k != left_out) key = key << 16 | static_cast<std::uint64_t>(facets_[f].vertex[k]);
      }
      std::size_t at = key * 0x9E3779B97F4A7C15u >> 32;
      while (ridges_[at & (size - 1)].facet != kFree && ridges_[at & (size - 1)].key != key) ++at;
      Ridge& ridge = ridges_[at & (size - 1)];
      if (ridge.facet == kFree) {
        ridge = {key, static_cast<int>(f), left_out};
        ++open;
        continue;
      }
      if (ridge.facet == kJoined) return false;
      facets_[ridge.facet].across[ridge.left_out] = static_cast<int>(f);
      facets_[f].across[left_out] = ridge.facet;
      ridge.facet = kJoined;
      --open;
    }
  }
  return open == 0;
}

bool GrowingHull::add(const WrenchVector& point, int seen) {
  if (points_.size() >= kMostPoints) return false;
  points_.push_back(point);
  collect_visible(point, seen);
  const std::size_t first = facets_.size();
  return cover_horizon(static_cast<int>(points_.size()) - 1) && join_new_facets(first);
}

}  // namespace preshape
