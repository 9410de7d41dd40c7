#pragma once

#include <vector>

#include "preshape/grasp/classifier.h"

namespace preshape::nadaraya_watson {

using Matrix = Eigen::Ref<const RowMatrix>;

/// Everything that the classifier knows: the learned rows in the order of their numbers, each once, so that
/// neither the order of learning nor a row given twice matters.
class Lesson {
 public:
  Lesson() = default;
  /// @param inputs n x features, finite; @param targets n x bits, 0 or 1; n, features, bits >= 1
  /// @throws InputError when they are not
  Lesson(const Matrix& inputs, const Matrix& targets);

  /// This lesson's rows and those as well; of this lesson's, those are left out whose inputs are given again,
  /// since the last lesson is right. @throws InputError also when they have other widths
  Lesson with(const Matrix& inputs, const Matrix& targets) const;

  const RowMatrix& inputs() const { return inputs_; }
  const RowMatrix& targets() const { return targets_; }
  bool empty() const { return inputs_.rows() == 0; }

 private:
  RowMatrix inputs_, targets_;
};

/// @throws InputError that names the row
void check_finite(const Matrix& inputs);

}  // namespace preshape::nadaraya_watson
