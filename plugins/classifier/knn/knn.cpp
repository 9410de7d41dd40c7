#include <algorithm>
#include <cmath>
#include <string>

#include "lesson.h"
#include "preshape/base/error.h"
#include "preshape/plugin/entry.h"

namespace {

using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::RowMatrix;
using preshape::TrainingOutcome;
using namespace preshape::knn;

/// The k nearest learned rows vote, each for its whole code and with a weight of distance^-power
/// [CoverHart1967, Dudani1976]. Rows at no distance vote alone, so that each learned row is reproduced. The
/// code with the most votes is the one that the bits' probabilities round to, also where it has no majority.
class Knn final : public preshape::Classifier {
 public:
  static std::vector<ParameterDeclaration> parameters() {
    return {ParameterDeclaration::integer("k", 3, 1, static_cast<double>(kMostNeighbours), "rows",
                                          "Nearest rows that vote"),
            ParameterDeclaration::number("power", 2.0, 0.0, 16.0, "1",
                                         "A vote counts distance to minus this; 0: all count alike")};
  }
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "nonlinear",   "interpolating", "order_invariant",
            "scale_invariant",   "incremental", "seedless",      "realtime"};
  }

  explicit Knn(const preshape::Parameters& p)
      : k_(static_cast<std::size_t>(p.integer("k"))), power_(p.number("power")) {}

  TrainingOutcome fit(const Rows& inputs, const Rows& targets, std::uint64_t, Progress* progress) override {
    return learn(Lesson(preshape::TaughtRows(kName, inputs, targets)), inputs, targets, progress);
  }

  /// Adds the rows to those that it knows; a row that it has is not taken again.
  TrainingOutcome extend(const Rows& inputs, const Rows& targets, std::int64_t first_new, std::uint64_t,
                         Progress* progress) override {
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError("classifier 'knn': the first new row must be in 0 .. " +
                       std::to_string(inputs.rows()) + ", got " + std::to_string(first_new));
    }
    return learn(Lesson(lesson_.rows().with(kName, inputs, targets, preshape::TaughtRows::Again::kBoth)), inputs, targets, progress);
  }

  bool trained() const noexcept override { return !lesson_.empty(); }

  void predict(const Rows& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (!trained()) throw InputError("classifier 'knn' has learned nothing yet; fit it first");
    const auto features = lesson_.inputs().cols(), width = lesson_.targets().cols();
    if (inputs.cols() != features || bits.cols() != width || bits.rows() != inputs.rows()) {
      throw InputError("classifier 'knn' has learned " + std::to_string(features) + " inputs and " +
                       std::to_string(width) + " bits, but is asked with " + std::to_string(inputs.rows()) +
                       " x " + std::to_string(inputs.cols()) + " inputs for " + std::to_string(bits.rows()) +
                       " x " + std::to_string(bits.cols()) + " bits");
    }
    preshape::check_finite_rows(kName, inputs);
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) vote(lesson_, inputs.row(r).data(), bits.row(r));
  }

  std::string save() const override {
    if (!trained())
      throw InputError("classifier 'knn' has learned nothing that could be saved; fit it first");
    return lesson_.rows().bytes(kName);
  }

  void load(std::string_view state) override { lesson_ = Lesson(preshape::TaughtRows::from_bytes(kName, state)); }

 private:
  /// A code that wins without a majority is given this share, and what the others say is squeezed to the
  /// rest.
  static constexpr double kMajority = 0.51;

  TrainingOutcome learn(Lesson lesson, const Rows& inputs, const Rows& targets, Progress* progress) {
    const TrainingOutcome outcome = outcome_of(lesson, inputs, targets);
    if (progress) progress->advance("training", 1.0, "");
    lesson_ = std::move(lesson);  // from here on nothing throws
    return outcome;
  }

  /// Every row is known, unless equal inputs were given different codes.
  TrainingOutcome outcome_of(const Lesson& lesson, const Rows& inputs, const Rows& targets) const {
    TrainingOutcome outcome;
    outcome.epochs = 1;
    RowMatrix bits(1, targets.cols());
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      vote(lesson, inputs.row(r).data(), bits.row(0));
      const auto errors = (bits.row(0) - targets.row(r)).array().abs();
      outcome.mean_squared_error += errors.square().sum() / static_cast<double>(targets.size());
      outcome.wrong_rows += (errors >= 0.5).any();
    }
    outcome.status =
        outcome.wrong_rows == 0 ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    return outcome;
  }

  /// The votes of the neighbours, together 1.
  void weigh(std::span<const Neighbour> near, std::span<double> votes) const {
    const double least = near.front().squares;
    double sum = 0.0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      const bool alone = least == 0.0;
      votes[i] = alone ? near[i].squares == 0.0 : std::pow(least / near[i].squares, 0.5 * power_);
      sum += votes[i];
    }
    for (std::size_t i = 0; i < near.size(); ++i) votes[i] /= sum;
  }

  void vote(const Lesson& lesson, const double* question, Eigen::Ref<Eigen::RowVectorXd> bits) const {
    Neighbours room;
    std::array<double, kMostNeighbours> votes;
    const auto near = lesson.nearest(question, k_, room);
    weigh(near, votes);
    const auto code = [&](std::size_t i) { return lesson.targets().row(near[i].row); };
    // Of codes with equally many votes that of the nearest row.
    std::size_t winner = 0;
    double share = -1.0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      double same = 0.0;
      for (std::size_t j = 0; j < near.size(); ++j) same += code(j) == code(i) ? votes[j] : 0.0;
      if (same > share) share = same, winner = i;
    }
    bits.setZero();
    for (std::size_t i = 0; i < near.size(); ++i) bits += votes[i] * code(i);
    if (share < kMajority) {
      bits = kMajority * code(winner) + (1.0 - kMajority) / (1.0 - share) * (bits - share * code(winner));
    }
    bits = bits.cwiseMax(0.0).cwiseMin(1.0);  // sums of shares may miss a border by a rounding
  }

  std::size_t k_;
  double power_;
  Lesson lesson_;
};

}  // namespace

PRESHAPE_PLUGIN(({"knn", "1.0.0", "BSD-3-Clause", "the preshape developers", "k nearest neighbours"}),
                ({"classifier/knn"}),
                preshape::component<Knn>("knn", "Weighted vote of the k nearest learned rows"))
