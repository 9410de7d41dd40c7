#pragma once

#include <functional>
#include <string>
#include <vector>

#include "child.h"

namespace preshape::conformance {

/// Which checks are run and how.
struct Plan {
  Settings settings;
  std::vector<std::string> only;  ///< ids; empty: all of the tier
  bool in_process = false;        ///< for a debugger
  int jobs = 1;                   ///< child processes at once
};

struct CheckReport {
  const Check* check = nullptr;
  Result result;
};

/// What became of one component.
struct ComponentReport {
  Subject subject;
  std::vector<CheckReport> checks;  ///< in the order of their ids
  bool conforms() const;
  int count(Outcome outcome) const;
};

/// The checks that a plan has for a kind: generic ones first. Checks named in `only` run in every tier.
/// @throws InputError when `only` names one that there is not
std::vector<const Check*> planned_checks(const Plan& plan, std::string_view kind);

/// Runs them. @param told of each as it ends; may be empty
ComponentReport run_suite(const Subject& subject, const Plan& plan,
                          const std::function<void(const CheckReport&)>& told = {});

/// "preshape conform lib.so --component contact/mine --only C05 --seed 1 --in-process"
std::string rerun_command(const Subject& subject, const Check& check, const Plan& plan);

}  // namespace preshape::conformance
