#include <string>

#include "preshape/base/error.h"
#include "preshape/grasp/taught_rows.h"
#include "preshape/plugin/entry.h"
#include "voting.h"

namespace {

using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::Progress;
using preshape::RowMatrix;
using preshape::TaughtRows;
using preshape::TrainingOutcome;
using namespace preshape::nadaraya_watson;
using Matrix = preshape::RowsView;

constexpr const char* kName = "nadaraya_watson";

std::vector<int> whole_numbers(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

/// Nadaraya and Watson's kernel estimate [Nadaraya1964, Watson1964] of the probabilities of codes, with a kernel
/// that is infinite at no distance, so that each learned row is reproduced [DevroyeGyorfiKrzyzak1998].
class NadarayaWatson final : public preshape::Classifier {
 public:
  static std::vector<std::string> capabilities() {
    return {"rejects_nonfinite", "nonlinear", "interpolating", "order_invariant", "incremental", "seedless"};
  }

  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {
        D::list("groups", {3, 3, 2, 3, 4}, 1, 64, "-",
                "Features of each group; where they do not add up to them, all are one group"),
        D::list("widths", {1, 1, 1, 0.5, 0.5}, 1e-3, 1e3, "spreads",
                "Of the kernel in each group, in the group's spread among the rows"),
        D::number("power", 4.0, 0.0, 16.0, "-", "A near row's vote grows as distance to minus this"),
        D::number("sharpness", 0.0, 0.0, 16.0, "-",
                  "Power of the votes' shares in the probabilities; 0: the best for rows left out"),
        D::list("fields", {4, 3, 2}, 1, 24, "-",
                "Bits of each field of the code; where they do not add up to it, the code is one field"),
        D::choice("scaling", "asinh", {"asinh", "none"}, "How inputs are compressed"),
    };
  }

  explicit NadarayaWatson(const preshape::Parameters& p)
      : settings_{whole_numbers(p.numbers("groups")), whole_numbers(p.numbers("fields")), p.numbers("widths"),
                  p.number("power"), p.number("sharpness"), p.text("scaling") == "asinh"} {
    if (settings_.widths.size() == settings_.groups.size()) return;
    throw InputError("classifier 'nadaraya_watson': 'widths' must have one number for each of the " +
                     std::to_string(settings_.groups.size()) + " 'groups', got " +
                     std::to_string(settings_.widths.size()));
  }

  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t, Progress* progress) override {
    return learn(TaughtRows(kName, inputs, targets), inputs, targets, progress);
  }

  /// Adds the rows to those that it knows.
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new, std::uint64_t,
                         Progress* progress) override {
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError("classifier 'nadaraya_watson': the first new row must be in 0 .. " +
                       std::to_string(inputs.rows()) + ", got " + std::to_string(first_new));
    }
    return learn(lesson_.with(kName, inputs, targets, TaughtRows::Again::kLast), inputs, targets, progress);
  }

  bool trained() const noexcept override { return !lesson_.empty(); }

  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (!trained()) throw InputError("classifier 'nadaraya_watson' has learned nothing yet; fit it first");
    const auto features = lesson_.inputs().cols(), width = lesson_.targets().cols();
    if (inputs.cols() != features || bits.cols() != width || bits.rows() != inputs.rows()) {
      throw InputError("classifier 'nadaraya_watson' has learned " + std::to_string(features) + " inputs and " +
                       std::to_string(width) + " bits, but is asked with " + std::to_string(inputs.rows()) +
                       " x " + std::to_string(inputs.cols()) + " inputs for " + std::to_string(bits.rows()) +
                       " x " + std::to_string(bits.cols()) + " bits");
    }
    preshape::check_finite_rows(kName, inputs);
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      voting_.ask(inputs.row(r).data(), {bits.row(r).data(), static_cast<std::size_t>(width)});
    }
  }

  std::string save() const override {
    if (!trained()) {
      throw InputError("classifier 'nadaraya_watson' has learned nothing that could be saved; fit it first");
    }
    return lesson_.bytes(kName);
  }

  void load(std::string_view state) override { keep(TaughtRows::from_bytes(kName, state)); }

 private:
  Voting prepared(const TaughtRows& lesson) const {
    if (lesson.targets().cols() > 24 && !adds_up(settings_.fields, lesson.targets().cols())) {
      throw InputError("classifier 'nadaraya_watson': 'fields' must add up to the code's " +
                       std::to_string(lesson.targets().cols()) + " bits, since a single field has at most 24");
    }
    return Voting(lesson, settings_);
  }

  static bool adds_up(const std::vector<int>& parts, Eigen::Index whole) {
    Eigen::Index sum = 0;
    for (const int part : parts) sum += part;
    return sum == whole;
  }

  void keep(TaughtRows lesson) {
    Voting voting = prepared(lesson);
    lesson_ = std::move(lesson);  // from here on nothing throws
    voting_ = std::move(voting);
  }

  TrainingOutcome learn(TaughtRows lesson, const Matrix& inputs, const Matrix& targets, Progress* progress) {
    const TrainingOutcome outcome = outcome_of(prepared(lesson), inputs, targets);
    if (progress) progress->advance("training", 1.0, "");
    keep(std::move(lesson));
    return outcome;
  }

  /// Every row is known, unless equal inputs were given different codes.
  static TrainingOutcome outcome_of(const Voting& voting, const Matrix& inputs, const Matrix& targets) {
    TrainingOutcome outcome;
    outcome.epochs = 1;
    RowMatrix bits(1, targets.cols());
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      voting.ask(inputs.row(r).data(), {bits.data(), static_cast<std::size_t>(bits.size())});
      const auto errors = (bits.row(0) - targets.row(r)).array().abs();
      outcome.mean_squared_error += errors.square().sum() / static_cast<double>(targets.size());
      outcome.wrong_rows += (errors >= 0.5).any();
    }
    outcome.status =
        outcome.wrong_rows == 0 ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    return outcome;
  }

  VotingSettings settings_;
  TaughtRows lesson_;
  Voting voting_;
};

}  // namespace

PRESHAPE_PLUGIN(({"nadaraya_watson", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Kernel estimate of the codes' probabilities"}),
                ({"classifier/nadaraya_watson"}),
                preshape::component<NadarayaWatson>("nadaraya_watson",
                                                    "Vote of all learned rows by a kernel that reproduces each"))
