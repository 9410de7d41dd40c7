#include "runner.h"

#include <algorithm>
#include <memory>

#include "preshape/base/error.h"
#include "preshape/base/suggest.h"

namespace preshape::conformance {

namespace {

bool wanted(const Plan& plan, const Check& check) {
  if (plan.only.empty()) return check.tier <= plan.settings.tier;
  return std::find(plan.only.begin(), plan.only.end(), check.id) != plan.only.end();
}

/// Keeps `jobs` children at work and tells of each as it ends.
void run_children(const Subject& subject, const Plan& plan, std::vector<CheckReport>& reports,
                  const std::function<void(const CheckReport&)>& told) {
  struct Running {
    std::unique_ptr<Child> child;
    CheckReport* report;
  };
  std::vector<Running> running;
  std::size_t next = 0;
  while (next < reports.size() || !running.empty()) {
    while (next < reports.size() && std::ssize(running) < plan.jobs) {
      running.push_back({std::make_unique<Child>(*reports[next].check, subject, plan.settings), &reports[next]});
      ++next;
    }
    for (auto& [child, report] : running) {
      if (!child->wait(running.size() > 1 ? 2 : 20)) continue;
      report->result = child->result();
      if (told) told(*report);
      child.reset();
    }
    std::erase_if(running, [](const Running& r) { return !r.child; });
  }
}

}  // namespace

bool ComponentReport::conforms() const {
  return std::none_of(checks.begin(), checks.end(), [](const auto& c) { return is_bad(c.result.outcome); });
}

int ComponentReport::count(Outcome outcome) const {
  return static_cast<int>(
      std::count_if(checks.begin(), checks.end(), [&](const auto& c) { return c.result.outcome == outcome; }));
}

std::vector<const Check*> planned_checks(const Plan& plan, std::string_view kind) {
  std::vector<const Check*> checks;
  std::vector<std::string> ids;
  for (const auto list : {generic_checks(), checks_of(kind)}) {
    for (const Check& check : list) {
      ids.push_back(check.id);
      if (wanted(plan, check)) checks.push_back(&check);
    }
  }
  for (const auto& id : plan.only) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
    for (const LeftOut& left : left_out()) {
      if (id == left.id) throw InputError(fmt::format("check {} is left out: {}", id, left.reason));
    }
    throw InputError(fmt::format("there is no check '{}' of kind {}{}", id, kind, did_you_mean(id, ids)));
  }
  return checks;
}

ComponentReport run_suite(const Subject& subject, const Plan& plan,
                          const std::function<void(const CheckReport&)>& told) {
  ComponentReport report{subject, {}};
  for (const Check* check : planned_checks(plan, subject.kind)) report.checks.push_back({check, {}});
  if (!plan.in_process) {
    run_children(subject, plan, report.checks, told);
    return report;
  }
  for (auto& check : report.checks) {
    check.result = run_here(*check.check, subject, plan.settings, nullptr);
    if (told) told(check);
  }
  return report;
}

std::string rerun_command(const Subject& subject, const Check& check, const Plan& plan) {
  std::string command = fmt::format("preshape conform {} --component {} --only {} --seed {}", subject.file.string(),
                                    subject.title(), check.id, plan.settings.seed);
  static constexpr const char* kTiers[] = {"quick", "full", "soak"};
  if (plan.settings.tier != Tier::kQuick) {
    command += fmt::format(" --tier {}", kTiers[static_cast<int>(plan.settings.tier)]);
  }
  return command + " --in-process";
}

}  // namespace preshape::conformance
