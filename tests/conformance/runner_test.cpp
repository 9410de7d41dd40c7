// How the suite runs checks, makes failures small and tells of them.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "conformance/report.h"
#include "preshape/base/error.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::conformance;

TEST_SUITE_BEGIN("conformance");

namespace {

const Subject kSubject{"/nowhere/none.so", "similarity", "none"};

Result in_child(void (*run)(Context&), double seconds = 20.0) {
  const Check check{"T01", "", "a check of the tests", run, "", Tier::kQuick, seconds};
  Child child(check, kSubject, {});
  while (!child.wait(20)) {}
  return child.result();
}

constexpr Block kTwo[] = {{"limit", 1, 0.0, 10.0}, {"weights", 3, -5.0, 5.0}};

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("Runner: a check passes, fails with its sentence, skips with its reason, or warns") {
  CHECK(in_child([](Context&) {}).outcome == Outcome::kPass);
  const Result failed = in_child([](Context& c) { c.fail("three is not {}", 4); });
  CHECK(failed.outcome == Outcome::kFail);
  CHECK(failed.text == "three is not 4");
  CHECK(in_child([](Context& c) { c.skip("nothing to see"); }).text == "nothing to see");
  CHECK(in_child([](Context& c) { c.warn("slow"); }).outcome == Outcome::kWarn);
  CHECK(in_child([](Context&) { throw InputError("bad"); }).text == "it threw \"bad\"");
  CHECK(in_child([](Context&) { throw 3; }).outcome == Outcome::kFail);
}

TEST_CASE("Runner: a crash is told by its signal, with the input that ran and what was printed") {
  const Result crashed = in_child([](Context& c) {
    c.for_all(kTwo, 10, [](Case numbers) -> std::string {
      if (numbers[0] == 10.0) {
        std::puts("so long");
        std::fflush(stdout);
        std::raise(SIGSEGV);
      }
      return "";
    });
  });
  CHECK(crashed.outcome == Outcome::kCrash);
  CHECK(has(crashed.text, "SIGSEGV"));
  CHECK(has(crashed.text, "input: limit = 10, weights = {5 5 5}"));
  CHECK(has(crashed.text, "it printed: so long"));
  CHECK(has(in_child([](Context&) { _exit(3); }).text, "status 3"));
}

TEST_CASE("Runner: a check that hangs is stopped at its limit, with every process that it started") {
  const std::string file = (std::filesystem::temp_directory_path() / ("conform-" + std::to_string(getpid()))).string();
  setenv("PRESHAPE_TEST_FILE", file.c_str(), 1);
  const Result hung = in_child(
      [](Context&) {
        if (fork() == 0) {
          // Nobody waits for this one; were it left alive it would write.
          std::this_thread::sleep_for(std::chrono::seconds(2));
          std::ofstream(std::getenv("PRESHAPE_TEST_FILE")) << "alive";
          _exit(0);
        }
        for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
      },
      0.3);
  CHECK(hung.outcome == Outcome::kTimeout);
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("Cases: one that breaks the property is made small, and told by its names") {
  const Result failed = in_child([](Context& c) {
    c.for_all(kTwo, 500, [](Case numbers) -> std::string {
      return numbers[0] > 2.0 && numbers[2] < -1.0 ? "it is broken" : "";
    });
  });
  CHECK(failed.outcome == Outcome::kFail);
  REQUIRE(has(failed.text, "it is broken\n    input: limit = "));
  // Nothing but what is needed is left: the other weights are 0, the two that matter have few digits.
  CHECK(has(failed.text, "weights = {0 -"));
  CHECK(failed.text.size() < 70);
}

TEST_CASE("Cases: an exception of the property breaks it, and the same seed gives the same cases") {
  const Result threw = in_child([](Context& c) {
    c.for_all(kTwo, 5, [](Case) -> std::string { throw InputError("no"); });
  });
  CHECK(has(threw.text, "it threw \"no\""));
  const Check check{"T02", "", "", nullptr};
  const auto numbers = [&](std::uint64_t seed) {
    Settings settings;
    settings.seed = seed;
    Context context(check, kSubject, settings, nullptr);
    std::vector<double> all;
    context.for_all(kTwo, 20, [&](Case c) -> std::string {
      all.insert(all.end(), c.begin(), c.end());
      return "";
    });
    return all;
  };
  CHECK(numbers(3) == numbers(3));
  CHECK(numbers(3) != numbers(4));
  for (const double x : numbers(3)) CHECK((x >= -5.0 && x <= 10.0));
}

TEST_CASE("Plan: unknown checks and those left out are refused with a reason, and tiers choose") {
  Plan plan;
  plan.only = {"S99"};
  CHECK_THROWS_SAYING(planned_checks(plan, "similarity"), InputError, "there is no check 'S99' of kind similarity");
  plan.only = {"G24"};
  CHECK_THROWS_SAYING(planned_checks(plan, "similarity"), InputError, "check G24 is left out: a property of the host");
  plan.only = {};
  const auto has_check = [&](const char* id) {
    const auto checks = planned_checks(plan, "similarity");
    return std::any_of(checks.begin(), checks.end(), [&](const Check* c) { return std::string_view(c->id) == id; });
  };
  CHECK_FALSE(has_check("G26"));
  plan.settings.tier = Tier::kFull;
  CHECK(has_check("G26"));
  CHECK_FALSE(has_check("C05"));
}

TEST_CASE("Checks: ids are unique, and none is both there and left out") {
  std::vector<std::string> ids;
  for (const Check& check : generic_checks()) ids.emplace_back(check.id);
  for (const auto kind : kKinds) {
    for (const Check& check : checks_of(kind)) {
      ids.emplace_back(check.id);
      CHECK(check.kind == kind);
    }
  }
  for (const LeftOut& left : left_out()) ids.emplace_back(left.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  CHECK_MESSAGE(twice == ids.end(), (twice == ids.end() ? "" : *twice));
}

TEST_CASE("Reports: JUnit tells every outcome and escapes what a component printed") {
  static const Check kPassing{"T01", "similarity", "it passes", nullptr}, kFailing{"T02", "similarity", "a < b & c", nullptr};
  ComponentReport report{kSubject, {{&kPassing, {Outcome::kPass, "", 0.5}}, {&kFailing, {Outcome::kCrash, "it said <\x01> \"hm\"", 0.25}}}};
  const std::string xml = junit_text({&report, 1}, {});
  CHECK(has(xml, "<testsuite name=\"similarity/none\" tests=\"2\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0.750\">"));
  CHECK(has(xml, "name=\"T02 a &lt; b &amp; c\""));
  CHECK(has(xml, "it said &lt;?&gt; &quot;hm&quot;"));
  CHECK(has(xml, "preshape conform /nowhere/none.so --component similarity/none --only T02 --seed 1 --in-process"));
  CHECK(has(json_text({&report, 1}, {}), "\"outcome\": \"crash\""));
  CHECK_FALSE(report.conforms());
}

TEST_SUITE_END();
