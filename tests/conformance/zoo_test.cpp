// The suite is tested by components that are broken on purpose: each fails its own check and no other.
#include <algorithm>
#include <cctype>
#include <thread>

#include "conformance/runner.h"
#include "support/data.h"

using namespace preshape;
using namespace preshape::conformance;

TEST_SUITE_BEGIN("conformance");

namespace {

const std::filesystem::path kZoo = std::filesystem::path(PRESHAPE_BINARY_DIR) / "tests/conformance/zoo";

std::vector<Subject> animals() {
  std::vector<Subject> all;
  for (const auto& entry : std::filesystem::directory_iterator(kZoo)) {
    if (entry.path().extension() != ".so") continue;
    for (auto& subject : subjects_in(entry.path())) all.push_back(std::move(subject));
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.title() < b.title(); });
  return all;
}

/// "S03" of "s03_asymmetric"; "" of a good one.
std::string broken_check(const Subject& subject) {
  if (subject.name.starts_with("good")) return "";
  std::string id = subject.name.substr(0, subject.name.find('_'));
  std::transform(id.begin(), id.end(), id.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return id;
}

Plan plan_for(const Subject& subject) {
  Plan plan;
  plan.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  plan.settings.command = std::filesystem::path(PRESHAPE_BINARY_DIR) / "bin/preshape";
  const std::string id = broken_check(subject);
  // The quick ones, and its own, which may be of a higher tier.
  std::vector<std::string> only;
  for (const Check* check : planned_checks(plan, subject.kind)) only.push_back(check->id);
  if (!id.empty() && std::find(only.begin(), only.end(), id) == only.end()) only.push_back(id);
  plan.only = only;
  return plan;
}

/// The checks with an outcome of a kind, in words.
std::string bad_checks(const ComponentReport& report, bool also_warnings) {
  std::string text;
  for (const auto& check : report.checks) {
    const bool told = is_bad(check.result.outcome) || (also_warnings && check.result.outcome == Outcome::kWarn);
    if (told) text += fmt::format("{} ({}): {}\n", check.check->id, outcome_name(check.result.outcome), check.result.text);
  }
  return text;
}

}  // namespace

TEST_CASE("Zoo: every broken component fails its own check and no other, every good one fails none") {
  const auto subjects = animals();
  REQUIRE(subjects.size() > 10);
  for (const Subject& subject : subjects) {
    INFO(subject.title());
    const std::string id = broken_check(subject);
    ComponentReport report = run_suite(subject, plan_for(subject));
    if (!id.empty()) {
      const auto own = std::find_if(report.checks.begin(), report.checks.end(), [&](const auto& c) { return c.check->id == id; });
      REQUIRE(own != report.checks.end());
      CHECK_MESSAGE((is_bad(own->result.outcome) || own->result.outcome == Outcome::kWarn),
                    "it passes ", id, ": ", outcome_name(own->result.outcome), " ", own->result.text);
      report.checks.erase(own);
    }
    CHECK_MESSAGE(bad_checks(report, false).empty(), bad_checks(report, false));
  }
}

TEST_CASE("Zoo: every check has a component that fails it") {
  std::vector<std::string> broken;
  for (const Subject& subject : animals()) broken.push_back(broken_check(subject));
  std::vector<std::span<const Check>> lists = {generic_checks()};
  for (const auto kind : kKinds) lists.push_back(checks_of(kind));
  for (const auto list : lists) {
    for (const Check& check : list) {
      INFO(std::string(check.id), ": ", std::string(check.property));
      CHECK(std::find(broken.begin(), broken.end(), check.id) != broken.end());
    }
  }
}

TEST_SUITE_END();
