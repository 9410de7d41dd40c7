#pragma once

#include <optional>
#include <string>
#include <vector>

#include "preshape/fuzzy/similarity.h"

namespace preshape {

/// How near the grasps of a workspace are to a task: a row a plane, a column a station.
struct HeatMap {
  struct Cell {
    std::optional<double> score;  ///< none: no grasp there
    std::string detail;           ///< why there is none
  };
  std::string title, measure;
  SimilarityScale scale;            ///< says which end is near
  std::vector<std::string> planes;  ///< names of the rows
  std::vector<double> stations;     ///< approach value over the half extent, ascending
  std::vector<Cell> cells;          ///< row by row; planes x stations

  const Cell& at(std::size_t plane, std::size_t station) const {
    return cells[plane * stations.size() + station];
  }
};

/// A drawing of it: the nearer, the lighter, on a scale that keeps its order in grey (cividis,
/// [NunezAndertonRenslow2018]); hatched where there is no grasp; the nearest one framed. Every cell tells its
/// number when it is pointed at, and shows it where there is room.
/// @throws InputError when `cells` has not planes x stations
PRESHAPE_API std::string heat_map_svg(const HeatMap& map);

}  // namespace preshape
