#include "../probe.h"

#include "lessons.h"

namespace preshape::conformance {

namespace {

constexpr int kFeatures = 3, kBits = 2, kRows = 6;

Classifier& classifier_at(void* component) { return *static_cast<Classifier*>(component); }

/// The same for every seed, which the training takes instead.
const Lesson& lesson() {
  static const Lesson kLesson = [] {
    Random random(1);
    return random_lesson(random, kRows, kFeatures, kBits);
  }();
  return kLesson;
}

void append(std::vector<double>& numbers, const RowMatrix& matrix) {
  numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
}

void append(std::vector<double>& numbers, const TrainingOutcome& outcome) {
  numbers.insert(numbers.end(), {static_cast<double>(outcome.status), static_cast<double>(outcome.epochs),
                                 static_cast<double>(outcome.restarts), outcome.mean_squared_error,
                                 static_cast<double>(outcome.wrong_rows)});
}

std::vector<double> used(Classifier& classifier, std::uint64_t seed, Progress* progress) {
  Random random(seed);
  const RowMatrix questions = random_rows(random, 10, kFeatures);
  const Lesson first = lesson().first(4);
  std::vector<double> numbers;
  append(numbers, classifier.fit(first.inputs, first.targets, seed, progress));
  append(numbers, predicted(classifier, questions, kBits));
  append(numbers, classifier.extend(lesson().inputs, lesson().targets, 4, seed, progress));
  append(numbers, predicted(classifier, questions, kBits));
  classifier.load(classifier.save());
  append(numbers, predicted(classifier, questions, kBits));
  return numbers;
}

/// A call on matrices that have more room behind what is given, so that a plugin that does not look breaks nothing.
struct Room {
  RowMatrix inputs = RowMatrix::Zero(20, 20), targets = RowMatrix::Zero(20, 20);
};

class ClassifierProbe final : public Probe {
 public:
  std::shared_ptr<void> create(const Registry& registry, const std::string& name, const Value& given) const override {
    return registry.create<Classifier>(name, given);
  }
  const void* extension(void* component, const char* id) const override { return classifier_at(component).extension(id); }

  std::vector<double> use(void* component, std::uint64_t seed) const override {
    return used(classifier_at(component), seed, nullptr);
  }
  std::optional<std::vector<double>> use_told(void* component, std::uint64_t seed, Progress& progress) const override {
    return used(classifier_at(component), seed, &progress);
  }

  std::vector<double> use_const(void* component, std::uint64_t seed) const override {
    const Classifier& classifier = classifier_at(component);
    Random random(seed);
    std::vector<double> numbers = {static_cast<double>(classifier.trained())};
    append(numbers, predicted(classifier, random_rows(random, 10, kFeatures), kBits));
    for (const char byte : classifier.save()) numbers.push_back(byte);
    return numbers;
  }

  std::vector<double> use_in(Arena& arena, void* component, std::uint64_t seed) const override {
    Random random(seed);
    const auto kept = [&arena](const RowMatrix& matrix) {
      const auto numbers = arena.keep(std::span(matrix.data(), static_cast<std::size_t>(matrix.size())));
      return Eigen::Map<const RowMatrix>(numbers.data(), matrix.rows(), matrix.cols());
    };
    const auto inputs = kept(lesson().inputs), targets = kept(lesson().targets), questions = kept(random_rows(random, 10, kFeatures));
    arena.seal();
    classifier_at(component).fit(inputs, targets, seed, nullptr);
    RowMatrix answers(10, kBits);
    classifier_at(component).predict(questions, answers);
    return numbers_of(answers);
  }

  std::vector<Attempt> wrong_sizes(void* component) const override {
    Classifier& classifier = classifier_at(component);
    const auto predict = [&classifier](const char* what, int rows, int features, int answer_rows, int bits, std::vector<std::string> named) {
      return Attempt{fmt::format("predict with {}", what),
                     [=, &classifier] {
                       Room room;
                       classifier.predict(room.inputs.topLeftCorner(rows, features), room.targets.topLeftCorner(answer_rows, bits));
                       return std::vector<double>{};
                     },
                     std::move(named)};
    };
    const auto learn = [&classifier](bool extends) {
      return Attempt{fmt::format("{} with 5 rows of inputs and 4 of targets", extends ? "extend" : "fit"),
                     [extends, &classifier] {
                       const RowMatrix inputs = RowMatrix::Identity(5, kFeatures), targets = RowMatrix::Identity(4, kBits);
                       if (extends) classifier.extend(inputs, targets, 2, 1, nullptr);
                       else classifier.fit(inputs, targets, 1, nullptr);
                       return std::vector<double>{};
                     },
                     {"5", "4"}};
    };
    return {predict("4 features in place of 3", 7, 4, 7, kBits, {"4", "3"}),
            predict("2 features in place of 3", 7, 2, 7, kBits, {"2", "3"}),
            predict("room for 5 bits in place of 2", 7, kFeatures, 7, 5, {"5", "2"}),
            predict("room for 1 bit in place of 2", 7, kFeatures, 7, 1, {"1", "2"}),
            predict("room for 6 rows in place of 7", 7, kFeatures, 6, kBits, {"6", "7"}),
            predict("room for 8 rows in place of 7", 7, kFeatures, 8, kBits, {"8", "7"}),
            learn(false), learn(true)};
  }

  std::vector<Attempt> nonfinite(void* component, double number) const override {
    Classifier& classifier = classifier_at(component);
    return {{fmt::format("predict with {} in the question", number),
             [&classifier, number] {
               RowMatrix question = lesson().inputs.topRows(1);
               question(0, 1) = number;
               return numbers_of(predicted(classifier, question, kBits));
             }},
            {fmt::format("fit with {} in the inputs", number), [&classifier, number] {
               RowMatrix inputs = lesson().inputs.topRows(4);
               inputs(2, 1) = number;
               classifier.fit(inputs, lesson().targets.topRows(4), 1, nullptr);
               return numbers_of(predicted(classifier, inputs, kBits));
             }}};
  }

  std::optional<Answers> batch(void* component, int count, std::uint64_t seed) const override {
    const Classifier& classifier = classifier_at(component);
    Random random(seed);
    const RowMatrix questions = random_rows(random, count, kFeatures);
    Answers answers{numbers_of(predicted(classifier, questions, kBits)), {}};
    for (int i = 0; i < count; ++i) append(answers.singly, predicted(classifier, questions.row(i), kBits));
    return answers;
  }
};

}  // namespace

const Probe& classifier_probe() {
  static const ClassifierProbe kProbe;
  return kProbe;
}

}  // namespace preshape::conformance
