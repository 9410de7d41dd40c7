#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "preshape/base/error.h"
#include "preshape/base/value.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/taught_rows.h"
#include "preshape/plugin/entry.h"
#include "state.h"
#include "training.h"

namespace {

using preshape::InputError;
using preshape::ParameterDeclaration;
using preshape::RowMatrix;
using preshape::TrainingOutcome;
using namespace preshape::mlp;
using Matrix = Eigen::Ref<const RowMatrix>;

float scaled(Scaling scaling, double x) {
  return static_cast<float>(scaling == Scaling::kAsinh ? std::asinh(x) : x);
}

/// One row as the network sees it. @returns false when a number is not finite there
bool scale_row(Scaling scaling, const double* row, int features, float* input) {
  for (int i = 0; i < features; ++i) input[i] = scaled(scaling, row[i]);
  return std::all_of(input, input + features, [](float x) { return std::isfinite(x); });
}

Trainer trainer_named(const std::string& name) {
  if (name == "backprop") return Trainer::kBackprop;
  if (name == "lbfgs") return Trainer::kLbfgs;
  return name == "levenberg_marquardt" ? Trainer::kLevenbergMarquardt : Trainer::kRprop;
}

/// Whether two rows have the same inputs and different targets, which no network can learn.
bool contradictory(const Lesson& lesson) {
  std::map<std::vector<float>, std::size_t> first;
  const std::size_t width = lesson.rows.input_width, bits = static_cast<std::size_t>(lesson.coding.bits());
  for (std::size_t r = 0; r < lesson.rows.count; ++r) {
    const float* input = lesson.rows.input(r);
    const auto [known, is_new] = first.try_emplace({input, input + width}, r);
    const float* target = lesson.bits.data() + r * bits;
    if (!is_new && !std::equal(target, target + bits, lesson.bits.data() + known->second * bits)) return true;
  }
  return false;
}

/// Multilayer perceptron of one hidden layer (thesis sec. 3.10, appendix A), or a committee of such.
class Mlp final : public preshape::Classifier {
 public:
  static std::vector<std::string> capabilities() { return {"nonlinear", "rejects_nonfinite"}; }

  static std::vector<ParameterDeclaration> parameters() {
    using D = ParameterDeclaration;
    return {
        D::integer("hidden", 45, 1, 4096, "-", "Hidden units of a network"),
        D::integer("committee", 5, 1, 100, "-", "Networks whose bit probabilities are averaged"),
        D::choice("outputs", "fields", {"fields", "bits"},
                  "Output units: one for each learned pattern of a field of the code, or one for each bit"),
        D::list("fields", {4, 3, 2}, 1, 24, "-",
                "Bits of each field of the code; where they do not add up to it, the code is one field"),
        D::integer("sharpness", 4, 1, 16, "-",
                   "Power of a field's outputs before they share out its probability"),
        D::choice("scaling", "asinh", {"asinh", "none"}, "How inputs are compressed"),
        D::choice("trainer", "rprop", {"rprop", "backprop", "lbfgs", "levenberg_marquardt"},
                  "Online back-propagation, or one of those that move once for all rows"),
        D::choice("loss", "cross_entropy", {"cross_entropy", "squared"}, "What the trainer makes small"),
        D::number("goal", 1e-3, 1e-9, 0.25, "-", "Mean squared error over rows and bits to arrive at"),
        D::integer("max_epochs", 10000, 1, 1e8, "-", "Most passes over the rows in one run"),
        D::integer("restarts", 5, 0, 100, "-", "Most runs begun anew for a network that has stalled"),
        D::number("validation", 0.0, 0, 0.5, "-",
                  "Share of the rows held out to stop early; 0: learn all"),
        D::integer("patience", 100, 1, 1e8, "-",
                   "Epochs without a lower error of the held-out rows after which a run ends"),
        D::number("weight_range", 0.5, 1e-6, 100, "-", "Initial weights lie in plus and minus this"),
        D::number("weight_decay", 0.01, 0, 100, "-",
                  "Pull of each weight to zero, added to the gradient (rprop, lbfgs)"),
        D::number("learning_rate_hidden", 0.6, 1e-9, 100, "-",
                  "Rate of the hidden layer's weights (backprop)"),
        D::number("learning_rate_output", 0.5, 1e-9, 100, "-",
                  "Rate of the output layer's weights (backprop)"),
        D::number("momentum", 0.0, 0, 0.999, "-", "Share of its last step that a weight repeats (backprop)"),
    };
  }

  explicit Mlp(const preshape::Parameters& p)
      : hidden_(static_cast<int>(p.integer("hidden"))),
        members_(static_cast<int>(p.integer("committee"))),
        by_fields_(p.text("outputs") == "fields"),
        sharpness_(by_fields_ ? static_cast<int>(p.integer("sharpness")) : 1),
        scaling_(p.text("scaling") == "asinh" ? Scaling::kAsinh : Scaling::kNone) {
    for (const double bits : p.numbers("fields")) fields_.push_back(static_cast<int>(bits));
    settings_.trainer = trainer_named(p.text("trainer"));
    settings_.validation = p.number("validation");
    settings_.patience = static_cast<int>(p.integer("patience"));
    settings_.loss = p.text("loss") == "squared" ? Loss::kSquared : Loss::kCrossEntropy;
    settings_.goal = p.number("goal");
    settings_.max_epochs = static_cast<int>(p.integer("max_epochs"));
    settings_.restarts = static_cast<int>(p.integer("restarts"));
    settings_.weight_range = static_cast<float>(p.number("weight_range"));
    settings_.weight_decay = static_cast<float>(p.number("weight_decay"));
    settings_.rates = {static_cast<float>(p.number("learning_rate_hidden")),
                       static_cast<float>(p.number("learning_rate_output")),
                       static_cast<float>(p.number("momentum"))};
  }

  TrainingOutcome fit(const Matrix& inputs, const Matrix& targets, std::uint64_t seed,
                      preshape::Progress* progress) override {
    const Lesson lesson = lesson_of(inputs, targets);
    State state{static_cast<int>(inputs.cols()), scaling_, lesson.coding, {}};
    const TrainingOutcome outcome = train_committee(lesson, seed, progress, state);
    state_ = std::move(state);
    return outcome;
  }

  /// A fit of everything: it takes milliseconds, and what is known then depends on the rows and the seed
  /// alone, not on the order of learning.
  TrainingOutcome extend(const Matrix& inputs, const Matrix& targets, std::int64_t first_new,
                         std::uint64_t seed, preshape::Progress* progress) override {
    if (first_new < 0 || first_new > inputs.rows()) {
      throw InputError("classifier 'mlp': the first new row must be in 0 .. " +
                       std::to_string(inputs.rows()) + ", got " + std::to_string(first_new));
    }
    return fit(inputs, targets, seed, progress);
  }

  bool trained() const noexcept override { return !state_.committee.empty(); }

  void predict(const Matrix& inputs, Eigen::Ref<RowMatrix> bits) const override {
    check_question(inputs, bits);
    const Shape& shape = state_.committee.front().shape();
    std::vector<float> input(shape.inputs(), 1.0f), hidden(shape.stride()),
        units(static_cast<std::size_t>(shape.outputs)), member(static_cast<std::size_t>(bits.cols()));
    for (Eigen::Index r = 0; r < inputs.rows(); ++r) {
      if (!scale_row(state_.scaling, inputs.row(r).data(), state_.features, input.data())) {
        throw InputError("classifier 'mlp': row " + std::to_string(r + 1) +
                         " holds a number that is not finite");
      }
      bits.row(r).setZero();
      for (const Network& network : state_.committee) {
        network.forward(input.data(), hidden.data(), units.data());
        state_.coding.decode(units.data(), member.data());
        bits.row(r) += Eigen::Map<const Eigen::RowVectorXf>(member.data(), bits.cols()).cast<double>();
      }
      bits.row(r) /= static_cast<double>(state_.committee.size());
    }
  }

  std::string save() const override {
    if (!trained())
      throw InputError("classifier 'mlp' has learned nothing that could be saved; fit it first");
    return state_bytes(state_);
  }

  void load(std::string_view bytes) override {
    State state = state_from(bytes);
    check_same("hidden", state.committee.front().shape().hidden, hidden_);
    check_same("committee", static_cast<int>(state.committee.size()), members_);
    check_same("sharpness", state.coding.sharpness(), sharpness_);
    const auto differ = [](const char* what) {
      throw InputError(std::string("classifier 'mlp': the state was trained with another '") + what +
                       "' than is set now; set that, or train it anew");
    };
    if (state.coding.fields().empty() == by_fields_) differ("outputs");
    if (state.scaling != scaling_) differ("scaling");
    state_ = std::move(state);
  }

 private:
  static void check_same(const char* what, int saved, int set) {
    if (saved == set) return;
    throw InputError(std::string("classifier 'mlp': the state was trained with ") + what + " = " +
                     std::to_string(saved) + ", but it is set to " + std::to_string(set) +
                     "; set that, or train it anew");
  }

  void check_question(const Matrix& inputs, const Eigen::Ref<RowMatrix>& bits) const {
    if (!trained()) throw InputError("classifier 'mlp' has learned nothing yet; fit it first");
    if (inputs.cols() != state_.features || bits.cols() != state_.coding.bits() ||
        bits.rows() != inputs.rows()) {
      throw InputError("classifier 'mlp' has learned " + std::to_string(state_.features) + " inputs and " +
                       std::to_string(state_.coding.bits()) + " bits, but is asked with " +
                       std::to_string(inputs.rows()) + " x " + std::to_string(inputs.cols()) +
                       " inputs for " + std::to_string(bits.rows()) + " x " + std::to_string(bits.cols()) +
                       " bits");
    }
  }

  Lesson lesson_of(const Matrix& inputs, const Matrix& targets) const {
    preshape::check_lesson("mlp", inputs, targets);
    const int bits = static_cast<int>(targets.cols());
    std::vector<float> wanted(static_cast<std::size_t>(targets.size()));
    std::transform(targets.data(), targets.data() + targets.size(), wanted.begin(),
                   [](double bit) { return static_cast<float>(bit); });
    const Coding coding = coding_of(wanted, bits);
    const Shape shape{static_cast<int>(inputs.cols()), hidden_, coding.units()};
    Lesson lesson{Rows(shape, static_cast<std::size_t>(inputs.rows())), std::move(wanted), coding};
    for (std::size_t r = 0; r < lesson.rows.count; ++r) {
      if (!scale_row(scaling_, inputs.row(static_cast<Eigen::Index>(r)).data(), shape.features,
                     lesson.rows.input(r))) {
        throw InputError("classifier 'mlp': row " + std::to_string(r + 1) +
                         " holds a number that is not finite");
      }
      coding.encode(lesson.bits.data() + r * static_cast<std::size_t>(bits), lesson.rows.target(r));
    }
    return lesson;
  }

  Coding coding_of(std::span<const float> wanted, int bits) const {
    if (!by_fields_) return Coding::plain(bits);
    if (std::accumulate(fields_.begin(), fields_.end(), 0) == bits) {
      return Coding::by_fields(fields_, wanted, bits, sharpness_);
    }
    if (bits > 24) {
      throw InputError("classifier 'mlp': 'fields' must add up to the code's " + std::to_string(bits) +
                       " bits, since a single field has at most 24");
    }
    return Coding::by_fields({&bits, 1}, wanted, bits, sharpness_);
  }

  TrainingOutcome train_committee(const Lesson& lesson, std::uint64_t seed, preshape::Progress* progress,
                                  State& state) const {
    TrainingSettings settings = settings_;
    if (contradictory(lesson)) settings.restarts = 0;
    const Shape shape{state.features, hidden_, lesson.coding.units()};
    const preshape::Random random(seed);
    TrainingOutcome outcome;
    std::vector<float> mean(lesson.bits.size());
    for (int m = 0; m < members_; ++m) {
      preshape::Random draws = random.stream("member " + std::to_string(m));
      Trained trained = train(lesson, shape, settings, draws, watcher(progress, m));
      outcome.epochs = std::max<std::int64_t>(outcome.epochs, trained.epochs);
      outcome.restarts += trained.restarts;
      add_bits(trained.network, lesson, mean);
      state.committee.push_back(std::move(trained.network));
    }
    for (float& bit : mean) bit /= static_cast<float>(members_);
    const Fit fit = fit_of(lesson, mean);
    outcome.mean_squared_error = fit.mean_squared_error;
    outcome.wrong_rows = static_cast<std::int64_t>(fit.wrong_rows);
    const bool arrived = fit.wrong_rows == 0 && fit.mean_squared_error <= settings.goal;
    outcome.status = arrived ? TrainingOutcome::Status::kArrived : TrainingOutcome::Status::kStalled;
    return outcome;
  }

  static void add_bits(const Network& network, const Lesson& lesson, std::vector<float>& sums) {
    const auto bits = static_cast<std::size_t>(lesson.coding.bits());
    std::vector<float> hidden(network.shape().stride()), units(lesson.rows.target_width), row(bits);
    for (std::size_t r = 0; r < lesson.rows.count; ++r) {
      network.forward(lesson.rows.input(r), hidden.data(), units.data());
      lesson.coding.decode(units.data(), row.data());
      std::transform(row.begin(), row.end(), sums.begin() + static_cast<std::ptrdiff_t>(r * bits),
                     sums.begin() + static_cast<std::ptrdiff_t>(r * bits), std::plus<>());
    }
  }

  Watcher watcher(preshape::Progress* progress, int member) const {
    return [this, progress, member](int epoch, double error) {
      if (!progress) return;
      const std::string detail = "network " + std::to_string(member + 1) + " of " + std::to_string(members_) +
                                 ", epoch " + std::to_string(epoch) + ", error " +
                                 preshape::number_text(error);
      progress->advance("training", static_cast<double>(member) / members_, detail);
    };
  }

  int hidden_, members_;
  bool by_fields_;
  int sharpness_;
  Scaling scaling_;
  std::vector<int> fields_;
  TrainingSettings settings_;
  State state_;
};

}  // namespace

PRESHAPE_PLUGIN(({"mlp", "1.0.0", "BSD-3-Clause", "the preshape developers", "Multilayer perceptron"}),
                ({"classifier/mlp"}),
                preshape::component<Mlp>("mlp",
                                         "Multilayer perceptron of one hidden layer (thesis sec. 3.10)"))
