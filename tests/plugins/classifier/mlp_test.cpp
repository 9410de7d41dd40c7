#include <thread>

#include "cube_lessons.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

using Status = TrainingOutcome::Status;

std::shared_ptr<Classifier> mlp(Value::Table parameters = {}) {
  return registry().create<Classifier>("mlp", Value::table(std::move(parameters)));
}

/// Appendix A's network. Small initial weights, from which it stalls less often.
Value::Table thesis() {
  return {{"outputs", "bits"},     {"committee", 1},    {"scaling", "none"},
          {"trainer", "backprop"}, {"loss", "squared"}, {"weight_range", 0.05}};
}

RowMatrix rows(std::initializer_list<std::initializer_list<double>> values) {
  RowMatrix matrix(static_cast<Eigen::Index>(values.size()),
                   static_cast<Eigen::Index>(values.begin()->size()));
  Eigen::Index r = 0;
  for (const auto& row : values) {
    Eigen::Index c = 0;
    for (const double value : row) matrix(r, c++) = value;
    ++r;
  }
  return matrix;
}

RowMatrix predicted(const Classifier& classifier, const RowMatrix& inputs, Eigen::Index bits) {
  RowMatrix result(inputs.rows(), bits);
  classifier.predict(inputs, result);
  return result;
}

const RowMatrix kXorInputs = rows({{0, 0}, {0, 1}, {1, 0}, {1, 1}}), kXorTargets = rows({{0}, {1}, {1}, {0}});

struct Stop : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Counts, and throws at the given call.
class CountingProgress final : public Progress {
 public:
  explicit CountingProgress(int stop_at = 1 << 30) : stop_at_(stop_at) {}
  void advance(std::string_view stage, double fraction, std::string_view detail) override {
    CHECK(stage == "training");
    CHECK(fraction >= 0.0);
    CHECK(fraction <= 1.0);
    last = detail;
    if (++count >= stop_at_) throw Stop("stopped");
  }
  int count = 0;
  std::string last;

 private:
  int stop_at_;
};

}  // namespace

TEST_CASE("MLP: exclusive or is learned, by each trainer, loss and coding") {
  for (const char* trainer : {"rprop", "backprop"}) {
    for (const char* loss : {"cross_entropy", "squared"}) {
      for (const char* outputs : {"fields", "bits"}) {
        if (std::string(loss) == "squared" && std::string(trainer) == "rprop") continue;  // see the README
        CAPTURE(trainer);
        CAPTURE(loss);
        CAPTURE(outputs);
        const auto classifier = mlp({{"trainer", trainer},
                                     {"loss", loss},
                                     {"outputs", outputs},
                                     {"hidden", 8},
                                     {"committee", 1},
                                     {"restarts", 10}});
        const auto outcome = classifier->fit(kXorInputs, kXorTargets, 1, nullptr);
        CHECK(outcome.status == Status::kArrived);
        CHECK_NEAR(predicted(*classifier, kXorInputs, 1), kXorTargets,
                   0.1);  // 4 sqrt(goal), and the worst of 4 rows
      }
    }
  }
}

TEST_CASE("MLP: the 24 pretraining rows are learned from every one of 20 seeds") {
  const auto m = matrices(pretraining());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto classifier = mlp();
    const auto outcome = classifier->fit(m.inputs, m.targets, seed, nullptr);
    CHECK(outcome.status == Status::kArrived);
    CHECK(outcome.mean_squared_error <= 1e-3);
    CHECK(outcome.wrong_rows == 0);
    CHECK(outcome.restarts == 0);
    CHECK(outcome.epochs < 150);
    const RowMatrix errors = predicted(*classifier, m.inputs, 9) - m.targets;
    CHECK_NEAR(errors.squaredNorm() / static_cast<double>(errors.size()), outcome.mean_squared_error, 1e-6);
  }
}

TEST_CASE("MLP: the thesis's network arrives by back-propagation, in hundreds to thousands of epochs") {
  const auto m = matrices(pretraining());
  std::int64_t most = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto outcome = mlp(thesis())->fit(m.inputs, m.targets, seed, nullptr);
    CHECK(outcome.status == Status::kArrived);
    CHECK(outcome.wrong_rows == 0);
    most = std::max(most, outcome.epochs);
  }
  CHECK(most > 100);
}

TEST_CASE("MLP: the same rows and seed give the same bytes, another seed others") {
  const auto m = matrices(pretraining());
  const auto state = [&](std::uint64_t seed) {
    const auto classifier = mlp();
    classifier->fit(m.inputs, m.targets, seed, nullptr);
    return classifier->save();
  };
  const std::string first = state(5);
  CHECK(state(5) == first);
  CHECK(state(6) != first);
}

TEST_CASE("MLP: extending is learning everything, whatever was known before") {
  const auto m = matrices(pretraining());
  const auto direct = mlp(), stepwise = mlp();
  direct->fit(m.inputs, m.targets, 3, nullptr);
  stepwise->fit(m.inputs.topRows(10), m.targets.topRows(10), 8, nullptr);
  stepwise->extend(m.inputs, m.targets, 10, 3, nullptr);
  CHECK(stepwise->save() == direct->save());
  CHECK_THROWS_SAYING(stepwise->extend(m.inputs, m.targets, 25, 3, nullptr), InputError,
                      "the first new row must be in 0 .. 24, got 25");
}

TEST_CASE("MLP: a saved state predicts bit for bit the same") {
  const auto m = matrices(pretraining());
  const auto classifier = mlp(), copy = mlp();
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  CHECK_FALSE(copy->trained());
  copy->load(classifier->save());
  CHECK(copy->trained());
  Random random(1);
  RowMatrix questions(100, kFeatures);
  for (Eigen::Index i = 0; i < questions.size(); ++i) questions.data()[i] = random.uniform(-3, 3);
  CHECK((predicted(*copy, questions, 9).array() == predicted(*classifier, questions, 9).array()).all());
  CHECK(copy->save() == classifier->save());
}

TEST_CASE("MLP: bytes that do not fit leave the classifier as it was") {
  const auto m = matrices(pretraining());
  const auto classifier = mlp();
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const std::string before = classifier->save();
  const auto refuse = [&](std::string_view bytes, const char* part) {
    CHECK_THROWS_SAYING(classifier->load(bytes), InputError, part);
    CHECK(classifier->save() == before);
  };
  refuse("", "no state of classifier 'mlp'");
  refuse(std::string(1 << 20, '\x7f'), "no state of classifier 'mlp'");
  refuse(before.substr(0, before.size() / 2), "cut off or changed");
  const auto state_with = [&](Value::Table parameters) {
    const auto other = mlp(std::move(parameters));
    other->fit(m.inputs, m.targets, 1, nullptr);
    return other->save();
  };
  refuse(state_with({{"hidden", 20}}), "trained with hidden = 20, but it is set to 45");
  refuse(state_with({{"committee", 2}}), "trained with committee = 2, but it is set to 5");
  refuse(state_with({{"sharpness", 2}}), "trained with sharpness = 2, but it is set to 4");
  refuse(state_with({{"scaling", "none"}}), "trained with another 'scaling'");
  CHECK_THROWS_SAYING(mlp()->save(), InputError, "has learned nothing");
}

TEST_CASE("MLP: rows that contradict each other end as stalled and are counted") {
  auto m = matrices(pretraining());
  m.inputs.row(1) = m.inputs.row(0);
  const auto outcome = mlp()->fit(m.inputs, m.targets, 1, nullptr);
  CHECK(outcome.status == Status::kStalled);
  CHECK(outcome.wrong_rows >= 1);
  CHECK(outcome.wrong_rows <= 2);
  CHECK(outcome.restarts == 0);
  CHECK(outcome.epochs < 5000);
}

TEST_CASE("MLP: a mean below the goal is not enough while a row is wrong") {
  RowMatrix inputs(60, 1), targets(60, 1);
  for (Eigen::Index r = 0; r < 60; ++r)
    inputs(r, 0) = static_cast<double>(r % 2), targets(r, 0) = inputs(r, 0);
  targets(59, 0) = 0.0;  // one contradiction among sixty rows: an error of about 1/60
  const auto outcome = mlp({{"goal", 0.2}})->fit(inputs, targets, 1, nullptr);
  CHECK(outcome.mean_squared_error < 0.2);
  CHECK(outcome.wrong_rows == 1);
  CHECK(outcome.status == Status::kStalled);
}

TEST_CASE("MLP: bad rows are refused by name, and what was known stays") {
  const auto m = matrices(pretraining());
  const auto classifier = mlp();
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const std::string before = classifier->save();
  const auto refuse = [&](const RowMatrix& inputs, const RowMatrix& targets, const char* part) {
    CHECK_THROWS_SAYING(classifier->fit(inputs, targets, 1, nullptr), InputError, part);
    CHECK_THROWS_SAYING(classifier->extend(inputs, targets, 0, 1, nullptr), InputError, part);
    CHECK(classifier->save() == before);
  };
  refuse(RowMatrix(0, 15), RowMatrix(0, 9), "there are no rows to learn");
  refuse(m.inputs.topRows(3), m.targets, "3 x 15 inputs do not go with 24 x 9 targets");
  RowMatrix inputs = m.inputs, targets = m.targets;
  inputs(6, 2) = std::numeric_limits<double>::quiet_NaN();
  refuse(inputs, targets, "row 7 holds a number that is not finite");
  targets(4, 0) = 0.5;
  refuse(m.inputs, targets, "target 1 of row 5 must be 0 or 1, got 0.5");
}

TEST_CASE("MLP: bad questions are refused") {
  RowMatrix bits(1, 9);
  CHECK_THROWS_SAYING(mlp()->predict(RowMatrix::Zero(1, 15), bits), InputError, "has learned nothing yet");
  const auto m = matrices(pretraining());
  const auto classifier = mlp();
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 14), bits), InputError,
                      "has learned 15 inputs and 9 bits");
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(2, 15), bits), InputError,
                      "2 x 15 inputs for 1 x 9 bits");
  RowMatrix infinite = RowMatrix::Zero(1, 15);
  infinite(0, 3) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_SAYING(classifier->predict(infinite, bits), InputError,
                      "row 1 holds a number that is not finite");
}

TEST_CASE("MLP: progress is told, and stopping it leaves what was known") {
  const auto m = matrices(pretraining());
  const auto classifier = mlp();
  CountingProgress progress;
  classifier->fit(m.inputs, m.targets, 1, &progress);
  CHECK(progress.count >= 5);
  CHECK(progress.last.find("network 5 of 5, epoch ") != std::string::npos);
  const std::string before = classifier->save();
  CountingProgress stopping(3);
  CHECK_THROWS_AS(classifier->fit(m.inputs, m.targets, 2, &stopping), Stop);
  CHECK(classifier->save() == before);
}

TEST_CASE("MLP: a code that the fields do not add up to is one field") {
  const auto classifier = mlp({{"committee", 1}});
  const RowMatrix inputs = rows({{-1}, {0}, {1}}),
                  targets = rows({{0, 0, 0, 0, 1}, {1, 0, 1, 0, 0}, {1, 1, 1, 1, 1}});
  CHECK(classifier->fit(inputs, targets, 1, nullptr).status == Status::kArrived);
  CHECK_NEAR(predicted(*classifier, inputs, 5), targets, 0.2);
  const RowMatrix wide = RowMatrix::Ones(1, 30);
  CHECK_THROWS_SAYING(classifier->fit(inputs.topRows(1), wide, 1, nullptr), InputError,
                      "'fields' must add up to the code's 30 bits");
}

TEST_CASE("MLP: several threads may ask at once") {
  const auto m = matrices(pretraining());
  const auto classifier = mlp();
  classifier->fit(m.inputs, m.targets, 1, nullptr);
  const RowMatrix expected = predicted(*classifier, m.inputs, 9);
  std::vector<int> differing(4, 0);
  std::vector<std::thread> threads;
  for (int& count : differing) {
    threads.emplace_back([&] {
      for (int i = 0; i < 50; ++i)
        count += (predicted(*classifier, m.inputs, 9).array() != expected.array()).any();
    });
  }
  for (auto& thread : threads) thread.join();
  CHECK(differing == std::vector<int>(4, 0));
}

TEST_SUITE_END();
