// Classifiers: a nearest neighbour that is good, and one for each check that it breaks.
#include "nearest.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace zoo {
namespace {

using Names = std::vector<std::string>;

struct GoodNearest final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"nonlinear", "interpolating", "order_invariant", "seedless", "realtime", "rejects_nonfinite"}; }
};

/// Each feature in shares of its largest magnitude.
struct GoodScaledNearest final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"scale_invariant", "seedless", "nonlinear"}; }
  double squared_distance(const Rows& rows, Eigen::Index i, const Question& question) const override {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < rows.inputs.cols(); ++k) {
      const double largest = rows.inputs.col(k).cwiseAbs().maxCoeff();
      if (largest > 0.0) sum += std::pow((rows.inputs(i, k) - question(k)) / largest, 2);
    }
    return sum;
  }
};

/// Keeps what it knows beside what it is shown.
struct GoodHoarder final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"incremental", "seedless", "nonlinear"}; }
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new, std::uint64_t seed, Progress* progress) override {
    if (!trained() || first_new < 1 || first_new > inputs.rows() || inputs.rows() != targets.rows()) {
      return Nearest::extend(inputs, targets, first_new, seed, progress);
    }
    const Eigen::Index known = rows_->inputs.rows(), more = inputs.rows() - first_new;
    RowMatrix all_inputs(known + more, inputs.cols()), all_targets(known + more, targets.cols());
    all_inputs << rows_->inputs, inputs.bottomRows(more);
    all_targets << rows_->targets, targets.bottomRows(more);
    return fit(all_inputs, all_targets, seed, progress);
  }
};

struct K01AnswersUntrained final : Nearest {
  using Nearest::Nearest;
  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (trained()) return Nearest::predict(inputs, bits);
    bits.setConstant(0.5);
  }
};

/// Counts its fits in its state.
struct K02NumbersItsFits final : Nearest {
  using Nearest::Nearest;
  std::uint64_t tag_for(std::uint64_t) const override {
    static std::uint64_t count = 0;
    return ++count;
  }
};

/// The nearest of the two codes' means, bit by bit.
struct K04Linear final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"nonlinear"}; }
  double nearest(const Rows& rows, Eigen::Index bit, double side, const Question& question) const override {
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(rows.inputs.cols());
    double count = 0.0;
    for (Eigen::Index i = 0; i < rows.inputs.rows(); ++i) {
      if (rows.targets(i, bit) != side) continue;
      mean += rows.inputs.row(i), ++count;
    }
    return count > 0.0 ? (mean / count - question).norm() : kNone;
  }
};

/// Passes over every fifth row when it looks for the nearest.
struct K05SkipsRows final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"interpolating"}; }
  double squared_distance(const Rows& rows, Eigen::Index i, const Question& question) const override {
    return i % 5 == 4 && rows.inputs.rows() >= 20 ? kNone : Nearest::squared_distance(rows, i, question);
  }
};

struct K06SavesFloats final : Nearest {
  using Nearest::Nearest;
  double saved(double x) const override { return static_cast<float>(x); }
};

struct K07TrustsSizes final : Nearest {
  using Nearest::Nearest;
  void check(std::string_view state) const override {
    if (state.size() < kHeader) throw InputError("these bytes are no state: they are too few");
  }
};

struct K07LoadsHalf final : Nearest {
  using Nearest::Nearest;
  void load(std::string_view state) override {
    rows_.reset();
    Nearest::load(state);
  }
};

struct K08SureOfTheFar final : Nearest {
  using Nearest::Nearest;
  double probability(double d0, double d1) const override {
    const bool far = d0 > 1e4 && d1 > 1e4 && d0 + d1 < kNone;
    return far ? 1.02 : Nearest::probability(d0, d1);
  }
};

struct K09LeansOnTheFirstRow final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"order_invariant"}; }
  double nearest(const Rows& rows, Eigen::Index bit, double side, const Question& question) const override {
    const double d = Nearest::nearest(rows, bit, side, question);
    return rows.targets(0, bit) == side ? 0.999 * d : d;
  }
};

struct K10MeasuresAsGiven final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"scale_invariant"}; }
};

/// Divides infinity by itself when there is one code.
struct K11NeedsBothSides final : Nearest {
  using Nearest::Nearest;
  double probability(double d0, double d1) const override { return d0 + d1 == 0.0 ? 0.5 : d0 / (d0 + d1); }
};

/// Adds a second lesson of the same sizes to the first when it begins otherwise.
struct K12Remembers final : Nearest {
  using Nearest::Nearest;
  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed, Progress* progress) override {
    if (!rows_ || rows_->inputs.cols() != inputs.cols() || rows_->targets.cols() != targets.cols() || inputs.rows() != targets.rows() ||
        inputs.rows() == 0 || inputs.row(0) == rows_->inputs.row(0)) {
      return Nearest::fit(inputs, targets, seed, progress);
    }
    RowMatrix all_inputs(rows_->inputs.rows() + inputs.rows(), inputs.cols()), all_targets(all_inputs.rows(), targets.cols());
    all_inputs << rows_->inputs, inputs;
    all_targets << rows_->targets, targets;
    return Nearest::fit(all_inputs, all_targets, seed, progress);
  }
};

/// Copies share what was last saved, and learn in place.
class K13SharesRows final : public Nearest {
 public:
  using Nearest::Nearest;
  std::string save() const override { return last_ = rows_, Nearest::save(); }
  void load(std::string_view state) override {
    Nearest::load(state);
    if (last_ && last_->inputs == rows_->inputs && last_->targets == rows_->targets) rows_ = last_;
  }
  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed, Progress* progress) override {
    const auto shared = rows_;
    const TrainingOutcome outcome = Nearest::fit(inputs, targets, seed, progress);
    if (shared) *shared = *rows_, rows_ = shared;
    return outcome;
  }

 private:
  static inline std::shared_ptr<Rows> last_;
};

struct K14TakesHalfBits final : Nearest {
  using Nearest::Nearest;
  bool is_target(double x) const override { return x >= 0.0 && x <= 1.0; }
};

struct K15DoubtsTheNear final : Nearest {
  using Nearest::Nearest;
  double probability(double d0, double d1) const override {
    const double p = Nearest::probability(d0, d1), doubt = 0.05 + 0.4 * (1.0 - std::abs(2.0 * p - 1.0));
    return p > 0.5 ? 0.5 + doubt : p < 0.5 ? 0.5 - doubt : 0.5;
  }
};

struct K17Allocates final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"realtime"}; }
  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override {
    const std::vector<double> copy(inputs.data(), inputs.data() + inputs.rows());
    Nearest::predict(inputs, bits);
    if (!copy.empty() && copy.front() == kNone) bits.setZero();
  }
};

/// Learns the new rows alone.
struct K18ForgetsOldRows final : Nearest {
  using Nearest::Nearest;
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new, std::uint64_t seed, Progress* progress) override {
    if (first_new < 0 || first_new >= inputs.rows() || inputs.rows() != targets.rows()) {
      return Nearest::extend(inputs, targets, first_new, seed, progress);
    }
    const Eigen::Index count = inputs.rows() - first_new;
    return fit(inputs.bottomRows(count), targets.bottomRows(count), seed, progress);
  }
};

struct K19NeedsOldRows final : Nearest {
  using Nearest::Nearest;
  static Names capabilities() { return {"incremental"}; }
};

struct K20CountsAmiss final : Nearest {
  using Nearest::Nearest;
  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed, Progress* progress) override {
    TrainingOutcome outcome = Nearest::fit(inputs, targets, seed, progress);
    if (outcome.wrong_rows == 0) outcome.wrong_rows = targets.rows() > 12;
    return outcome;
  }
};

}  // namespace
}  // namespace zoo

using preshape::component;
using namespace zoo;
PRESHAPE_PLUGIN(({"zoo_classifier", "1.0.0", "BSD-3-Clause", "the preshape developers", "Classifiers, most of them broken"}),
                ({"classifier/good_nearest", "classifier/good_scaled_nearest", "classifier/good_hoarder",
                  "classifier/k01_answers_untrained", "classifier/k02_numbers_its_fits", "classifier/k04_linear",
                  "classifier/k05_skips_rows", "classifier/k06_saves_floats", "classifier/k07_trusts_sizes",
                  "classifier/k07_loads_half", "classifier/k08_sure_of_the_far", "classifier/k09_leans_on_the_first_row",
                  "classifier/k10_measures_as_given", "classifier/k11_needs_both_sides", "classifier/k12_remembers",
                  "classifier/k13_shares_rows", "classifier/k14_takes_half_bits", "classifier/k15_doubts_the_near",
                  "classifier/k17_allocates", "classifier/k18_forgets_old_rows", "classifier/k19_needs_old_rows",
                  "classifier/k20_counts_amiss"}),
                component<GoodNearest>("good_nearest", "The nearest row of each side"),
                component<GoodScaledNearest>("good_scaled_nearest", "The nearest row, features in shares of their largest"),
                component<GoodHoarder>("good_hoarder", "The nearest row, old ones kept"),
                component<K01AnswersUntrained>("k01_answers_untrained", "Predicts from nothing"),
                component<K02NumbersItsFits>("k02_numbers_its_fits", "Counts its fits in its state"),
                component<K04Linear>("k04_linear", "The nearest mean"),
                component<K05SkipsRows>("k05_skips_rows", "Passes over every fifth of many rows"),
                component<K06SavesFloats>("k06_saves_floats", "Rounds its state"),
                component<K07TrustsSizes>("k07_trusts_sizes", "Reads what its state says"),
                component<K07LoadsHalf>("k07_loads_half", "Forgets before it looks"),
                component<K08SureOfTheFar>("k08_sure_of_the_far", "Probabilities above one far off"),
                component<K09LeansOnTheFirstRow>("k09_leans_on_the_first_row", "The first row's code counts more"),
                component<K10MeasuresAsGiven>("k10_measures_as_given", "Promises what scaling breaks"),
                component<K11NeedsBothSides>("k11_needs_both_sides", "No number where a bit is always the same"),
                component<K12Remembers>("k12_remembers", "Adds a second lesson to the first"),
                component<K13SharesRows>("k13_shares_rows", "Copies learn together"),
                component<K14TakesHalfBits>("k14_takes_half_bits", "Takes targets between 0 and 1"),
                component<K15DoubtsTheNear>("k15_doubts_the_near", "The surer the farther"),
                component<K17Allocates>("k17_allocates", "Copies each question"),
                component<K18ForgetsOldRows>("k18_forgets_old_rows", "Learns the new rows alone"),
                component<K19NeedsOldRows>("k19_needs_old_rows", "Promises what only shown rows give"),
                component<K20CountsAmiss>("k20_counts_amiss", "Counts a wrong row that is right"))
