#include <algorithm>
#include <numeric>

#include "preshape/geometry/triangle_mesh.h"

namespace preshape {

namespace {

/// A triangle's side, the lower vertex in the upper half of the key.
struct Side {
  std::uint64_t key;
  std::int32_t triangle;
  bool rising;  ///< the triangle runs from the lower to the higher vertex
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::uint32_t>(mesh.triangles[t][k]);
      const auto to = static_cast<std::uint32_t>(mesh.triangles[t][(k + 1) % 3]);
      const std::uint64_t key = (std::uint64_t{std::min(from, to)} << 32) | std::max(from, to);
      sides.push_back({key, static_cast<std::int32_t>(t), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
  });
  return sides;
}

/// Union-find over triangles.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parent_(count), count_(static_cast<int>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a), b = root(b);
    if (a == b) return;
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    --count_;
  }
  int count() const { return count_; }

 private:
  std::int32_t root(std::int32_t i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      auto& above = parent_[static_cast<std::size_t>(i)];
      above = parent_[static_cast<std::size_t>(above)];
      i = above;
    }
    return i;
  }
  std::vector<std::int32_t> parent_;
  int count_;
};

}  // namespace

MeshTopology mesh_topology(const TriangleMesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh);
  Pieces pieces(mesh.triangles.size());
  MeshTopology topology;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    int balance = sides[i].rising ? 1 : -1;
    for (end = i + 1; end < sides.size() && sides[end].key == sides[i].key; ++end) {
      pieces.join(sides[i].triangle, sides[end].triangle);
      balance += sides[end].rising ? 1 : -1;
    }
    const std::size_t triangles = end - i;
    if (triangles == 1) ++topology.open_edges;
    if (triangles > 2) ++topology.non_manifold_edges;
    if (balance != 0) ++topology.unbalanced_edges;
    if (triangles == 2 && sides[i].rising == sides[i + 1].rising) ++topology.inconsistent_edges;
  }
  topology.pieces = pieces.count();
  return topology;
}

}  // namespace preshape
