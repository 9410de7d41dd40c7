#pragma once

#include <vector>

#include "preshape/base/random.h"
#include "preshape/geometry/triangle_mesh.h"
#include "preshape/hand/posture.h"

namespace preshape {

/// Where a fingertip can be, as cells of a regular grid in H that some posture within the limits puts it in.
struct FingerWorkspace {
  double cell_m = 0.0;                          ///< edge of a cell
  std::vector<Eigen::Vector3d> cells_H;         ///< middles of the cells, ordered by x, y, z
  Box box_H;                                    ///< around the fingertips
  double volume_m3() const { return static_cast<double>(cells_H.size()) * cell_m * cell_m * cell_m; }
};

/// Sampled by `samples` drawn postures. Every cell that a fingertip is in counts whole, so that the volume is above the true
/// one by about half a cell all round; too few samples leave cells out.
PRESHAPE_API FingerWorkspace finger_workspace(const HandModel& hand, int finger, int samples, double cell_m, Random& random);

/// How far thumb and a forefinger can be apart along the opposition axis Y while one stands before the other, that is in
/// the same cell across it.
struct OppositionRange {
  bool opposed = false;                        ///< their workspaces stand before each other anywhere
  double least_m = 0.0, most_m = 0.0;          ///< of forefinger's y minus thumb's y, not below 0
};
PRESHAPE_API OppositionRange opposition_range(const FingerWorkspace& thumb, const FingerWorkspace& forefinger);

}  // namespace preshape
