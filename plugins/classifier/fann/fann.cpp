#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "fann_training.h"
#include "preshape/base/error.h"
#include "preshape/base/value.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/taught_rows.h"
#include "preshape/plugin/entry.h"
#include "state.h"

namespace {

using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::RowMatrix;
using preshape::TrainingOutcome;
using namespace preshape::fann_plugin;
using Matrix = Eigen::Ref<const RowMatrix>;

/// One row as the network sees it. @returns false when a number is not finite there
bool scale_row(bool asinh, const double* row, std::size_t features, float* input) {
  for (std::size_t i = 0; i < features; ++i) input[i] = static_cast<float>(asinh ? std::asinh(row[i]) : row[i]);
  return std::all_of(input, input + features, [](float x) { return std::isfinite(x); });
}

[[noreturn]] void refuse_row(Eigen::Index row) {
  throw InputError("classifier 'fann': row " + std::to_string(row + 1) + " holds a number that is not finite");
}

std::string size_text(Eigen::Index rows, Eigen::Index columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

/// Whether two rows have the same inputs and different targets, which no network can learn.
bool contradictory(const Lesson& lesson, const Shape& shape) {
  std::map<std::vector<float>, const float*> first;
  for (std::size_t r = 0; r < lesson.rows; ++r) {
    const float* input = lesson.inputs.data() + r * shape.features;
    const float* target = lesson.targets.data() + r * shape.outputs;
    const auto [known, is_new] = first.try_emplace({input, input + shape.features}, target);
    if (!is_new && !std::equal(target, target + shape.outputs, known->second)) return true;
  }
  return false;
}

/// A multilayer perceptron of one hidden layer, trained by the library FANN [Nissen2003].
class Fann final : public preshape::Classifier {
 public:
  static std::vector<std::string> capabilities() { return {"nonlinear", "rejects_nonfinite"}; }

  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {
        D::integer("hidden", 45, 1, 4096, "-", "Hidden units"),
        D::choice("trainer", "incremental", {"rprop", "quickprop", "incremental", "batch"}, "FANN's training algorithm"),
        D::choice("error", "tanh", {"tanh", "linear"},
                  "FANN's error function: linear takes an error as it is, tanh makes large ones larger"),
        D::choice("scaling", "asinh", {"asinh", "none"}, "How inputs are compressed"),
        D::number("goal", 1e-3, 1e-9, 0.25, "-", "Mean squared error over rows and bits to arrive at"),
        D::integer("max_epochs", 10000, 1, 1e8, "-", "Most passes over the rows in one run"),
        D::integer("restarts", 5, 0, 100, "-", "Most runs begun anew for a network that has stalled"),
        D::number("weight_range", 0.5, 1e-6, 100, "-", "Initial weights lie in plus and minus this"),
        D::number("learning_rate", 0.7, 1e-9, 100, "-", "Rate (quickprop, incremental, batch)"),
        D::number("momentum", 0.0, 0, 0.999, "-", "Share of its last step that a weight repeats (incremental)"),
    };
  }

  explicit Fann(const preshape::Parameters& p)
      : hidden_(static_cast<std::size_t>(p.integer("hidden"))), asinh_(p.text("scaling") == "asinh") {
    const std::string& trainer = p.text("trainer");
    settings_.trainer = trainer == "quickprop"     ? Trainer::kQuickprop
                        : trainer == "incremental" ? Trainer::kIncremental
                        : trainer == "batch"       ? Trainer::kBatch
                                                   : Trainer::kRprop;
    settings_.tanh_error = p.text("error") == "tanh";
    settings_.goal = p.number("goal");
    settings_.max_epochs = static_cast<int>(p.integer("max_epochs"));
    settings_.restarts = static_cast<int>(p.integer("restarts"));
    settings_.weight_range = static_cast<float>(p.number("weight_range"));
    settings_.learning_rate = static_cast<float>(p.number("learning_rate"));
    settings_.momentum = static_cast<float>(p.number("momentum"));
  }

  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed,
                      preshape::Progress* progress) override {
    const Lesson lesson = lesson_of(inputs, targets);
    const Shape shape{static_cast<std::size_t>(inputs.cols()), hidden_, static_cast<std::size_t>(targets.cols())};
    TrainingSettings settings = settings_;
    if (contradictory(lesson, shape)) settings.restarts = 0;
    preshape::Random random(seed);
    Trained trained = train(lesson, shape, settings, random, [&](int epoch, double error) {
      if (!progress) return;
      progress->advance("training", static_cast<double>(epoch) / settings.max_epochs,
                        "epoch " + std::to_string(epoch) + ", error " + preshape::number_text(error));
    });
    state_ = {asinh_, std::move(trained.layers)};
    TrainingOutcome outcome;
    outcome.status = trained.arrived ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    outcome.epochs = trained.epochs;
    outcome.restarts = trained.restarts;
    outcome.mean_squared_error = trained.fit.mean_squared_error;
    outcome.wrong_rows = static_cast<std::int64_t>(trained.fit.wrong_rows);
    return outcome;
  }

  /// A fit of everything: what is known then depends on the rows and the seed alone.
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new,
                         std::uint64_t seed, preshape::Progress* progress) override {
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError("classifier 'fann': the first new row must be in 0 .. " +
                       std::to_string(inputs.rows()) + ", got " + std::to_string(first_new));
    }
    return fit(inputs, targets, seed, progress);
  }

  bool trained() const noexcept override { return !state_.layers.weights.empty(); }

  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override {
    if (!trained()) throw InputError("classifier 'fann' has learned nothing yet; fit it first");
    const Shape& shape = state_.layers.shape;
    if (static_cast<std::size_t>(inputs.cols()) != shape.features ||
        static_cast<std::size_t>(bits.cols()) != shape.outputs || bits.rows() != inputs.rows()) {
      throw InputError("classifier 'fann' has learned " + std::to_string(shape.features) + " inputs and " +
                       std::to_string(shape.outputs) + " bits, but is asked with " +
                       size_text(inputs.rows(), inputs.cols()) + " inputs for " +
                       size_text(bits.rows(), bits.cols()) + " bits");
    }
    std::vector<float> input(shape.features), hidden(shape.hidden), outputs(shape.outputs);
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      if (!scale_row(state_.asinh, inputs.row(r).data(), shape.features, input.data())) refuse_row(r);
      state_.layers.run(input.data(), hidden, outputs);
      bits.row(r) = Eigen::Map<const Eigen::RowVectorXf>(outputs.data(), bits.cols()).cast<double>();
    }
  }

  std::string save() const override {
    if (!trained()) throw InputError("classifier 'fann' has learned nothing that could be saved; fit it first");
    return state_bytes(state_);
  }

  void load(std::string_view bytes) override {
    State state = state_from(bytes);
    if (state.layers.shape.hidden != hidden_) {
      throw InputError("classifier 'fann': the state was trained with hidden = " +
                       std::to_string(state.layers.shape.hidden) + ", but it is set to " +
                       std::to_string(hidden_) + "; set that, or train it anew");
    }
    if (state.asinh != asinh_) {
      throw InputError("classifier 'fann': the state was trained with another 'scaling' than is set now; set that, "
                       "or train it anew");
    }
    state_ = std::move(state);
  }

 private:
  Lesson lesson_of(const Matrix& inputs, const Matrix& targets) const {
    preshape::check_lesson("fann", inputs, targets);
    const auto features = static_cast<std::size_t>(inputs.cols());
    Lesson lesson{static_cast<std::size_t>(inputs.rows()),
                  std::vector<float>(static_cast<std::size_t>(inputs.size())),
                  std::vector<float>(static_cast<std::size_t>(targets.size()))};
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      float* input = lesson.inputs.data() + static_cast<std::size_t>(r) * features;
      if (!scale_row(asinh_, inputs.row(r).data(), features, input)) refuse_row(r);
    }
    std::transform(targets.data(), targets.data() + targets.size(), lesson.targets.begin(),
                   [](double bit) { return static_cast<float>(bit); });
    return lesson;
  }

  std::size_t hidden_;
  bool asinh_;
  TrainingSettings settings_;
  State state_;
};

}  // namespace

PRESHAPE_PLUGIN(({"fann", "1.0.0", "BSD-3-Clause", "the preshape developers",
                  "Neural networks by the library FANN"}),
                ({"classifier/fann"}),
                preshape::component<Fann>("fann", "Multilayer perceptron trained by the library FANN"))
