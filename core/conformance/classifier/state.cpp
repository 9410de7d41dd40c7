// A classifier's state as bytes.
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

#include "../allocation.h"
#include "../fresh_process.h"
#include "classifier.h"
#include "lessons.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// The lesson of the round trip: a code of nine bits, as the agent has it.
struct Trip {
  Lesson lesson;
  RowMatrix questions;
  explicit Trip(Context& context) {
    Random random = context.random("round trip");
    lesson = random_lesson(random, 12, 6, 9);
    questions = random_rows(random, 40, 6);
  }
};

std::string unhexed(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(std::string(text.substr(i, 2)), nullptr, 16));
  }
  return bytes;
}

/// While it lives, the process may take no more than so much memory beside what it has.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) {
    if (!allocations_watched()) return;  // a sanitizer takes what it likes
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &before_);
    rlimit now = before_;
    now.rlim_cur = std::min(before_.rlim_max, static_cast<rlim_t>(pages * static_cast<std::size_t>(getpagesize()) + more));
    setrlimit(RLIMIT_AS, &now);
    set_ = true;
  }
  ~MemoryLimit() {
    if (set_) setrlimit(RLIMIT_AS, &before_);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
  bool set_ = false;
};

/// A classifier that has learned the smallest lesson, its state and what it answers.
class Patient {
 public:
  explicit Patient(Context& context) : classifier_(context.create<Classifier>()) {
    fit(*classifier_, lesson_);
    state_ = classifier_->save();
    answers_ = predicted(*classifier_, lesson_.inputs, 1);
  }
  const std::string& state() const { return state_; }

  /// Gives it the bytes. @returns "" when it refuses them and is as before, or takes them where it may and still
  /// answers like a classifier
  std::string swallow(const std::string& bytes, bool may_take) {
    try {
      classifier_->load(bytes);
    } catch (const InputError&) {
      const bool same = classifier_->trained() && predicted(*classifier_, lesson_.inputs, 1) == answers_;
      return same ? "" : "it refuses the bytes, but answers otherwise than before";
    } catch (const std::exception& error) {
      return fmt::format("it throws \"{}\", which is no InputError", error.what());
    }
    const std::string found = may_take ? after_taking() : bytes == state_ ? "" : "it takes the bytes for a state";
    classifier_->load(state_);
    return found;
  }

 private:
  std::string after_taking() const {
    try {
      return no_probability(predicted(*classifier_, lesson_.inputs, 1));
    } catch (const InputError&) {
      return "";  // of other sizes now
    }
  }

  std::shared_ptr<Classifier> classifier_;
  Lesson lesson_ = smallest_lesson();
  std::string state_;
  RowMatrix answers_;
};

std::string random_bytes(Random& random, std::size_t count) {
  std::string bytes(count, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random.below(256));
  return bytes;
}

}  // namespace

std::string k06_answers(Context& context, std::string_view state) {
  const Trip trip(context);
  const auto classifier = context.create<Classifier>();
  classifier->load(unhexed(state));
  return hex_text(numbers_of(predicted(*classifier, trip.questions, 9)));
}

void k06_round_trip(Context& context) {
  const Trip trip(context);
  const auto original = context.create<Classifier>(), fresh = context.create<Classifier>(), used = context.create<Classifier>();
  fit(*original, trip.lesson);
  const RowMatrix answers = predicted(*original, trip.questions, 9);
  const std::string state = original->save();
  context.require(state == original->save(), "saved twice it has two states");
  fit(*used, smallest_lesson());
  for (const auto& [what, other] : {std::pair{"a new one", fresh}, std::pair{"one that had learned something else", used}}) {
    other->load(state);
    context.require(other->trained(), "{} that has loaded a state says that it is not trained", what);
    context.require(predicted(*other, trip.questions, 9) == answers, "{} that has loaded the state predicts otherwise", what);
    context.require(other->save() == state, "{} that has loaded the state saves other bytes", what);
  }
  context.require(context.in_fresh_process(hex_text(state)) == hex_text(numbers_of(answers)),
                  "in another process the loaded state predicts otherwise");
}

void k07_bad_states(Context& context) {
  Patient patient(context);
  const std::string state = patient.state();
  Random random = context.random("bytes");
  const double last = static_cast<double>(state.size() - 1);
  const MemoryLimit limit(std::size_t{256} << 20);

  const auto require_refused = [&](const char* what, const std::string& bytes) {
    const std::string found = patient.swallow(bytes, false);
    context.require(found.empty(), "given {}: {}", what, found);
  };
  require_refused("no bytes", "");
  require_refused("the state of another component", "preshape classifier some_other 1\n" + state);
  require_refused("a state with a byte after it", state + '\0');
  for (int i = 0; i < 3; ++i) require_refused("random bytes", random_bytes(random, std::size_t{1} << (context.cases(1) > 1 ? 20 : 14)));

  const std::vector<Block> lengths = {{"length", 1, 0.0, last, {}, true}};
  context.for_all(lengths, context.cases(300), [&](Case c) {
    const std::string found = patient.swallow(state.substr(0, static_cast<std::size_t>(c[0])), false);
    return found.empty() ? "" : fmt::format("given its state cut off after {} of {} bytes: {}", c[0], state.size(), found);
  });
  const std::vector<Block> flips = {{"byte", 1, 0.0, last, {0, 8, 16, 24, 32}, true}, {"flipped by", 1, 1.0, 255.0, {1, 128, 255}, true}};
  context.for_all(flips, context.cases(600), [&](Case c) {
    std::string bytes = state;
    bytes[static_cast<std::size_t>(std::min(c[0], last))] ^= static_cast<char>(c[1]);
    const std::string found = patient.swallow(bytes, true);
    return found.empty() ? "" : fmt::format("given its state with byte {} of {} flipped: {}", c[0], state.size(), found);
  });
  const std::vector<Block> sizes = {{"byte", 1, 0.0, std::min(last, 200.0), {}, true},
                                    {"bytes", 1, 1.0, 8.0, {4, 8}, true},
                                    {"written", 1, 0.0, 255.0, {127}, true}};
  context.for_all(sizes, context.cases(300), [&](Case c) {
    std::string bytes = state;
    const auto first = static_cast<std::size_t>(c[0]), count = std::min(static_cast<std::size_t>(c[1]), state.size() - first);
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(first), count, static_cast<char>(c[2]));
    const std::string found = patient.swallow(bytes, true);
    return found.empty() ? "" : fmt::format("given its state with {} bytes of {} from byte {} on: {}", count, c[2], first, found);
  });
}

void k13_copies(Context& context) {
  Random random = context.random("rows");
  const Lesson lesson = random_lesson(random, 10, 3, 2), other = random_lesson(random, 14, 3, 2);
  const RowMatrix questions = random_rows(random, 30, 3);
  const auto original = context.create<Classifier>(), copy = context.create<Classifier>();
  fit(*original, lesson);
  const RowMatrix before = predicted(*original, questions, 2);
  copy->load(original->save());
  fit(*copy, other);
  context.require(predicted(*original, questions, 2) == before, "a copy was fitted to other rows, and the original answers otherwise");
  copy->load(original->save());
  copy->extend(other.inputs, other.targets, 0, 1, nullptr);
  context.require(predicted(*original, questions, 2) == before, "a copy was extended, and the original answers otherwise");
}

}  // namespace preshape::conformance
