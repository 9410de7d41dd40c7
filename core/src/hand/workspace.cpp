#include "preshape/hand/workspace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace preshape {

namespace {

using Cell = std::array<long, 3>;

Cell cell_of(const Eigen::Vector3d& p, double edge) {
  return {std::lround(p.x() / edge), std::lround(p.y() / edge), std::lround(p.z() / edge)};
}

}  // namespace

FingerWorkspace finger_workspace(const HandModel& hand, int finger, int samples, double cell_m, Random& random) {
  FingerWorkspace workspace;
  workspace.cell_m = cell_m;
  std::set<Cell> cells;
  Posture posture = middle_posture(hand);
  const auto drives = driven_joints(hand);
  for (int i = 0; i < samples; ++i) {
    for (const int joint : drives) {
      const DriveRange range = drive_range(hand, joint);
      posture[static_cast<std::size_t>(joint)] = random.uniform(range.lower, range.upper);
    }
    apply_couplings(hand, posture);
    const Eigen::Vector3d tip = finger_poses(hand, finger, posture).back().p;
    workspace.box_H.lower = i == 0 ? tip : Eigen::Vector3d(workspace.box_H.lower.cwiseMin(tip));
    workspace.box_H.upper = i == 0 ? tip : Eigen::Vector3d(workspace.box_H.upper.cwiseMax(tip));
    cells.insert(cell_of(tip, cell_m));
  }
  for (const Cell& c : cells) {
    workspace.cells_H.emplace_back(static_cast<double>(c[0]) * cell_m, static_cast<double>(c[1]) * cell_m, static_cast<double>(c[2]) * cell_m);
  }
  return workspace;
}

OppositionRange opposition_range(const FingerWorkspace& thumb, const FingerWorkspace& forefinger) {
  struct Span {
    double low = INFINITY, high = -INFINITY;
  };
  const auto columns = [](const FingerWorkspace& workspace) {
    std::map<std::pair<long, long>, Span> spans;
    for (const auto& p : workspace.cells_H) {
      Span& span = spans[{std::lround(p.x() / workspace.cell_m), std::lround(p.z() / workspace.cell_m)}];
      span.low = std::min(span.low, p.y()), span.high = std::max(span.high, p.y());
    }
    return spans;
  };
  OppositionRange range;
  const auto fore = columns(forefinger);
  for (const auto& [column, own] : columns(thumb)) {
    const auto found = fore.find(column);
    if (found == fore.end() || found->second.high < own.low) continue;
    const double least = std::max(0.0, found->second.low - own.high), most = found->second.high - own.low;
    range.least_m = range.opposed ? std::min(range.least_m, least) : least;
    range.most_m = std::max(range.most_m, most);
    range.opposed = true;
  }
  return range;
}

}  // namespace preshape
