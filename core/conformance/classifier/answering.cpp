// What a classifier says, and what it refuses.
#include <cmath>
#include <limits>

#include "../allocation.h"
#include "classifier.h"
#include "lessons.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// Whether the call ends in an InputError.
bool refused(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError&) {
    return true;
  }
  return false;
}

}  // namespace

void k01_untrained(Context& context) {
  const auto classifier = context.create<Classifier>();
  context.require(!classifier->trained(), "a new one says that it is trained");
  context.require(refused([&] { predicted(*classifier, RowMatrix::Zero(1, 2), 1); }), "a new one predicts, though it has learned nothing");
  context.require(!classifier->trained(), "being asked made it trained");
  fit(*classifier, separable_lesson());
  context.require(classifier->trained(), "after a fit it says that it is not trained");
}

void k08_probabilities(Context& context) {
  const auto classifier = context.create<Classifier>();
  Random random = context.random("lesson");
  fit(*classifier, random_lesson(random, 16, 3, 9));
  const std::vector<Block> blocks = {{"question", 3, -1e6, 1e6, {-1.0, -1e-9, 0.0, 0.5, 1.0, 100.0}}};
  context.for_all(blocks, context.cases(1000), [&](Case c) {
    RowMatrix question(1, 3);
    question << c[0], c[1], c[2];
    return no_probability(predicted(*classifier, question, 9));
  });
}

void k14_bad_rows(Context& context) {
  const auto classifier = context.create<Classifier>();
  const Lesson good = separable_lesson();
  fit(*classifier, good);
  const auto before = predicted(*classifier, good.inputs, 1);
  const auto require_refused = [&](const std::string& what, const std::function<void()>& call) {
    context.require(refused(call), "{} is taken without a word", what);
    context.require(classifier->trained() && predicted(*classifier, good.inputs, 1) == before,
                    "after {} was refused it answers otherwise", what);
  };
  for (const double target : {0.5, 2.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Lesson bad = good;
    bad.targets(3, 0) = target;
    require_refused(fmt::format("fit with the target {}", target), [&] { fit(*classifier, bad); });
    require_refused(fmt::format("extend with the target {}", target),
                    [&] { classifier->extend(bad.inputs, bad.targets, 2, 1, nullptr); });
  }
  for (const std::int64_t first_new : {std::int64_t{-1}, good.rows() + 1}) {
    require_refused(fmt::format("extend of {} rows from row {}", good.rows(), first_new),
                    [&] { classifier->extend(good.inputs, good.targets, first_new, 1, nullptr); });
  }
}

void k15_confidence(Context& context) {
  const auto classifier = context.create<Classifier>();
  Lesson lesson{RowMatrix(12, 1), RowMatrix(12, 1)};
  for (int i = 0; i < 12; ++i) {
    const bool right = i % 2;
    lesson.inputs(i, 0) = (right ? 1.0 : -1.0) * (1.0 + 0.1 * i);
    lesson.targets(i, 0) = right;
  }
  fit(*classifier, lesson);
  double last = 0.0;
  for (int i = 0; i <= 40; ++i) {
    const double x = -1.0 + 0.05 * i, now = predicted(*classifier, RowMatrix::Constant(1, 1, x), 1)(0, 0);
    if (now < last - 1e-9) {
      context.warn(fmt::format("between heaps at -1 and 1 the probability of the right one falls from {} to {} at {}", last, now, x));
      return;
    }
    last = now;
  }
}

void k17_realtime(Context& context) {
  if (!allocations_watched()) context.skip("allocations cannot be watched under a sanitizer");
  const auto classifier = context.create<Classifier>();
  Random random = context.random("rows");
  fit(*classifier, random_lesson(random, 12, 4, 3));
  const RowMatrix questions = random_rows(random, 5, 4);
  RowMatrix answers(5, 3);
  classifier->predict(questions, answers);
  std::size_t count = 0;
  {
    const AllocationWatch watch;
    for (int i = 0; i < 10; ++i) classifier->predict(questions, answers);
    count = watch.count();
  }
  context.require(count == 0, "ten calls of predict after the first allocate {} times", count);
}

}  // namespace preshape::conformance
