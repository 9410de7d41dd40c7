#pragma once

#include <string>
#include <string_view>

#include "preshape/grasp/classifier.h"

namespace preshape {

using RowsView = Eigen::Ref<const RowMatrix>;

/// @param classifier its name, for the message
/// @throws InputError when there is no row, inputs and targets are not as many, or a target is neither 0 nor 1
PRESHAPE_API void check_lesson(std::string_view classifier, const RowsView& inputs, const RowsView& targets);
/// @throws InputError that names the row with a number that is not finite
PRESHAPE_API void check_finite_rows(std::string_view classifier, const RowsView& inputs);

/// What a classifier that keeps its rows knows: in the order of their numbers, each once, so that neither the order of
/// learning nor a row given twice matters. Every call takes the classifier's name, for messages and states.
class PRESHAPE_API TaughtRows {
 public:
  TaughtRows() = default;
  /// @throws InputError as check_lesson and check_finite_rows
  TaughtRows(std::string_view classifier, const RowsView& inputs, const RowsView& targets);

  const RowMatrix& inputs() const { return inputs_; }
  const RowMatrix& targets() const { return targets_; }
  bool empty() const { return inputs_.rows() == 0; }

  /// What becomes of a row whose inputs are taught again with other targets.
  enum class Again { kBoth, kLast };
  /// These rows and those as well. @throws InputError also when they have other widths
  TaughtRows with(std::string_view classifier, const RowsView& inputs, const RowsView& targets, Again again) const;

  /// Little-endian: a head with name and version, the SHA-256 of what follows, three sizes, inputs and targets.
  std::string bytes(std::string_view classifier) const;
  /// @throws InputError when they are not what `bytes` gave; no more is allocated than the bytes hold
  static TaughtRows from_bytes(std::string_view classifier, std::string_view bytes);

 private:
  RowMatrix inputs_, targets_;
};

}  // namespace preshape
