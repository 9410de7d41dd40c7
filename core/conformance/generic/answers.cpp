// Whether a component's answers depend on nothing but what it is asked.
#include <latch>
#include <thread>

#include "../fresh_process.h"
#include "generic.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

class Listener final : public Progress {
 public:
  explicit Listener(bool stops) : stops_(stops) {}
  void advance(std::string_view, double, std::string_view) override {
    ++calls;
    if (stops_) throw InputError("stopped by the person");
  }
  int calls = 0;

 private:
  bool stops_;
};

}  // namespace

std::string g19_answers(Context& context, std::string_view) { return hex_text(specimen(context).use()); }

void g19_repeats(Context& context) {
  Specimen first = specimen(context);
  const auto before = first.use();
  const auto again = first.use();
  context.require(same_bits(before, again), "asked twice it answers otherwise: {}", difference(before, again));
  for (std::uint64_t other = 100; other < 105; ++other) first.use(other);
  const auto after = first.use();
  context.require(same_bits(before, after), "asked again after other questions it answers otherwise: {}", difference(before, after));
  const auto another = specimen(context).use();
  context.require(same_bits(before, another), "another component of it answers otherwise: {}", difference(before, another));
  context.require(context.in_fresh_process("") == hex_text(before), "in another process it answers otherwise");
}

void g20_instances(Context& context) {
  Random random = context.random("parameters");
  const Value one = context.parameters();
  for (int i = 0; i < context.cases(2); ++i) {
    const Value other = drawn_parameters(context, random);
    try {
      const auto one_alone = specimen(context, one).use(), other_alone = specimen(context, other).use();
      Specimen a = specimen(context, one), b = specimen(context, other);
      const auto other_beside = b.use(), one_beside = a.use();
      context.require(same_bits(one_alone, one_beside), "beside a component with the parameters {} one answers otherwise: {}",
                      other.text(), difference(one_alone, one_beside));
      context.require(same_bits(other_alone, other_beside), "with the parameters {} it answers otherwise beside another: {}",
                      other.text(), difference(other_alone, other_beside));
    } catch (const InputError&) {
      continue;  // parameters that do not go together
    }
  }
}

void g21_threads(Context& context) {
  Specimen whole = specimen(context);
  whole.use();
  const std::vector<double> serial[] = {whole.probe.use_const(whole.component.get(), 17),
                                        whole.probe.use_const(whole.component.get(), 18)};
  constexpr int kThreads = 8;
  const int rounds = context.cases(5);
  std::vector<std::string> found(kThreads);
  std::vector<std::thread> threads;
  std::latch begin(kThreads);
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      begin.arrive_and_wait();
      try {
        for (int i = 0; i < rounds && found[static_cast<std::size_t>(t)].empty(); ++i) {
          const auto& expected = serial[t % 2];
          const auto answers = whole.probe.use_const(whole.component.get(), 17 + static_cast<std::uint64_t>(t % 2));
          if (!same_bits(expected, answers)) found[static_cast<std::size_t>(t)] = difference(expected, answers);
        }
      } catch (const std::exception& error) {
        found[static_cast<std::size_t>(t)] = error.what();
      }
    });
  }
  for (auto& thread : threads) thread.join();
  for (const auto& text : found) context.require(text.empty(), "asked from {} threads at once it answers otherwise: {}", kThreads, text);
}

void g29_no_progress(Context& context) {
  Specimen silent = specimen(context), told = specimen(context);
  Listener listener(false);
  const auto answers = told.probe.use_told(told.component.get(), 7, listener);
  if (!answers) context.skip("its kind is given no service that could be absent");
  const auto alone = silent.use();
  context.require(same_bits(alone, *answers), "without anybody to tell its progress to it answers otherwise: {}",
                  difference(*answers, alone));
}

void g30_stopped(Context& context) {
  Specimen whole = specimen(context);
  const auto before = whole.use();
  Listener listener(true);
  try {
    if (!whole.probe.use_told(whole.component.get(), 7, listener)) context.skip("its kind has nothing that could be stopped");
    if (listener.calls > 0) context.fail("its progress was stopped by an exception, which it kept to itself");
  } catch (const InputError&) {
  }
  const auto now = whole.use();
  context.require(same_bits(before, now), "after it was stopped it answers otherwise: {}", difference(before, now));
}

}  // namespace preshape::conformance
