#pragma once

#include <array>
#include <span>
#include <vector>

#include "preshape/grasp/taught_rows.h"

namespace preshape::knn {

using Rows = RowsView;

inline constexpr const char* kName = "knn";

/// A learned row as a question finds it.
struct Neighbour {
  double squares = 0.0;  ///< of its scaled distance
  Eigen::Index row = 0;
};

inline constexpr std::size_t kMostNeighbours = 64;
using Neighbours = std::array<Neighbour, kMostNeighbours>;

/// Everything that the classifier knows: the taught rows, and what makes their features comparable.
class Lesson {
 public:
  Lesson() = default;
  explicit Lesson(TaughtRows rows);

  const TaughtRows& rows() const { return rows_; }
  const RowMatrix& inputs() const { return rows_.inputs(); }
  const RowMatrix& targets() const { return rows_.targets(); }
  bool empty() const { return rows_.empty(); }

  /// The `count` rows that are nearest to a question (features numbers), nearest first; of equally near ones
  /// the first. Differences in a feature are taken over its range among the rows; a feature that is the same
  /// in all does not count.
  std::span<const Neighbour> nearest(const double* question, std::size_t count, Neighbours& room) const;

 private:
  TaughtRows rows_;
  std::vector<double> scales_;  ///< one over each feature's range; 0 where it has none
};

}  // namespace preshape::knn
