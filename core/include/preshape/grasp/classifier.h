#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "preshape/base/export.h"
#include "preshape/base/progress.h"

namespace preshape {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How a training ended.
struct TrainingOutcome {
  enum class Status : std::int32_t { kArrived, kStalled };
  Status status = Status::kStalled;
  std::int64_t epochs = 0;       ///< of the run that was kept
  std::int64_t restarts = 0;     ///< runs begun anew before it
  double mean_squared_error = 0; ///< over rows and outputs
  std::int64_t wrong_rows = 0;   ///< rows with an output bit on the wrong side of 0.5
};

/// Kind `classifier`: features to a binary code (thesis sec. 3.10). Learning calls: one thread at a time;
/// predict and save: any thread, const.
class PRESHAPE_API Classifier {
 public:
  virtual ~Classifier();

  /// Learns the rows from nothing. On an exception the classifier is as before.
  /// @param inputs n x features, finite; @param targets n x bits, 0 or 1; n >= 1
  /// @param seed all randomness comes from it: same rows, same seed, same classifier
  /// @param progress may be null
  virtual TrainingOutcome fit(const Eigen::Ref<const RowMatrix>& inputs, const Eigen::Ref<const RowMatrix>& targets,
                              std::uint64_t seed, Progress* progress) = 0;

  /// Learns more: `inputs` and `targets` hold everything it shall know, the rows from `first_new` on are new
  /// to it. It may start from what it has. Without a fit before it equals fit.
  virtual TrainingOutcome extend(const Eigen::Ref<const RowMatrix>& inputs,
                                 const Eigen::Ref<const RowMatrix>& targets, std::int64_t first_new,
                                 std::uint64_t seed, Progress* progress) = 0;

  virtual bool trained() const noexcept = 0;

  /// Probability that each bit is 1. @param bits n x bits, overwritten
  /// @throws InputError when not trained or sizes differ from those it learned
  virtual void predict(const Eigen::Ref<const RowMatrix>& inputs, Eigen::Ref<RowMatrix> bits) const = 0;

  /// The whole state as bytes; load(save()) predicts bit for bit the same.
  virtual std::string save() const = 0;
  /// @throws InputError when the bytes are not a state of this classifier; it is then as before
  virtual void load(std::string_view state) = 0;

  virtual const void* extension(const char* id) const noexcept;
};

}  // namespace preshape
