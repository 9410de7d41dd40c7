// What cannot be read off the alpha-cuts: the universe is halved until what is asked is certain. Left and right of its top a
// set only rises or only falls, so its degrees at the ends of a piece bound those in it.
#include "partition_walk.h"

#include <algorithm>
#include <numeric>

namespace preshape {

namespace {

constexpr double kSumTolerance = 1e-4;
constexpr double kNarrowest = 1.0 / 16384;  ///< of the universe

struct Piece {
  double from, to;
};

/// Ends and tops, and the corners where straight sides begin: between them every set only rises or only falls.
std::vector<double> corners_of(const FuzzyPartition& partition, const Interval& universe) {
  std::vector<double> corners = {universe.from, universe.to};
  for (const Membership& set : partition.sets()) {
    corners.push_back(set.top_middle());
    if (set.shape <= Membership::Shape::kTriangle) corners.insert(corners.end(), set.points.begin(), set.points.end());
  }
  std::erase_if(corners, [&](double x) { return x < universe.from || x > universe.to; });
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// Calls `look` for the pieces between the corners, and for the halves of those that it does not settle.
template <class Look>
void halve(const std::vector<double>& corners, double narrowest, Look&& look) {
  std::vector<Piece> open;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) open.push_back({corners[i], corners[i + 1]});
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const double middle = piece.from / 2 + piece.to / 2;
    if (look(piece, middle) || piece.to - piece.from <= narrowest) continue;
    open.push_back({piece.from, middle});
    open.push_back({middle, piece.to});
  }
}

double sum_at(const FuzzyPartition& partition, double x) {
  double sum = 0.0;
  for (const Membership& set : partition.sets()) sum += set(x);
  return sum;
}

/// Bounds of a set's degree in a piece.
Interval degrees_in(const Membership& set, const Piece& piece) {
  const double from = set(piece.from), to = set(piece.to);
  return {std::min(from, to), std::max(from, to)};
}

/// Whether another set is certainly better all over the piece; of equal ones the lower index is the better.
bool outdone(const FuzzyPartition& partition, int own, const Piece& piece) {
  const double highest = degrees_in(partition[own], piece).to;
  for (int k = 0; k < partition.size(); ++k) {
    const double lowest = degrees_in(partition[k], piece).from;
    if (k != own && (lowest > highest || (lowest == highest && k < own))) return true;
  }
  return false;
}

}  // namespace

Interval sums_of(const FuzzyPartition& partition, const Interval& universe) {
  const auto corners = corners_of(partition, universe);
  Interval sums{sum_at(partition, corners.front()), sum_at(partition, corners.front())};
  const auto sample = [&](double x) {
    const double sum = sum_at(partition, x);
    sums = {std::min(sums.from, sum), std::max(sums.to, sum)};
  };
  for (const double x : corners) sample(x);
  halve(corners, 1e-6 * universe.width(), [&](const Piece& piece, double middle) {
    sample(middle);
    Interval bounds{0.0, 0.0};
    for (const Membership& set : partition.sets()) {
      const Interval own = degrees_in(set, piece);
      bounds = {bounds.from + own.from, bounds.to + own.to};
    }
    return bounds.from >= sums.from - kSumTolerance && bounds.to <= sums.to + kSumTolerance;
  });
  return sums;
}

std::vector<int> never_best(const FuzzyPartition& partition, const Interval& universe) {
  const auto corners = corners_of(partition, universe);
  std::vector<bool> found(static_cast<std::size_t>(partition.size()), false);
  for (const double x : corners) found[static_cast<std::size_t>(partition.best(x))] = true;
  std::vector<int> never;
  for (int own = 0; own < partition.size(); ++own) {
    const auto is_found = [&] { return bool(found[static_cast<std::size_t>(own)]); };
    if (!is_found()) {
      halve(corners, kNarrowest * universe.width(), [&](const Piece& piece, double middle) {
        if (is_found()) return true;
        found[static_cast<std::size_t>(partition.best(middle))] = true;
        return is_found() || outdone(partition, own, piece);
      });
    }
    if (!is_found()) never.push_back(own);
  }
  return never;
}

}  // namespace preshape
