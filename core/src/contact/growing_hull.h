#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "preshape/contact/grasp_wrench_space.h"

namespace preshape {

/// A convex polytope in six dimensions that grows vertex by vertex; its facets are simplices that know their
/// neighbours.
class GrowingHull {
 public:
  struct Facet {
    std::array<int, 6> vertex;  ///< ascending
    std::array<int, 6> across;  ///< facet beyond the ridge that leaves vertex i out
    WrenchVector n;             ///< outward unit normal
    double offset;              ///< n.x = offset on it
    bool alive = true;
    int visit = 0;
  };

  /// Starts as a simplex of vertices of the space. @returns nothing when the space has fewer than six
  /// dimensions
  static std::optional<GrowingHull> inside(const GraspWrenchSpace& space);

  const std::vector<Facet>& facets() const { return facets_; }
  /// Distances below it count as zero.
  double tolerance() const { return tolerance_; }

  /// Takes a point in that is beyond facet `seen` by more than the tolerance; new facets come last.
  /// @returns false when rounding has made the polytope inconsistent: it is of no use any more
  bool add(const WrenchVector& point, int seen);

 private:
  GrowingHull() = default;
  static constexpr int kFree = -1, kJoined = -2;
  struct Ridge {
    std::uint64_t key = 0;  ///< its four vertices besides the new one
    int facet = kFree, left_out = 0;
  };
  /// The plane through the facet's vertices. @returns false when they do not span one clear of the inner
  /// point
  bool lay_plane(Facet& facet) const;
  bool lay_plane(Facet& facet, const Facet& seen, const Facet& beyond) const;
  void collect_visible(const WrenchVector& point, int seen);
  bool cover_horizon(int apex);
  bool join_new_facets(std::size_t first);

  std::vector<WrenchVector> points_;
  std::vector<Facet> facets_;
  std::vector<int> visible_;
  std::vector<Ridge> ridges_;  ///< a hash table
  WrenchVector inner_;
  double tolerance_ = 0.0;
  int visit_ = 0;
};

}  // namespace preshape
