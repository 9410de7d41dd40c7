#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>

#include "cube_lessons.h"
#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

using Status = TrainingOutcome::Status;

std::shared_ptr<Classifier> kernel_vote(Value::Table parameters = {}) {
  return registry().create<Classifier>("nadaraya_watson", Value::table(std::move(parameters)));
}

RowMatrix rows(std::initializer_list<std::initializer_list<double>> values) {
  RowMatrix matrix(static_cast<Eigen::Index>(values.size()), static_cast<Eigen::Index>(values.begin()->size()));
  Eigen::Index r = 0;
  for (const auto& row : values) {
    Eigen::Index c = 0;
    for (const double value : row) matrix(r, c++) = value;
    ++r;
  }
  return matrix;
}

RowMatrix predicted(const Classifier& classifier, const RowMatrix& inputs, Eigen::Index bits) {
  RowMatrix result = RowMatrix::Constant(inputs.rows(), bits, std::numeric_limits<double>::quiet_NaN());
  classifier.predict(inputs, result);
  return result;
}

RowMatrix asked(const RowMatrix& inputs, const RowMatrix& targets, const RowMatrix& question,
                Value::Table parameters = {}) {
  const auto classifier = kernel_vote(std::move(parameters));
  classifier->fit(inputs, targets, 1, nullptr);
  return predicted(*classifier, question, targets.cols());
}

RowMatrix random_matrix(Random& random, Eigen::Index m, Eigen::Index n, bool bits) {
  RowMatrix matrix(m, n);
  for (double& x : matrix.reshaped()) x = bits ? static_cast<double>(random.below(2)) : random.uniform(-3, 5);
  return matrix;
}

Value list(std::initializer_list<int> numbers) {
  return Value::list(Value::List(numbers.begin(), numbers.end()));
}

/// One group of `features`, plain numbers.
Value::Table plain(int features, double width, double power) {
  return {{"groups", list({features})}, {"widths", Value::numbers(std::vector<double>{width})}, {"power", power},
          {"sharpness", 1.0}, {"scaling", "none"}};
}

/// Two hundred rows as the agent's memory would hold: the cube's, and tasks with their best grasps on four objects.
std::vector<LessonRow> memory_rows() {
  const std::vector<LessonObject> objects = {
      cube(), {{0.175, 0.683, 0.339}}, {{0.4, 0.4, 0.4}, 0.506, 0.506, 1.0, 0.32}, {{0.3, 0.5, 0.25}, 0.5, 0.5, 1.0, 16.4}};
  auto result = pretraining();
  const auto tasks = signed_task_space();
  for (std::size_t i = 0; result.size() < 200; ++i) {
    const LessonObject& object = objects[i % 4];
    const Screw6& task = tasks[(i * 5) % tasks.size()].screw;
    const LessonGrasp best = best_of_all(object, task);
    if (best.score >= 3.0) result.push_back(task_row(object, task, best.preshape));
  }
  return result;
}

}  // namespace

TEST_CASE("Nadaraya-Watson: votes by hand, the kernel exp(-q / 2) q^(-power / 2) over the rows' spread") {
  // Rows at -1 and 1: the spread is 1. A question at -1/2 has q = 1/4 and 9/4, over the squared width.
  const RowMatrix inputs = rows({{-1}, {1}}), targets = rows({{0}, {1}}), question = rows({{-0.5}});
  const auto share = [](double near, double far, double power) {
    const double a = std::exp(-near / 2) * std::pow(near, -power / 2), b = std::exp(-far / 2) * std::pow(far, -power / 2);
    return b / (a + b);
  };
  CHECK_NEAR(asked(inputs, targets, question, plain(1, 1.0, 2.0)), rows({{share(0.25, 2.25, 2.0)}}), 1e-15);
  CHECK_NEAR(asked(inputs, targets, question, plain(1, 1.0, 0.0)), rows({{share(0.25, 2.25, 0.0)}}), 1e-15);
  CHECK_NEAR(asked(inputs, targets, question, plain(1, 0.5, 4.0)), rows({{share(1.0, 9.0, 4.0)}}), 1e-15);
}

TEST_CASE("Nadaraya-Watson: each group counts by its own spread and width, and a constant one not at all") {
  // Along the first group (spread 1) the second row is nearer, along the other (spread 1000) the first.
  const RowMatrix inputs = rows({{-1, 1000, 7}, {1, -1000, 7}}), targets = rows({{0}, {1}});
  const auto decided = [&](double first, double second, RowMatrix question) {
    return asked(inputs, targets, question,
                 {{"groups", list({1, 1, 1})}, {"scaling", "none"},
                  {"widths", Value::numbers(std::vector<double>{first, second, 1.0})}})(0, 0) > 0.5;
  };
  CHECK_FALSE(decided(1.0, 0.25, rows({{0.5, 500, 7}})));
  CHECK(decided(0.25, 1.0, rows({{0.5, 500, 7}})));
  CHECK(decided(0.25, 1.0, rows({{0.5, 500, -1e9}})));
}

TEST_CASE("Nadaraya-Watson: the votes are those of an own computation in plain sums, on random rows") {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const RowMatrix inputs = random_matrix(random, 25, 4, false), targets = random_matrix(random, 25, 1, true),
                    question = random_matrix(random, 1, 4, false);
    const double power = static_cast<double>(random.below(7));
    const RowMatrix deviations = inputs.rowwise() - inputs.colwise().mean();
    const double spread = std::sqrt(deviations.array().square().mean());
    double ones = 0.0, all = 0.0;
    for (Eigen::Index i = 0; i < 25; ++i) {
      const double d = (inputs.row(i) - question.row(0)).norm() / spread;
      const double vote = std::exp(-d * d / 2) / std::pow(d, power);
      ones += vote * targets(i, 0);
      all += vote;
    }
    const double share = ones / all, winner = std::max(share, 1 - share);
    const double now = asked(inputs, targets, question, plain(4, 1.0, power))(0, 0);
    if (winner >= 0.51) CHECK_NEAR(now, share, 1e-12);
    CHECK((now > 0.5) == (share > 0.5));
  }
}

TEST_CASE("Nadaraya-Watson: what is decided is a code that some row has, field by field") {
  // Three rows about equally far, of two fields of two bits. Bit by bit the majority would be 0 0 0 0; the first field
  // goes to 01, which two rows have, and the second to the nearer one's of those two.
  const RowMatrix inputs = rows({{0, 1}, {1, 0}, {1, 2}}),
                  targets = rows({{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 1, 1, 0}});
  Value::Table parameters = plain(2, 2.0, 0.0);
  parameters.emplace_back("fields", list({2, 2}));
  const RowMatrix bits = asked(inputs, targets, rows({{0.55, 1.02}}), parameters);
  CHECK(bits(0, 0) < 0.5);
  CHECK(bits(0, 1) > 0.5);
  CHECK(bits(0, 2) > 0.5);
  CHECK(bits(0, 3) < 0.5);
  CHECK_NEAR(bits(0, 2) + bits(0, 3), 1.0, 1e-15);  // the row that was voted down has no say in the second field
}

TEST_CASE("Nadaraya-Watson: the 24 pretraining rows are reproduced to the bit, and it recalls a serving plane for "
          "nearly every task of T1 to T3 on the cube") {
  const auto m = matrices(pretraining());
  const auto classifier = kernel_vote();
  const auto outcome = classifier->fit(m.inputs, m.targets, 1, nullptr);
  CHECK(outcome.status == Status::kArrived);
  CHECK(outcome.mean_squared_error == 0.0);
  CHECK(predicted(*classifier, m.inputs, 9) == m.targets);
  int count = 0, served = 0;
  for (const Task& task : signed_task_space()) {
    if (task.name[1] == '4') continue;
    const int plane = recall(*classifier, task_row(cube(), task.screw, {}).inputs).plane;
    ++count;
    served += best_in_plane(cube(), plane, task.screw).score >= 3.0 - 1e-9;
  }
  MESSAGE(served, " of ", count);
  CHECK(count == 60);
  CHECK(served >= 57);
}

TEST_CASE("Nadaraya-Watson: of rows that it has not seen it is about as often right as it says, and says so better than "
          "by the bare shares of the votes") {
  const auto all = matrices(memory_rows());
  const PreshapeCode code(12, 7);
  struct Calibration {
    double said = 0.0, right = 0.0, squares = 0.0;  ///< means
  };
  const auto in_five_parts = [&](Value::Table parameters) {
    Calibration c;
    const double share = 1.0 / static_cast<double>(all.inputs.rows());
    for (Eigen::Index part = 0; part < 5; ++part) {
      std::vector<Eigen::Index> learned, held_out;
      for (Eigen::Index r = 0; r < all.inputs.rows(); ++r) (r % 5 == part ? held_out : learned).push_back(r);
      const auto classifier = kernel_vote(parameters);
      classifier->fit(all.inputs(learned, Eigen::all), all.targets(learned, Eigen::all), 1, nullptr);
      const RowMatrix wanted = all.targets(held_out, Eigen::all),
                      bits = predicted(*classifier, all.inputs(held_out, Eigen::all), 9);
      for (Eigen::Index r = 0; r < bits.rows(); ++r) {
        const auto answer = code.decode(bits.row(r).transpose());
        const bool hit = answer.preshape == code.decode(wanted.row(r).transpose()).preshape;
        c.said += share * answer.confidence;
        c.right += share * hit;
        c.squares += share * (answer.confidence - hit) * (answer.confidence - hit);
      }
    }
    return c;
  };
  const Calibration found = in_five_parts({}), bare = in_five_parts({{"sharpness", 1.0}});
  MESSAGE("says ", found.said, ", is right ", found.right, "; squared difference ", found.squares, ", bare ", bare.squares);
  CHECK(found.right == bare.right);  // no decision depends on it
  CHECK_NEAR(found.said, found.right, 0.1);
  CHECK(found.squares < 0.75 * bare.squares);
}

TEST_CASE("Nadaraya-Watson: equal inputs with different codes are told when given at once; given later, the last is right") {
  const auto classifier = kernel_vote();
  const RowMatrix inputs = rows({{1}, {1}, {2}}), targets = rows({{0}, {1}, {1}});
  const auto outcome = classifier->fit(inputs, targets, 1, nullptr);
  CHECK(outcome.status == Status::kStalled);
  CHECK(outcome.wrong_rows == 1);
  const auto later = kernel_vote();
  later->fit(inputs.bottomRows(2), targets.bottomRows(2), 1, nullptr);
  const auto second = later->extend(inputs.topRows(1), targets.topRows(1), 0, 1, nullptr);
  CHECK(second.status == Status::kArrived);
  CHECK(predicted(*later, rows({{1}, {2}}), 1) == rows({{0}, {1}}));
}

TEST_CASE("Nadaraya-Watson: what was learned lesson by lesson is what would have been learned at once") {
  Random random(3);
  const RowMatrix inputs = random_matrix(random, 40, 5, false), targets = random_matrix(random, 40, 4, true),
                  questions = random_matrix(random, 60, 5, false);
  const auto grown = kernel_vote(), whole = kernel_vote();
  whole->fit(inputs, targets, 1, nullptr);
  for (Eigen::Index first = 0; first < 40; first += 8) {
    grown->extend(inputs.middleRows(first, 8), targets.middleRows(first, 8), 0, 1, nullptr);
  }
  CHECK(grown->save() == whole->save());
  CHECK(predicted(*grown, questions, 4) == predicted(*whole, questions, 4));
  CHECK_THROWS_SAYING(grown->extend(questions.leftCols(3), RowMatrix::Zero(60, 4), 0, 1, nullptr), InputError,
                      "knows rows of 5 inputs and 4 bits, and cannot learn 3 inputs and 4 bits beside them");
  CHECK(grown->save() == whole->save());
}

TEST_CASE("Nadaraya-Watson: far from all rows, where every kernel is nothing, the nearest still decide") {
  const RowMatrix inputs = rows({{-1, 0}, {1, 0}}), targets = rows({{0}, {1}});
  CHECK(asked(inputs, targets, rows({{500, 1e6}}), plain(2, 0.1, 4.0))(0, 0) > 0.999);
  for (const double far : {1e200, 1e300}) {
    const double bit = asked(inputs, targets, rows({{far, far}}), plain(2, 0.1, 4.0))(0, 0);
    CHECK(bit >= 0.0);
    CHECK(bit <= 1.0);
  }
}

TEST_CASE("Nadaraya-Watson: a state comes back as it was, and one that is damaged or another's is refused") {
  Random random(4);
  const RowMatrix inputs = random_matrix(random, 12, 3, false), targets = random_matrix(random, 12, 2, true);
  const auto classifier = kernel_vote(), other = kernel_vote();
  CHECK_THROWS_SAYING(classifier->save(), InputError, "has learned nothing that could be saved");
  classifier->fit(inputs, targets, 1, nullptr);
  const std::string state = classifier->save();
  other->load(state);
  CHECK(other->save() == state);
  CHECK(predicted(*other, inputs, 2) == targets);
  const auto refuse = [&](const std::string& bytes, const char* why) {
    CHECK_THROWS_SAYING(other->load(bytes), InputError, why);
    CHECK(other->save() == state);
  };
  refuse("", "another beginning");
  refuse(state.substr(0, 60), "cut off");
  refuse(state.substr(0, state.size() - 8), "the check sum does not fit");
  const auto knn = registry().create<Classifier>("knn");
  knn->fit(inputs, targets, 1, nullptr);
  refuse(knn->save(), "another beginning");
}

TEST_CASE("Nadaraya-Watson: bad parameters, rows and questions are refused by name") {
  CHECK_THROWS_SAYING(kernel_vote({{"groups", list({3, 3})}}), InputError,
                      "'widths' must have one number for each of the 2 'groups', got 5");
  const auto classifier = kernel_vote();
  RowMatrix bits(1, 1);
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 2), bits), InputError, "has learned nothing yet");
  CHECK_THROWS_SAYING(classifier->fit(RowMatrix(0, 2), RowMatrix(0, 1), 1, nullptr), InputError, "there are no rows");
  RowMatrix inputs = rows({{0, 1}, {2, 3}}), targets = rows({{0}, {1}});
  classifier->fit(inputs, targets, 1, nullptr);
  const std::string before = classifier->save();
  targets(1, 0) = 0.5;
  CHECK_THROWS_SAYING(classifier->fit(inputs, targets, 1, nullptr), InputError, "target 1 of row 2 must be 0 or 1, got 0.5");
  targets(1, 0) = 1.0, inputs(1, 1) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_SAYING(classifier->fit(inputs, targets, 1, nullptr), InputError, "row 2 holds a number that is not finite");
  CHECK_THROWS_SAYING(classifier->fit(inputs.topRows(1), RowMatrix::Ones(1, 30), 1, nullptr), InputError,
                      "'fields' must add up to the code's 30 bits");
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 3), bits), InputError, "has learned 2 inputs and 1 bits");
  CHECK(classifier->save() == before);
}

TEST_SUITE_END();
