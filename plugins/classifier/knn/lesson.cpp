#include "lesson.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace preshape::knn {

namespace {

/// A range below this share of the feature's largest number is its rounding.
constexpr double kLeastRange = 1e-12;

double scale_of(const Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>& feature) {
  const double highest = feature.maxCoeff(), lowest = feature.minCoeff(), scale = 1.0 / (highest - lowest);
  const bool constant = highest - lowest <= kLeastRange * std::max(std::abs(highest), std::abs(lowest));
  return constant || !std::isnormal(scale) ? 0.0 : scale;
}

}  // namespace

Lesson::Lesson(TaughtRows rows) : rows_(std::move(rows)) {
  for (Eigen::Index j = 0; j < inputs().cols(); ++j) scales_.push_back(scale_of(inputs().col(j)));
}

std::span<const Neighbour> Lesson::nearest(const double* question, std::size_t count,
                                           Neighbours& room) const {
  std::size_t found = 0;
  for (Eigen::Index i = 0; i < inputs().rows(); ++i) {
    const double* row = inputs().row(i).data();
    double squares = 0.0;
    for (std::size_t j = 0; j < scales_.size(); ++j) {
      if (scales_[j] == 0.0) continue;
      const double d = (row[j] - question[j]) * scales_[j];
      squares += d * d;
    }
    if (!(squares <= std::numeric_limits<double>::max())) squares = std::numeric_limits<double>::max();
    if (found == count && squares >= room[found - 1].squares) continue;
    // Insertion: the rows are met in their order, so of equally near ones the first stays before.
    std::size_t place = found < count ? found++ : found - 1;
    for (; place > 0 && room[place - 1].squares > squares; --place) room[place] = room[place - 1];
    room[place] = {squares, i};
  }
  return std::span(room).first(found);
}

}  // namespace preshape::knn
