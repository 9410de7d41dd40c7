#include "io/placement_graph.h"

#include <algorithm>

#include <fmt/format.h>

#include "preshape/base/error.h"

namespace preshape {

namespace {

constexpr int kDeepest = 256;
constexpr std::uint64_t kMostPlacements = 1'000'000;

struct Part {
  enum class State { kNew, kOpen, kDone } state = State::kNew;
  int depth = 1;
  std::uint64_t placements = 1;  ///< itself and all below, once carried out
};

void take_in(Part& part, const Part& child) {
  part.depth = std::max(part.depth, child.depth + 1);
  part.placements = std::min(part.placements + child.placements, kMostPlacements + 1);
}

}  // namespace

void PlacementGraph::check() const {
  std::vector<Part> parts(placed_by.size());
  std::vector<std::pair<std::size_t, std::size_t>> open;  // part, next of its children
  for (std::size_t root = 0; root < parts.size(); ++root) {
    if (parts[root].state == Part::State::kNew) open.emplace_back(root, 0);
    while (!open.empty()) {
      auto& [part, next] = open.back();
      parts[part].state = Part::State::kOpen;
      if (next == placed_by[part].size()) {
        parts[part].state = Part::State::kDone;
        open.pop_back();
        if (!open.empty()) take_in(parts[open.back().first], parts[part]);
        continue;
      }
      const std::size_t child = placed_by[part][next++];
      if (parts[child].state == Part::State::kOpen)
        throw InputError("a part of its scene places itself; mend the file");
      if (parts[child].state == Part::State::kDone)
        take_in(parts[part], parts[child]);
      else
        open.emplace_back(child, 0);
    }
  }
  for (const Part& part : parts) {
    if (part.depth > kDeepest) {
      throw InputError(fmt::format("its scene is nested more than {} deep; flatten the scene", kDeepest));
    }
    if (part.placements > kMostPlacements) {
      throw InputError(
          fmt::format("its scene has more than {} placements; reduce the scene", kMostPlacements));
    }
  }
}

}  // namespace preshape
