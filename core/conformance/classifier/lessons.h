#pragma once

#include <vector>

#include "../context.h"
#include "preshape/grasp/classifier.h"

namespace preshape::conformance {

/// Rows to learn. Unless a check is about that, no bit is the same in all rows and no inputs stand twice.
struct Lesson {
  RowMatrix inputs, targets;
  Eigen::Index rows() const { return inputs.rows(); }
  Lesson first(Eigen::Index count) const { return {inputs.topRows(count), targets.topRows(count)}; }
  /// Its rows in another order: row i is `order[i]`.
  Lesson ordered(std::span<const int> order) const;
};

/// Each bit's two sides stand on either side of a line, one apart: 16 rows, 2 features, 1 bit.
Lesson separable_lesson();
/// Exclusive or: 4 rows, 2 features, 1 bit.
Lesson xor_lesson();
/// Three round heaps in the plane, ten deviations apart, with a code of 2 bits each.
Lesson heaps(Random& random, int each);
/// Random inputs, random codes.
Lesson random_lesson(Random& random, int rows, int features, int bits);
/// Two rows of 2 features and 1 bit, whose state is small.
Lesson smallest_lesson();
/// Rows with equal inputs and other targets among others.
Lesson contradictory_lesson();
/// Rows of numbers in [-2, 2].
RowMatrix random_rows(Random& random, int rows, int features);

TrainingOutcome fit(Classifier& classifier, const Lesson& lesson, std::uint64_t seed = 1);

/// What it says of the questions, a row each; what it leaves out stays NaN.
RowMatrix predicted(const Classifier& classifier, const RowMatrix& questions, Eigen::Index bits);
std::vector<double> numbers_of(const RowMatrix& matrix);

/// Rows with a bit on the wrong side of 0.5; those with one on 0.5 itself count when `strict`.
std::int64_t wrong_rows(const RowMatrix& answers, const RowMatrix& targets, bool strict = true);
/// "" or the first answer that is no probability.
std::string no_probability(const RowMatrix& answers);

}  // namespace preshape::conformance
