#pragma once

#include <array>
#include <span>
#include <vector>

#include "preshape/grasp/classifier.h"

namespace preshape::knn {

using Rows = Eigen::Ref<const RowMatrix>;

/// A learned row as a question finds it.
struct Neighbour {
  double squares = 0.0;  ///< of its scaled distance
  Eigen::Index row = 0;
};

inline constexpr std::size_t kMostNeighbours = 64;
using Neighbours = std::array<Neighbour, kMostNeighbours>;

/// Everything that the classifier knows: the learned rows in the order of their numbers, each once, so that
/// neither the order of learning nor a row given twice matters.
class Lesson {
 public:
  Lesson() = default;
  /// @param inputs n x features, finite; @param targets n x bits, 0 or 1; n, features, bits >= 1
  /// @throws InputError when they are not
  Lesson(const Rows& inputs, const Rows& targets);

  /// This lesson's rows and those as well. @throws InputError also when they have other widths
  Lesson with(const Rows& inputs, const Rows& targets) const;

  const RowMatrix& inputs() const { return inputs_; }
  const RowMatrix& targets() const { return targets_; }
  bool empty() const { return inputs_.rows() == 0; }

  /// The `count` rows that are nearest to a question (features numbers), nearest first; of equally near ones
  /// the first. Differences in a feature are taken over its range among the rows; a feature that is the same
  /// in all does not count.
  std::span<const Neighbour> nearest(const double* question, std::size_t count, Neighbours& room) const;

 private:
  RowMatrix inputs_, targets_;
  std::vector<double> scales_;  ///< one over each feature's range; 0 where it has none
};

/// @throws InputError that names the row
void check_finite(const Rows& inputs);

}  // namespace preshape::knn
