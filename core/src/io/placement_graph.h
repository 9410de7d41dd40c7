#pragma once

#include <cstdint>
#include <vector>

namespace preshape {

/// Which parts of a scene file place which others, by number.
struct PlacementGraph {
  std::vector<std::vector<std::size_t>> placed_by;  ///< [part]: the parts that it places, as often as it does

  /// @throws InputError when a part places itself, when placements are nested more than 256 deep, or when
  /// there are
  ///         more than a million once all are carried out
  void check() const;
};

}  // namespace preshape
