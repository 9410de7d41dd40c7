// What a component makes of its inputs.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "generic.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// How an attempt ended.
struct Ending {
  enum class How { kAnswered, kRefused, kForeign } how = How::kAnswered;
  std::string message;
  std::vector<double> numbers;
};

Ending ending_of(const Attempt& attempt) {
  try {
    return {Ending::How::kAnswered, "", attempt.run()};
  } catch (const Error& error) {
    return {Ending::How::kRefused, error.what(), {}};
  } catch (const std::exception& error) {
    return {Ending::How::kForeign, error.what(), {}};
  } catch (...) {
    return {Ending::How::kForeign, "(no std::exception)", {}};
  }
}

constexpr double kOddNumbers[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};

/// How often a call is made so that its time can be told, without spending long on a slow one.
int repeats_of(double seconds) {
  constexpr double kSpent = 0.05;
  return std::clamp(static_cast<int>(kSpent / std::max(seconds, 1e-9)), 1, 100);
}

double seconds_of(const Attempt& attempt, int repeats) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < repeats; ++i) ending_of(attempt);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

void g12_nonfinite(Context& context) {
  Specimen whole = specimen(context);
  const auto before = whole.use();
  const bool rejects = context.declares("rejects_nonfinite"), propagates = context.declares("propagates_nonfinite");
  for (const double number : kOddNumbers) {
    for (const Attempt& attempt : whole.probe.nonfinite(whole.component.get(), number)) {
      const Ending ending = ending_of(attempt);
      const bool answered = ending.how == Ending::How::kAnswered;
      context.require(!rejects || !answered, "{} is answered, though it promises to reject it", attempt.what);
      context.require(!propagates || !std::isnan(number) || !answered ||
                          std::any_of(ending.numbers.begin(), ending.numbers.end(), [](double x) { return std::isnan(x); }),
                      "{} gives numbers, though it promises to propagate it", attempt.what);
    }
  }
  const auto now = whole.use();
  context.require(same_bits(before, now), "after inputs that are not finite it answers otherwise: {}", difference(before, now));
}

void g13_wrong_sizes(Context& context) {
  Specimen whole = specimen(context);
  const auto before = whole.use();
  for (const Attempt& attempt : whole.probe.wrong_sizes(whole.component.get())) {
    const Ending ending = ending_of(attempt);
    context.require(ending.how != Ending::How::kAnswered, "{} is taken without a word; use require_size", attempt.what);
    for (const auto& part : attempt.named) {
      context.require(ending.message.find(part) != std::string::npos, "{} is refused by \"{}\", which does not name {}",
                      attempt.what, ending.message, part);
    }
  }
  const auto now = whole.use();
  context.require(same_bits(before, now), "after buffers of a wrong size it answers otherwise: {}", difference(before, now));
}

void g14_exceptions(Context& context) {
  Specimen whole = specimen(context);
  whole.use();
  std::vector<Attempt> attempts = whole.probe.wrong_sizes(whole.component.get());
  for (const double number : kOddNumbers) {
    for (auto& attempt : whole.probe.nonfinite(whole.component.get(), number)) attempts.push_back(std::move(attempt));
  }
  for (const Attempt& attempt : attempts) {
    const Ending ending = ending_of(attempt);
    context.require(ending.how != Ending::How::kForeign, "{} throws \"{}\", which is no preshape::Error", attempt.what,
                    ending.message);
    context.require(ending.how != Ending::How::kRefused || !ending.message.empty(), "{} is refused without a word", attempt.what);
  }
}

void g17_inputs(Context& context) {
  Specimen whole = specimen(context);
  whole.use();
  Arena first, second;
  const auto before = whole.probe.use_in(first, whole.component.get(), 11);
  first.release();
  const auto now = whole.probe.use_in(second, whole.component.get(), 11);
  second.release();
  context.require(same_bits(before, now), "asked again after its first inputs were released it answers otherwise: {}",
                  difference(before, now));
}

void g25_batches(Context& context) {
  Specimen whole = specimen(context);
  whole.use();
  for (const int count : {0, 1, 7, 1000}) {
    const auto answers = whole.probe.batch(whole.component.get(), count, 13);
    if (!answers) context.skip("its kind is asked one by one");
    context.require(same_bits(answers->singly, answers->together), "{} questions together are answered otherwise than one by one: {}",
                    count, difference(answers->singly, answers->together));
  }
}

void g27_subnormal(Context& context) {
  Specimen whole = specimen(context);
  whole.use();
  const auto plain = whole.probe.nonfinite(whole.component.get(), 0.25);
  const auto odd = whole.probe.nonfinite(whole.component.get(), 1e-310);
  for (std::size_t i = 0; i < odd.size(); ++i) {
    const int repeats = repeats_of(seconds_of(plain[i], 1));
    const double usual = std::max(seconds_of(plain[i], repeats), 1e-7 * repeats), slow = seconds_of(odd[i], repeats);
    // Both have to be slow: a busy machine makes one of two runs long.
    if (slow > 10.0 * usual && seconds_of(odd[i], repeats) > 10.0 * seconds_of(plain[i], repeats)) {
      context.warn(fmt::format("{} takes {:.0f} times as long as with plain numbers", odd[i].what, slow / usual));
    }
  }
}

}  // namespace preshape::conformance
