#include "preshape/grasp/explorer.h"

namespace preshape {

std::vector<Station> coarse_stations(const ExplorationProblem& problem) {
  std::vector<Station> stations;
  for (int plane = 0; plane < problem.planes(); ++plane) {
    for (const double x : problem.symbol_stations()) {
      for (const int fingers : problem.finger_counts()) {
        for (const double offset : problem.transverse_offsets()) stations.push_back({plane, x, fingers, offset});
      }
    }
  }
  return stations;
}

}  // namespace preshape
