#include "lessons.h"

#include <cmath>
#include <limits>

namespace preshape::conformance {

namespace {

Lesson lesson_with(int rows, int features, int bits) {
  return {RowMatrix::Zero(rows, features), RowMatrix::Zero(rows, bits)};
}

}  // namespace

Lesson Lesson::ordered(std::span<const int> order) const {
  Lesson lesson = lesson_with(static_cast<int>(order.size()), static_cast<int>(inputs.cols()), static_cast<int>(targets.cols()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    lesson.inputs.row(static_cast<Eigen::Index>(i)) = inputs.row(order[i]);
    lesson.targets.row(static_cast<Eigen::Index>(i)) = targets.row(order[i]);
  }
  return lesson;
}

Lesson separable_lesson() {
  Lesson lesson = lesson_with(16, 2, 1);
  for (int i = 0; i < 16; ++i) {
    const double side = i % 2 ? 0.5 : -0.5, along = 0.1 * i - 0.8;
    lesson.inputs.row(i) << side + along, side - along;
    lesson.targets(i, 0) = i % 2;
  }
  return lesson;
}

Lesson xor_lesson() {
  Lesson lesson = lesson_with(4, 2, 1);
  lesson.inputs << -1, -1, -1, 1, 1, -1, 1, 1;
  lesson.targets << 0, 1, 1, 0;
  return lesson;
}

Lesson heaps(Random& random, int each) {
  constexpr double kCentre[3][2] = {{0, 0}, {2, 0}, {0, 2}}, kCode[3][2] = {{0, 1}, {1, 0}, {1, 1}}, kDeviation = 0.2;
  Lesson lesson = lesson_with(3 * each, 2, 2);
  for (int i = 0; i < 3 * each; ++i) {
    for (int k = 0; k < 2; ++k) {
      lesson.inputs(i, k) = kCentre[i % 3][k] + kDeviation * random.normal();
      lesson.targets(i, k) = kCode[i % 3][k];
    }
  }
  return lesson;
}

RowMatrix random_rows(Random& random, int rows, int features) {
  RowMatrix matrix(rows, features);
  for (double& x : std::span(matrix.data(), static_cast<std::size_t>(matrix.size()))) x = random.uniform(-2.0, 2.0);
  return matrix;
}

Lesson random_lesson(Random& random, int rows, int features, int bits) {
  Lesson lesson{random_rows(random, rows, features), RowMatrix(rows, bits)};
  for (int k = 0; k < bits; ++k) {
    for (int i = 0; i < rows; ++i) lesson.targets(i, k) = static_cast<double>(random.below(2));
    lesson.targets(k % 2, k) = 0.0;
    lesson.targets(1 - k % 2, k) = 1.0;
  }
  return lesson;
}

Lesson smallest_lesson() {
  Lesson lesson = lesson_with(2, 2, 1);
  lesson.inputs << -1, 0.5, 1, 0.25;
  lesson.targets << 0, 1;
  return lesson;
}

Lesson contradictory_lesson() {
  Lesson lesson = xor_lesson();
  lesson.inputs.row(1) = lesson.inputs.row(0);
  return lesson;
}

TrainingOutcome fit(Classifier& classifier, const Lesson& lesson, std::uint64_t seed) {
  return classifier.fit(lesson.inputs, lesson.targets, seed, nullptr);
}

RowMatrix predicted(const Classifier& classifier, const RowMatrix& questions, Eigen::Index bits) {
  RowMatrix answers = RowMatrix::Constant(questions.rows(), bits, std::numeric_limits<double>::quiet_NaN());
  classifier.predict(questions, answers);
  return answers;
}

std::vector<double> numbers_of(const RowMatrix& matrix) { return {matrix.data(), matrix.data() + matrix.size()}; }

std::int64_t wrong_rows(const RowMatrix& answers, const RowMatrix& targets, bool strict) {
  std::int64_t wrong = 0;
  for (Eigen::Index i = 0; i < answers.rows(); ++i) {
    bool right = true;
    for (Eigen::Index k = 0; k < answers.cols(); ++k) {
      const double margin = targets(i, k) == 1.0 ? answers(i, k) - 0.5 : 0.5 - answers(i, k);
      right = right && (strict ? margin > 0.0 : margin >= 0.0);
    }
    wrong += !right;
  }
  return wrong;
}

std::string no_probability(const RowMatrix& answers) {
  for (Eigen::Index i = 0; i < answers.rows(); ++i) {
    for (Eigen::Index k = 0; k < answers.cols(); ++k) {
      if (answers(i, k) >= 0.0 && answers(i, k) <= 1.0) continue;
      return fmt::format("bit {} of row {} is {}, which is no probability", k + 1, i + 1, answers(i, k));
    }
  }
  return "";
}

}  // namespace preshape::conformance
