// What a classifier learns from which rows.
#include <algorithm>
#include <numeric>

#include "classifier.h"
#include "lessons.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

std::string state_after(Context& context, const Lesson& lesson, std::uint64_t seed) {
  const auto classifier = context.create<Classifier>();
  fit(*classifier, lesson, seed);
  return classifier->save();
}

RowMatrix answers_after(Context& context, const Lesson& lesson, const RowMatrix& questions) {
  const auto classifier = context.create<Classifier>();
  fit(*classifier, lesson);
  return predicted(*classifier, questions, lesson.targets.cols());
}

std::int64_t wrong_after(Context& context, const Lesson& lesson, const Lesson& asked, std::uint64_t seed = 1) {
  const auto classifier = context.create<Classifier>();
  fit(*classifier, lesson, seed);
  return wrong_rows(predicted(*classifier, asked.inputs, asked.targets.cols()), asked.targets);
}

/// Rows in which a bit is decided otherwise; bits on the border are passed over.
std::int64_t decided_otherwise(const RowMatrix& before, const RowMatrix& now) {
  std::int64_t rows = 0;
  for (Eigen::Index i = 0; i < before.rows(); ++i) {
    const auto clear = (before.row(i).array() - 0.5).abs() > 1e-6;
    rows += (clear && (before.row(i).array() > 0.5) != (now.row(i).array() > 0.5)).any();
  }
  return rows;
}

/// Heaps of six rows, one after another: two to learn first, and one that they do not tell of.
Lesson heap_by_heap(Random& random) {
  std::vector<int> order;
  for (int heap = 0; heap < 3; ++heap) {
    for (int i = 0; i < 6; ++i) order.push_back(3 * i + heap);
  }
  return heaps(random, 6).ordered(order);
}

std::vector<int> shuffled(int count, Random& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

}  // namespace

void k02_seeds(Context& context) {
  Random random = context.random("lesson");
  const bool declared = context.declares("seedless");
  bool differs = false;
  for (int i = 0; i < context.cases(2); ++i) {
    const Lesson lesson = random_lesson(random, 10, 3, 2);
    const std::uint64_t seed = random();
    const std::string state = state_after(context, lesson, seed);
    context.require(state == state_after(context, lesson, seed), "fitted twice with the seed {} it has two states", seed);
    const bool same = state == state_after(context, lesson, seed + 1);
    context.require(same || !declared, "the seeds {} and {} give two states, though it promises 'seedless'", seed, seed + 1);
    differs = differs || !same;
  }
  if (!declared && !differs) context.warn("no two seeds with two states were found; it may promise 'seedless'");
}

void k04_separable(Context& context) {
  const bool declared = context.declares("nonlinear");
  bool learns = true;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(context.cases(3)); ++seed) {
    const std::int64_t wrong = wrong_after(context, separable_lesson(), separable_lesson(), seed);
    context.require(wrong == 0, "of 16 rows on two sides of a line it has {} wrong with the seed {}", wrong, seed);
    const std::int64_t wrong_xor = wrong_after(context, xor_lesson(), xor_lesson(), seed);
    context.require(wrong_xor == 0 || !declared, "of the 4 rows of exclusive or it has {} wrong with the seed {}", wrong_xor, seed);
    learns = learns && wrong_xor == 0;
  }
  if (!declared && learns) context.warn("it learned exclusive or from every seed; it may promise 'nonlinear'");
}

void k05_held_out(Context& context) {
  Random random = context.random("rows");
  const Lesson lesson = heaps(random, 8), asked = heaps(random, 100);
  const std::int64_t wrong = wrong_after(context, lesson, asked);
  context.require(100 * wrong <= asked.rows(), "of {} new rows from the heaps that it has learned it has {} wrong", asked.rows(), wrong);
  if (!context.declares("interpolating")) return;
  for (int i = 0; i < context.cases(5); ++i) {
    const Lesson any = random_lesson(random, 20, 4, 3);
    const std::int64_t own = wrong_after(context, any, any);
    context.require(own == 0, "of 20 rows that it has learned it has {} wrong", own);
  }
}

void k09_relabelled(Context& context) {
  Random random = context.random("rows");
  const Lesson lesson = heaps(random, 6);
  const RowMatrix plain = answers_after(context, lesson, lesson.inputs);
  const Lesson swapped{lesson.inputs, lesson.targets.rowwise().reverse()};
  const RowMatrix back = answers_after(context, swapped, lesson.inputs).rowwise().reverse();
  std::int64_t otherwise = decided_otherwise(plain, back);
  context.require(otherwise == 0, "with the bits of the code swapped it decides {} of {} rows otherwise", otherwise, lesson.rows());
  std::vector<int> twice(static_cast<std::size_t>(2 * lesson.rows()));
  for (std::size_t i = 0; i < twice.size(); ++i) twice[i] = static_cast<int>(i / 2);
  otherwise = decided_otherwise(plain, answers_after(context, lesson.ordered(twice), lesson.inputs));
  context.require(otherwise == 0, "with each row given twice it decides {} of {} rows otherwise", otherwise, lesson.rows());
  if (!context.declares("order_invariant")) return;
  for (int i = 0; i < context.cases(3); ++i) {
    const Lesson any = random_lesson(random, 15, 4, 3);
    const RowMatrix questions = random_rows(random, 30, 4);
    const Lesson mixed = any.ordered(shuffled(15, random));
    const RowMatrix before = answers_after(context, any, questions), now = answers_after(context, mixed, questions);
    // Sums over the rows may be rounded in another order.
    const double apart = (before - now).cwiseAbs().maxCoeff();
    context.require(apart <= 1e-9, "with its rows in another order it predicts {} beside before", apart);
  }
}

void k10_scaled(Context& context) {
  Random random = context.random("rows");
  for (int i = 0; i < context.cases(5); ++i) {
    Lesson lesson = random_lesson(random, 15, 3, 2);
    RowMatrix questions = random_rows(random, 50, 3);
    const RowMatrix before = answers_after(context, lesson, questions);
    const auto feature = static_cast<Eigen::Index>(random.below(3));
    const double factor = i % 2 ? random.uniform(10.0, 1000.0) : random.uniform(0.001, 0.1);
    lesson.inputs.col(feature) *= factor, questions.col(feature) *= factor;
    const std::int64_t otherwise = decided_otherwise(before, answers_after(context, lesson, questions));
    context.require(otherwise == 0, "with feature {} times {} it decides {} of 50 questions otherwise", feature + 1, factor, otherwise);
  }
}

void k11_degenerate(Context& context) {
  Random random = context.random("rows");
  Lesson one_code = random_lesson(random, 6, 3, 2), constant = random_lesson(random, 6, 3, 2), equal = one_code;
  one_code.targets.rowwise() = Eigen::RowVector2d(0.0, 1.0);
  constant.inputs.col(1).setConstant(0.7);
  equal.inputs.rowwise() = Eigen::RowVector3d(0.1, 0.2, 0.3);
  equal.targets = one_code.targets;
  const std::pair<const char*, Lesson> lessons[] = {{"one row", one_code.first(1)},
                                                    {"one code", one_code},
                                                    {"a constant feature", constant},
                                                    {"more features than rows", random_lesson(random, 3, 20, 2)},
                                                    {"rows that are all equal", equal},
                                                    {"rows with equal inputs and other targets", contradictory_lesson()}};
  for (const auto& [what, lesson] : lessons) {
    const auto classifier = context.create<Classifier>();
    try {
      fit(*classifier, lesson);
    } catch (const InputError&) {
      continue;
    }
    RowMatrix questions = random_rows(random, static_cast<int>(lesson.rows()) + 5, static_cast<int>(lesson.inputs.cols()));
    questions.topRows(lesson.rows()) = lesson.inputs;
    const std::string found = no_probability(predicted(*classifier, questions, lesson.targets.cols()));
    context.require(found.empty(), "after a lesson of {} {}", what, found);
  }
  const auto classifier = context.create<Classifier>();
  bool refused = false;
  try {
    fit(*classifier, one_code.first(0));
  } catch (const InputError&) {
    refused = true;
  }
  context.require(refused && !classifier->trained(), "a lesson without rows is taken without a word");
}

void k12_forgets(Context& context) {
  Random random = context.random("rows");
  for (int i = 0; i < context.cases(2); ++i) {
    // Of the same size and of another.
    const Lesson old = random_lesson(random, 12, i % 2 ? 5 : 3, i % 2 ? 4 : 2), now = random_lesson(random, 8, 3, 2);
    const RowMatrix questions = random_rows(random, 30, 3);
    const auto classifier = context.create<Classifier>();
    fit(*classifier, old), fit(*classifier, now);
    context.require(predicted(*classifier, questions, 2) == answers_after(context, now, questions),
                    "fitted to other rows before, it answers otherwise than one that was not");
  }
}

void k18_extends(Context& context) {
  Random random = context.random("rows");
  const Lesson lesson = heap_by_heap(random);
  const auto fresh = context.create<Classifier>(), grown = context.create<Classifier>();
  fresh->extend(lesson.inputs, lesson.targets, 0, 1, nullptr);
  context.require(predicted(*fresh, lesson.inputs, 2) == answers_after(context, lesson, lesson.inputs),
                  "without a fit before, extend answers otherwise than fit");
  fit(*grown, lesson.first(12));
  grown->extend(lesson.inputs, lesson.targets, 12, 1, nullptr);
  const std::int64_t wrong = wrong_rows(predicted(*grown, lesson.inputs, 2), lesson.targets);
  context.require(wrong == 0, "extended by a third heap it has {} of 18 rows wrong", wrong);
}

void k19_incremental(Context& context) {
  Random random = context.random("rows");
  const Lesson lesson = heap_by_heap(random);
  const auto classifier = context.create<Classifier>();
  fit(*classifier, lesson.first(12));
  Lesson shown = lesson;
  for (Eigen::Index i = 0; i < 12; ++i) {
    shown.inputs.row(i) = lesson.inputs.row(12);
    shown.targets.row(i) = lesson.targets.row(12);
  }
  classifier->extend(shown.inputs, shown.targets, 12, 1, nullptr);
  const std::int64_t wrong = wrong_rows(predicted(*classifier, lesson.inputs, 2), lesson.targets);
  context.require(wrong == 0, "after extend with a third heap alone it has {} of 12 old and 6 new rows wrong", wrong);
}

void k20_outcome(Context& context) {
  Random random = context.random("rows");
  const std::pair<const char*, Lesson> lessons[] = {{"heaps", heaps(random, 5)},
                                                    {"exclusive or", xor_lesson()},
                                                    {"random rows", random_lesson(random, 20, 3, 4)},
                                                    {"rows with equal inputs and other targets", contradictory_lesson()}};
  for (const auto& [what, lesson] : lessons) {
    const auto classifier = context.create<Classifier>();
    const TrainingOutcome outcome = fit(*classifier, lesson);
    const RowMatrix answers = predicted(*classifier, lesson.inputs, lesson.targets.cols());
    const std::int64_t least = wrong_rows(answers, lesson.targets, false), most = wrong_rows(answers, lesson.targets, true);
    context.require(outcome.wrong_rows >= least && outcome.wrong_rows <= most,
                    "of {} it says that it has {} of {} wrong, but it has {}", what, outcome.wrong_rows, lesson.rows(), most);
    context.require(outcome.epochs >= 0 && outcome.restarts >= 0 && outcome.mean_squared_error >= 0.0 && outcome.mean_squared_error <= 1.0,
                    "of {} it says that it took {} epochs and {} restarts to a mean squared error of {}", what, outcome.epochs,
                    outcome.restarts, outcome.mean_squared_error);
  }
}

}  // namespace preshape::conformance
