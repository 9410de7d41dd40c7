#include <algorithm>
#include <limits>
#include <map>

#include "cube_lessons.h"
#include "preshape/base/error.h"
#include "preshape/base/sha256.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

using Status = TrainingOutcome::Status;

std::shared_ptr<Classifier> knn(Value::Table parameters = {}) {
  return registry().create<Classifier>("knn", Value::table(std::move(parameters)));
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
  RowMatrix result = RowMatrix::Constant(inputs.rows(), bits, std::numeric_limits<double>::quiet_NaN());
  classifier.predict(inputs, result);
  return result;
}

/// After a fit of the rows, the bits for one question.
RowMatrix asked(const RowMatrix& inputs, const RowMatrix& targets, const RowMatrix& question,
                Value::Table parameters = {}) {
  const auto classifier = knn(std::move(parameters));
  classifier->fit(inputs, targets, 1, nullptr);
  return predicted(*classifier, question, targets.cols());
}

RowMatrix random_matrix(Random& random, Eigen::Index m, Eigen::Index n, bool bits) {
  RowMatrix matrix(m, n);
  for (double& x : matrix.reshaped()) x = bits ? static_cast<double>(random.below(2)) : random.uniform(-3, 5);
  return matrix;
}

}  // namespace

TEST_CASE(
    "KNN: votes by hand, two rows at 1/4 and 3/4 of the range count 9 to 1 by the square of the distance") {
  const RowMatrix inputs = rows({{2}, {6}}), targets = rows({{0}, {1}}), question = rows({{3}});
  CHECK_NEAR(asked(inputs, targets, question), rows({{0.1}}), 1e-15);
  CHECK_NEAR(asked(inputs, targets, question, {{"power", 1.0}}), rows({{0.25}}), 1e-15);
  CHECK(asked(inputs, targets, question, {{"k", 1}}) == rows({{0}}));
}

TEST_CASE(
    "KNN: each feature counts by its range, so that its unit does not matter, and a constant one not at "
    "all") {
  // In plain numbers the first row is nearer; over the ranges 1 and 1000 the second one is.
  const RowMatrix inputs = rows({{0, 1000, 7}, {1, 0, 7}}), targets = rows({{0}, {1}});
  CHECK(asked(inputs, targets, rows({{0.9, 600, 7}}), {{"k", 1}}) == rows({{1}}));
  CHECK(asked(inputs, targets, rows({{0.9, 600, -1e9}}), {{"k", 1}}) == rows({{1}}));
}

TEST_CASE("KNN: the votes are those of an own computation by sorting and a table of codes, on random rows") {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const auto k = static_cast<Eigen::Index>(1 + random.below(6));
    const RowMatrix inputs = random_matrix(random, 25, 4, false),
                    targets = random_matrix(random, 25, 3, true),
                    question = random_matrix(random, 1, 4, false);
    const Eigen::RowVectorXd range = inputs.colwise().maxCoeff() - inputs.colwise().minCoeff();
    std::vector<std::pair<double, Eigen::Index>> order;
    for (Eigen::Index i = 0; i < 25; ++i) {
      order.emplace_back(((inputs.row(i) - question.row(0)).array() / range.array()).matrix().norm(), i);
    }
    std::sort(order.begin(), order.end());
    std::map<std::vector<double>, double> share;
    double sum = 0.0;
    for (Eigen::Index i = 0; i < k; ++i) {
      const auto [d, row] = order[static_cast<std::size_t>(i)];
      share[{targets(row, 0), targets(row, 1), targets(row, 2)}] += 1.0 / (d * d);
      sum += 1.0 / (d * d);
    }
    std::vector<double> winner;
    double most = 0.0, mean[3] = {};
    for (const auto& [code, votes] : share) {
      if (votes > most) most = votes, winner = code;
      for (std::size_t b = 0; b < 3; ++b) mean[b] += votes / sum * code[b];
    }
    const RowMatrix bits = asked(inputs, targets, question, {{"k", static_cast<int>(k)}});
    for (std::size_t b = 0; b < 3; ++b) {
      const double now = bits(0, static_cast<Eigen::Index>(b));
      if (most / sum >= 0.51) CHECK_NEAR(now, mean[b], 1e-12);
      CHECK((now > 0.5) == (winner[b] == 1.0));
    }
  }
}

TEST_CASE("KNN: no code is decided that nobody voted for") {
  // Three rows equally far: bit by bit the majority would be 0 0 0.
  const RowMatrix inputs = rows({{0, 1}, {1, 0}, {1, 2}}), targets = rows({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  const RowMatrix bits = asked(inputs, targets, rows({{0.6, 1.05}}), {{"power", 0.0}});
  CHECK_NEAR(bits, rows({{0.245, 0.245, 0.51}}), 1e-12);  // the nearest row's code
  CHECK_NEAR(asked(inputs, targets, rows({{0.9, 1.9}}), {{"power", 0.0}}), rows({{0.51, 0.245, 0.245}}),
             1e-12);
}

TEST_CASE("KNN: more neighbours than rows, one row and equal rows answer as one would say") {
  const RowMatrix one = rows({{1, 2}}), code = rows({{0, 1}});
  CHECK(asked(one, code, rows({{-5, 9}}), {{"k", 64}}) == code);
  const RowMatrix inputs = rows({{0}, {0}, {0}, {1}}), targets = rows({{1}, {1}, {1}, {0}});
  CHECK_NEAR(asked(inputs, targets, rows({{0.75}}), {{"k", 3}, {"power", 0.0}}), rows({{0.49}}),
             1e-15);  // a row given thrice is one
}

TEST_CASE("KNN: equal inputs with different codes are told as rows that it cannot know") {
  const auto classifier = knn();
  const RowMatrix inputs = rows({{1}, {1}, {2}}), targets = rows({{0}, {1}, {1}});
  const auto outcome = classifier->fit(inputs, targets, 1, nullptr);
  CHECK(outcome.status == Status::kStalled);
  CHECK(outcome.wrong_rows == 1);
  CHECK_NEAR(predicted(*classifier, inputs, 1), rows({{0.49}, {0.49}, {1}}), 1e-15);
  CHECK_NEAR(outcome.mean_squared_error, (0.49 * 0.49 + 0.51 * 0.51) / 3, 1e-15);
}

TEST_CASE(
    "KNN: the 24 pretraining rows are reproduced to the bit, and it recalls a serving plane for every task "
    "of T1 to T3 on the cube") {
  const auto m = matrices(pretraining());
  const auto classifier = knn();
  const auto outcome = classifier->fit(m.inputs, m.targets, 1, nullptr);
  CHECK(outcome.status == Status::kArrived);
  CHECK(outcome.mean_squared_error == 0.0);
  CHECK(predicted(*classifier, m.inputs, 9) == m.targets);
  int asked = 0, served = 0;
  for (const Task& task : signed_task_space()) {
    if (task.name[1] == '4') continue;
    const int plane = recall(*classifier, task_row(cube(), task.screw, {}).inputs).plane;
    ++asked;
    served += best_in_plane(cube(), plane, task.screw).score >= 3.0 - 1e-9;
  }
  CHECK(asked == 60);
  CHECK(served == asked);
}

TEST_CASE("KNN: what was learned lesson by lesson is what would have been learned at once") {
  Random random(3);
  const RowMatrix inputs = random_matrix(random, 40, 5, false), targets = random_matrix(random, 40, 4, true),
                  questions = random_matrix(random, 60, 5, false);
  const auto grown = knn(), whole = knn();
  whole->fit(inputs, targets, 1, nullptr);
  // Only the new rows are shown each time.
  for (Eigen::Index first = 0; first < 40; first += 8) {
    grown->extend(inputs.middleRows(first, 8), targets.middleRows(first, 8), 0, 1, nullptr);
  }
  CHECK(grown->save() == whole->save());
  CHECK(predicted(*grown, questions, 4) == predicted(*whole, questions, 4));
  CHECK_THROWS_SAYING(grown->extend(questions.leftCols(3), RowMatrix::Zero(60, 4), 0, 1, nullptr), InputError,
                      "knows rows of 5 inputs and 4 bits, and cannot learn 3 inputs and 4 bits beside them");
  CHECK(grown->save() == whole->save());
}

TEST_CASE("KNN: a state comes back as it was, and one that is damaged, forged or another's is refused") {
  Random random(4);
  const RowMatrix inputs = random_matrix(random, 12, 3, false), targets = random_matrix(random, 12, 2, true);
  const auto classifier = knn(), other = knn();
  CHECK_THROWS_SAYING(classifier->save(), InputError, "has learned nothing that could be saved");
  classifier->fit(inputs, targets, 1, nullptr);
  const std::string state = classifier->save();
  other->load(state);
  CHECK(other->save() == state);
  CHECK(predicted(*other, inputs, 2) == targets);
  const auto refuse = [&](std::string bytes, const char* why) {
    INFO(why);
    CHECK_THROWS_SAYING(other->load(bytes), InputError, why);
    CHECK(other->save() == state);
  };
  refuse("", "another beginning");
  refuse("preshape knn 2" + state.substr(14), "another beginning, or another version");
  refuse(state.substr(0, 60), "cut off");
  refuse(state.substr(0, state.size() - 8), "the check sum does not fit");
  for (std::size_t i = 90; i < state.size(); i += 37) {
    std::string damaged = state;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    refuse(damaged, "the check sum does not fit");
  }
  // What somebody wrote who knows the check sum.
  const auto forged = [&](auto change) {
    std::string body = state.substr(15 + 64);
    change(body);
    return state.substr(0, 15) + sha256_hex(body) + body;
  };
  CHECK(forged([](std::string&) {}) == state);
  refuse(forged([](std::string& body) { body[0] = 11; }), "sizes that do not fit its length");
  refuse(forged([](std::string& body) { body[23] = '\x7f'; }), "sizes that do not fit its length");
  refuse(forged([](std::string& body) { std::swap_ranges(&body[24], &body[48], &body[48]); }),
         "rows that are not in order");
  refuse(forged([](std::string& body) { body[body.size() - 2] ^= 1; }), "must be 0 or 1");
}

TEST_CASE("KNN: bad rows and bad questions are refused") {
  const auto classifier = knn();
  RowMatrix bits(1, 2);
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 3), bits), InputError,
                      "has learned nothing yet");
  const RowMatrix inputs = rows({{0, 1, 2}, {2, 1, 0}}), targets = rows({{0, 1}, {1, 1}});
  classifier->fit(inputs, targets, 1, nullptr);
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(1, 4), bits), InputError,
                      "has learned 3 inputs and 2 bits");
  CHECK_THROWS_SAYING(classifier->predict(RowMatrix::Zero(2, 3), bits), InputError,
                      "2 x 3 inputs for 1 x 2 bits");
  RowMatrix bad = inputs;
  bad(1, 0) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_SAYING(classifier->predict(bad.bottomRows(1), bits), InputError,
                      "row 1 holds a number that is not finite");
  CHECK_THROWS_SAYING(classifier->fit(bad, targets, 1, nullptr), InputError,
                      "row 2 holds a number that is not finite");
  CHECK_THROWS_SAYING(classifier->fit(inputs, targets * 0.5, 1, nullptr), InputError,
                      "target 2 of row 1 must be 0 or 1, got 0.5");
  CHECK_THROWS_SAYING(classifier->fit(inputs, targets.topRows(1), 1, nullptr), InputError,
                      "2 x 3 inputs do not go with 1 x 2 targets");
  CHECK_THROWS_SAYING(classifier->extend(inputs, targets, 3, 1, nullptr), InputError,
                      "must be in 0 .. 2, got 3");
}

TEST_SUITE_END();
