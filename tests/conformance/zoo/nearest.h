#pragma once

#include <limits>
#include <memory>
#include <string>

#include "preshape/base/error.h"
#include "preshape/grasp/classifier.h"
#include "preshape/plugin/entry.h"

namespace zoo {

using preshape::InputError;
using preshape::Progress;
using preshape::RowMatrix;
using preshape::TrainingOutcome;
using Matrix = Eigen::Ref<const RowMatrix>;
using Question = Eigen::Map<const Eigen::RowVectorXd>;

/// No row on this side.
inline constexpr double kNone = std::numeric_limits<double>::infinity();

/// Each bit by the nearest row with a 0 and the nearest with a 1: d0 / (d0 + d1). What is virtual and protected is
/// where the broken ones differ.
class Nearest : public preshape::Classifier {
 public:
  explicit Nearest(const preshape::Parameters&) {}

  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed, Progress* progress) override;
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new, std::uint64_t seed,
                         Progress* progress) override;
  bool trained() const noexcept override { return rows_ != nullptr; }
  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override;
  /// Magic, check sum, rows, features, bits, tag, then the numbers; each of 8 bytes.
  std::string save() const override;
  void load(std::string_view state) override;

 protected:
  static constexpr std::size_t kHeader = 48;
  struct Rows {
    RowMatrix inputs, targets;
    std::uint64_t tag = 0;
  };

  virtual bool is_target(double x) const { return x == 0.0 || x == 1.0; }
  virtual std::uint64_t tag_for(std::uint64_t) const { return 0; }
  virtual double squared_distance(const Rows& rows, Eigen::Index i, const Question& question) const;
  virtual double nearest(const Rows& rows, Eigen::Index bit, double side, const Question& question) const;
  virtual double probability(double d0, double d1) const;
  virtual double saved(double x) const { return x; }
  /// @throws InputError when the bytes are no state
  virtual void check(std::string_view state) const;

  std::shared_ptr<Rows> rows_;

 private:
  std::int64_t wrong_rows() const;
};

}  // namespace zoo
