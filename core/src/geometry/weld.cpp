#include "preshape/geometry/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace preshape {

namespace {

constexpr std::int32_t kNone = -1;

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

/// The vertices kept so far, by cell: chained lists in a hash table. Cells are a few tolerances wide, and
/// kept vertices are a tolerance apart, so that no cell ever holds more than a bounded number of them.
class KeptVertices {
 public:
  KeptVertices(const std::vector<Eigen::Vector3d>& vertices, double tolerance)
      : vertices_(vertices),
        tolerance_(tolerance),
        next_(vertices.size(), kNone),
        heads_(std::bit_ceil(2 * vertices.size() + 1), kNone) {
    Eigen::Vector3d upper = lower_ = vertices.front();
    for (const auto& p : vertices) lower_ = lower_.cwiseMin(p), upper = upper.cwiseMax(p);
    // The floor keeps cell numbers exact in a double; finer than that the coordinates themselves do not go.
    cell_ = std::max({kTolerancesPerCell * tolerance, 1e-15 * (upper - lower_).maxCoeff(), 1e-300});
  }

  /// The first kept vertex within the tolerance of vertex i, or kNone.
  std::int32_t find(std::int32_t i) const {
    const Eigen::Vector3d& p = vertices_[static_cast<std::size_t>(i)];
    const Cell from = cell_of(p.array() - tolerance_), to = cell_of(p.array() + tolerance_);
    std::int32_t first = kNone;
    Cell cell;
    for (cell[0] = from[0]; cell[0] <= to[0]; ++cell[0]) {
      for (cell[1] = from[1]; cell[1] <= to[1]; ++cell[1]) {
        for (cell[2] = from[2]; cell[2] <= to[2]; ++cell[2]) first = earlier(first, find_in(cell, p));
      }
    }
    return first;
  }

  void keep(std::int32_t i) {
    std::int32_t& head = heads_[slot(cell_of(vertices_[static_cast<std::size_t>(i)]))];
    next_[static_cast<std::size_t>(i)] = head;
    head = i;
  }

 private:
  static constexpr double kTolerancesPerCell = 8.0;  // most vertices then search one cell or two

  static std::int32_t earlier(std::int32_t a, std::int32_t b) {
    return a == kNone ? b : b == kNone ? a : std::min(a, b);
  }

  Cell cell_of(const Eigen::Vector3d& p) const {
    return ((p - lower_) / cell_).array().floor().cast<std::int64_t>();
  }

  std::size_t slot(const Cell& cell) const {
    std::uint64_t h = static_cast<std::uint64_t>(cell[0]) * 0x9e3779b97f4a7c15u;
    h = (std::rotl(h, 23) ^ static_cast<std::uint64_t>(cell[1])) * 0xbf58476d1ce4e5b9u;
    h = (std::rotl(h, 23) ^ static_cast<std::uint64_t>(cell[2])) * 0x94d049bb133111ebu;
    return (h ^ (h >> 31)) & (heads_.size() - 1);
  }

  std::int32_t find_in(const Cell& cell, const Eigen::Vector3d& p) const {
    std::int32_t first = kNone;
    for (std::int32_t k = heads_[slot(cell)]; k != kNone; k = next_[static_cast<std::size_t>(k)]) {
      if ((vertices_[static_cast<std::size_t>(k)] - p).norm() <= tolerance_) first = earlier(first, k);
    }
    return first;
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  double tolerance_;
  double cell_ = 1.0;
  Eigen::Vector3d lower_;
  std::vector<std::int32_t> next_, heads_;
};

/// For every vertex the one that stands for it.
std::vector<std::int32_t> representatives(const std::vector<Eigen::Vector3d>& vertices, double tolerance) {
  KeptVertices kept(vertices, tolerance);
  std::vector<std::int32_t> stands_for(vertices.size());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(vertices.size()); ++i) {
    const std::int32_t found = kept.find(i);
    stands_for[static_cast<std::size_t>(i)] = found == kNone ? i : found;
    if (found == kNone) kept.keep(i);
  }
  return stands_for;
}

/// Drops vertices that no triangle names and renumbers the others in their order.
void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<std::int32_t> number(mesh.vertices.size(), kNone);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::int32_t v : triangle) number[static_cast<std::size_t>(v)] = 0;
  }
  std::int32_t used = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    mesh.vertices[static_cast<std::size_t>(used)] = mesh.vertices[v];
    number[v] = used++;
  }
  mesh.vertices.resize(static_cast<std::size_t>(used));
  for (Triangle& triangle : mesh.triangles) {
    for (std::int32_t& v : triangle) v = number[static_cast<std::size_t>(v)];
  }
}

bool is_flat(const TriangleMesh& mesh, std::size_t t) {
  return preshape::is_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

int count_duplicates(const TriangleMesh& mesh) {
  std::vector<std::array<std::int32_t, 3>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    std::array<std::int32_t, 3> corners = {triangle[0], triangle[1], triangle[2]};
    std::sort(corners.begin(), corners.end());
    sorted.push_back(corners);
  }
  std::sort(sorted.begin(), sorted.end());
  int count = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) count += sorted[i] == sorted[i - 1];
  return count;
}

}  // namespace

WeldReport weld(TriangleMesh& mesh, double tolerance) {
  WeldReport report;
  if (mesh.vertices.empty()) return report;
  const auto stands_for = representatives(mesh.vertices, tolerance);
  for (std::size_t v = 0; v < stands_for.size(); ++v) {
    report.merged_vertices += stands_for[v] != static_cast<std::int32_t>(v);
  }
  for (Triangle& triangle : mesh.triangles) {
    for (std::int32_t& v : triangle) v = stands_for[static_cast<std::size_t>(v)];
  }
  const auto collapsed = [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; };
  report.collapsed_triangles = static_cast<int>(std::erase_if(mesh.triangles, collapsed));
  drop_unused_vertices(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) report.flat_triangles += is_flat(mesh, t);
  report.duplicate_triangles = count_duplicates(mesh);
  return report;
}

std::int64_t count_distinct(const std::vector<Eigen::Vector3d>& points, double tolerance) {
  if (points.empty()) return 0;
  const auto stands_for = representatives(points, tolerance);
  std::int64_t count = 0;
  for (std::size_t i = 0; i < stands_for.size(); ++i) count += stands_for[i] == static_cast<std::int32_t>(i);
  return count;
}

int drop_flat_triangles(TriangleMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_flat(mesh, t)) mesh.triangles[kept++] = mesh.triangles[t];
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  if (dropped > 0) drop_unused_vertices(mesh);
  return static_cast<int>(dropped);
}

}  // namespace preshape
